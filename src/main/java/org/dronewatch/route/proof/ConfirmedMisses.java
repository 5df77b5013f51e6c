package org.dronewatch.route.proof;

import org.dronewatch.fusion.Confirmation;

/**
 * The probability that independent looks have not confirmed a contact yet, look by look: a Markov chain over the
 * outcomes of the most recent looks.
 */
final class ConfirmedMisses {
    /** The greatest number of looks of a confirmation: with n looks there are 2^(n - 1) states. */
    static final int MOST_LOOKS = 12;

    private final Confirmation confirmation;

    /** By the outcomes of the last n - 1 looks, the latest in the lowest bit: their probability, unconfirmed. */
    private double[] chances;

    ConfirmedMisses(Confirmation confirmation) {
        this.confirmation = confirmation;
        this.chances = new double[1 << confirmation.looks() - 1];
        this.chances[0] = 1.0;
    }

    /**
     * Takes another look.
     *
     * @param probability probability that this look detects the drone
     * @return the probability that the contact has not been confirmed up to then
     */
    double after(double probability) {
        double[] next = new double[chances.length];
        double left = 0.0;
        for (int state = 0; state < chances.length; state++) {
            if (chances[state] > 0.0) {
                int missed = state << 1 & chances.length - 1;
                next[missed] += (1.0 - probability) * chances[state];
                left += (1.0 - probability) * chances[state];
                if (Integer.bitCount(state) + 1 < confirmation.hits()) {
                    int hit = (state << 1 | 1) & chances.length - 1;
                    next[hit] += probability * chances[state];
                    left += probability * chances[state];
                }
            }
        }
        chances = next;
        return left;
    }
}
