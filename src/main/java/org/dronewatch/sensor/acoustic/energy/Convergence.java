package org.dronewatch.sensor.acoustic.energy;

import org.dronewatch.sound.Levels;

/**
 * Judges whether the rays traced so far determine a level, and how accurately. For use by one thread.
 *
 * <p>A rare strong ray may change a level by more than all others, and the scatter of a thousand rays does not show it
 * if it is not among them. So the error includes an allowance for such a ray ({@link MissedRays}). Where rays
 * contribute little, what those that were drawn contribute does not limit the allowance, unless the ray would be weak
 * anyway: they contribute little precisely if the strong ones were missed. For the same reason, as long as such a ray
 * would be appreciable, a look does not end because those that were drawn contribute little and scatter little, unless
 * they are very many. The constants are chosen so that looks drawn at random from 150,000 recorded rays at each of 50
 * pairs of places, in both directions, keep to their stated errors.
 */
final class Convergence {
    /** If rays contribute less than this fraction of what is heard, a reading converges whatever their number. */
    private static final double INSIGNIFICANT = 0.15;

    /** If they contribute less than this, the first rays suffice, unless an appreciable ray may have been missed. */
    private static final double HARDLY_ANYTHING = 0.01;

    /** A ray that contributes more than this fraction of what is heard is appreciable. */
    private static final double APPRECIABLE_RAY = 0.1;

    /** In an enclosed space, no ray that happens to pass may contribute more than this fraction of what is heard. */
    private static final double STRONG_PASSING = 0.01;

    /**
     * With fewer effective contributions than this, their scatter is not known, unless even the strongest is less than
     * the reciprocal of this of what is heard.
     */
    private static final double ENOUGH = 20.0;

    /**
     * Where the straight path leads through walls, this many rays must be traced. Also where rays contribute between
     * {@link #HARDLY_ANYTHING} and {@link #INSIGNIFICANT}, or nothing so far, ...
     */
    private static final double SEVERAL_THOUSAND = 3000.0;

    /** ... and make this many effective contributions, which suffice if no appreciable ray may have been missed, ... */
    private static final double MORE_THAN_ENOUGH = 40.0;

    /** ... or else this many: many small contributions, from all around. */
    private static final double PLENTY = 200.0;

    /** Twice as many where rays contribute less than this fraction: a few strong ones would change it more. */
    private static final double APPRECIABLE = 0.05;

    /** A ray that may have been missed is not taken to contribute more than this fraction of what is heard. */
    private static final double MOST_MISSED = 0.02;

    /** Where it would contribute less than this fraction of what is heard, and many rays contribute, ... */
    private static final double WEAK = 0.01;

    /** ... it is not taken to contribute more than this fraction of what they do. */
    private static final double MISSED_OF_MANY = 0.1;

    /**
     * Where rays contribute much, at most a {@link #WEAK} ray is added to their scatter, but the error is not below
     * what a ray of this fraction of the missed one would cause, ...
     */
    private static final double LEAST_MISSED = 0.7;

    /** ... or, if that is less, one of this fraction of what they contribute. */
    private static final double LEAST_OF_MUCH = 0.3;

    /** Root mean square of a contribution that may be anything from 0 to 1. */
    private static final double ROOT_MEAN_SQUARE = 1.0 / Math.sqrt(3.0);

    /** Where few contribute, the smallest error that is stated if there is anything to be missed, dB. */
    private static final double LEAST_ERROR = 0.005;

    /** How accurately several thousand rays determine what they contribute, however little they scatter ... */
    private static final double RELATIVE_ERROR = 0.046;

    /** ... but this fraction of what is heard is the most that they are taken to be off, ... */
    private static final double MOST_OFF = 0.0035;

    /** ... or less where more than this many effective contributions were drawn. */
    private static final double HUNDREDS = 150.0;

    private final EnergyTally tally;
    private final MissedRays missed;
    private boolean isThroughWalls;

    Convergence(EnergyTally tally, MissedRays missed) {
        this.tally = tally;
        this.missed = missed;
    }

    /**
     * Prepares for one look.
     *
     * @param throughWalls whether the straight path leads through walls that transmit sound: of a thousand rays, none
     *     may pass such a wall, and each that does contributes more than many others, however little the wall transmits
     */
    void begin(boolean throughWalls) {
        isThroughWalls = throughWalls;
    }

    /**
     * Whether no more rays are needed. Where nothing is heard at all, the contribution of further rays is unknown.
     *
     * @param quantity a band or {@link EnergyTally#A_WEIGHTED}
     * @param heard the sum of exact paths and rays, as intensity over the source's power, 1/m2
     * @param accuracy the standard error of the rays that were drawn to be reached, dB
     */
    boolean isAccurate(int quantity, double heard, double accuracy) {
        return heard > 0.0
                && hasPassedWalls()
                && tally.rays() * STRONG_PASSING * heard >= missed.passing(quantity)
                && drawnError(quantity, heard) < accuracy
                && (isInsignificant(quantity, heard) ? hasShownMost(quantity, heard) : isEnough(quantity));
    }

    /**
     * The error of the rays that were drawn alone, dB; infinity as long as nothing is heard.
     *
     * @param heard the sum of exact paths and rays
     */
    double drawnError(int quantity, double heard) {
        return heard > 0.0 ? Levels.ofRatio(1.0 + tally.standardError(quantity) / heard) : Double.POSITIVE_INFINITY;
    }

    /**
     * How many rays must be traced for one that was missed not to be appreciable: fewer may suffice.
     *
     * @param heard the sum of exact paths and rays, greater than 0
     */
    double mostNeeded(int quantity, double heard) {
        return Math.max(missed.contribution(quantity) / APPRECIABLE_RAY, missed.passing(quantity) / STRONG_PASSING)
                / heard;
    }

    /**
     * Standard error of the level so far, dB; infinity as long as nothing is heard.
     *
     * @param heard the sum of exact paths and rays
     */
    double error(int quantity, double heard) {
        if (!(heard > 0.0)) {
            return Double.POSITIVE_INFINITY;
        }
        double received = tally.received(quantity);
        double drawn = tally.standardError(quantity);
        double one = missed.contribution(quantity) / tally.rays();
        return isInsignificant(quantity, heard)
                ? errorOfLittle(quantity, heard, received, drawn, one)
                : errorOfMuch(heard, received, drawn, one);
    }

    /** Where rays contribute much. */
    private static double errorOfMuch(double heard, double received, double drawn, double one) {
        double ofRays = Math.hypot(drawn, Math.min(one, WEAK * heard) * ROOT_MEAN_SQUARE);
        double least = Math.min(LEAST_MISSED * one, LEAST_OF_MUCH * received) * ROOT_MEAN_SQUARE;
        return Levels.ofRatio(1.0 + Math.max(ofRays, least) / heard);
    }

    /** Where rays contribute little. */
    private double errorOfLittle(int quantity, double heard, double received, double drawn, double one) {
        double most = MOST_MISSED * heard;
        if (one < WEAK * heard && !areFew(quantity)) {
            most = MISSED_OF_MANY * received;
        }
        double notDrawn = Math.min(one, most) * ROOT_MEAN_SQUARE;
        double mostOff = MOST_OFF * heard * Math.min(1.0, Math.sqrt(HUNDREDS / tally.effectiveRays(quantity)));
        double systematic = Math.min(received * RELATIVE_ERROR * Math.sqrt(SEVERAL_THOUSAND / tally.rays()), mostOff);
        double ofRays = Math.hypot(Math.hypot(drawn, systematic), notDrawn);
        boolean isMissing = areFew(quantity) && one > 0.0;
        return Math.hypot(Levels.ofRatio(1.0 + ofRays / heard), isMissing ? LEAST_ERROR : 0.0);
    }

    private boolean areFew(int quantity) {
        return tally.effectiveRays(quantity) < MORE_THAN_ENOUGH;
    }

    /**
     * Whether the level rests on more than a few rays. Where nothing is heard at all, rays may have missed the only
     * path: silence is not known.
     *
     * @param heard the sum of exact paths and rays
     */
    boolean isReached(int quantity, double heard) {
        return heard > 0.0
                && (isInsignificant(quantity, heard)
                        || hasPassedWalls() && (isEnough(quantity) || tally.strongest(quantity) * ENOUGH <= heard));
    }

    /** Whether there are enough rays for some to have passed the walls of the straight path, if there are any. */
    private boolean hasPassedWalls() {
        return !isThroughWalls || tally.rays() >= SEVERAL_THOUSAND;
    }

    private boolean isEnough(int quantity) {
        return tally.effectiveRays(quantity) >= ENOUGH;
    }

    private boolean isInsignificant(int quantity, double heard) {
        return tally.received(quantity) <= INSIGNIFICANT * heard;
    }

    /** Whether rays that contribute little would hardly contribute more if more of them were traced. */
    private boolean hasShownMost(int quantity, double heard) {
        double received = tally.received(quantity);
        double effective = tally.effectiveRays(quantity);
        if (effective >= (received < APPRECIABLE * heard ? 2.0 * PLENTY : PLENTY)) {
            return true;
        }
        if (tally.rays() < mostNeeded(quantity, heard)) {
            return false;
        }
        return received > 0.0 && received <= HARDLY_ANYTHING * heard
                || tally.rays() >= SEVERAL_THOUSAND && !(received > 0.0)
                || tally.rays() >= SEVERAL_THOUSAND && effective >= MORE_THAN_ENOUGH;
    }
}
