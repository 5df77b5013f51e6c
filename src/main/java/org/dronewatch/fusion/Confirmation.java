package org.dronewatch.fusion;

import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * The confirmation required of a sensor before its detections count: a minimum number of detections in its most recent
 * looks.
 *
 * @param hits number of looks that must detect the drone, 1 to 100
 * @param looks number of most recent looks considered, not fewer than hits, 1 to 100
 */
public record Confirmation(
        @In(value = Quantity.NUMBER, from = 1, to = 100) int hits,
        @In(value = Quantity.NUMBER, from = 1, to = 100) int looks) {
    /** One detection is enough. */
    public static final Confirmation DEFAULT = new Confirmation(1, 1);

    /** Checks the limits. */
    public Confirmation {
        Limits.check(Confirmation.class, hits, looks);
        if (hits > looks) {
            throw new IllegalArgumentException("hits " + hits + " must be at most looks " + looks);
        }
    }

    /**
     * The probability that the most recent looks confirm a contact, if each detects it with the same probability p,
     * independently of the others: the upper tail of the binomial distribution, {@code sum over k from hits to looks of
     * C(looks, k) p^k (1-p)^(looks-k)}. With 3 of 5 looks, 0.9 becomes 0.99144, and 0.001 becomes 9.985e-9.
     *
     * @param ofOneLook the probability p that a look detects the contact, 0 to 1
     */
    public double probability(double ofOneLook) {
        double sum = 0.0;
        for (int k = hits; k <= looks; k++) {
            sum += binomial(looks, k, ofOneLook);
        }
        return Math.min(1.0, sum);
    }

    /**
     * The probability that a look confirms a contact that was not confirmed at the look before: this look is a hit,
     * exactly {@code hits - 1} of the {@code looks - 1} looks before it were hits, and the look before those was a
     * miss. It is {@code C(looks-1, hits-1) p^hits (1-p)^(looks-hits+1)}, where C is the binomial coefficient.
     *
     * @param ofOneLook the probability p that a look detects the contact, independently of the others, 0 to 1
     */
    public double onset(double ofOneLook) {
        return ofOneLook * (1.0 - ofOneLook) * binomial(looks - 1, hits - 1, ofOneLook);
    }

    /** {@code C(n, k) p^k (1-p)^(n-k)}. */
    private static double binomial(int n, int k, double p) {
        double ways = 1.0;
        for (int i = 1; i <= k; i++) {
            ways *= (double) (n - k + i) / i;
        }
        return ways * Math.pow(p, k) * Math.pow(1.0 - p, n - k);
    }
}
