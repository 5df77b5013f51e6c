package org.dronewatch.sensor.acoustic.energy;

import org.dronewatch.sound.Levels;

/**
 * Judges whether the rays traced so far determine a level, and how accurately. For use by one thread.
 *
 * <p>A rare strong ray may change a level by more than all others, and the scatter of a thousand rays does not show it
 * if it is not among them. So the error includes an allowance for such a ray ({@link MissedRays}). Where rays
 * contribute little, the contribution of the rays that were drawn does not limit the allowance, unless the missed ray
 * would be weak anyway: the rays that were drawn contribute little precisely if the strong ones were missed. For the
 * same reason, as long as a missed ray would be appreciable, a look does not end merely because the rays that were
 * drawn contribute little and scatter little, unless there are very many of them. The constants are chosen so that
 * looks drawn at random from 150,000 recorded rays at each of 50 pairs of positions, in both directions, keep to their
 * stated errors.
 */
final class Convergence {
    /**
     * If rays contribute no more than this fraction of the sound heard, a reading counts as converged whatever their
     * number.
     */
    private static final double INSIGNIFICANT = 0.15;

    /**
     * If rays contribute no more than this fraction, the first rays suffice, unless an appreciable ray may have been
     * missed.
     */
    private static final double HARDLY_ANYTHING = 0.01;

    /** A ray that contributes more than this fraction of the sound heard is appreciable. */
    private static final double APPRECIABLE_RAY = 0.1;

    /** In an enclosed space, no ray that happens to pass may contribute more than this fraction of what is heard. */
    private static final double STRONG_PASSING = 0.01;

    /**
     * With fewer effective contributions than this, their scatter does not count as known, unless even the strongest
     * contribution is no more than the sound heard divided by this number.
     */
    private static final double ENOUGH = 20.0;

    /**
     * The number of rays that must be traced if the straight path leads through walls; and also if rays contribute
     * between {@link #HARDLY_ANYTHING} and {@link #INSIGNIFICANT}, or nothing so far.
     */
    private static final double SEVERAL_THOUSAND = 3000.0;

    /**
     * The number of effective contributions that suffice, together with {@link #SEVERAL_THOUSAND} rays, if no
     * appreciable ray may have been missed and rays contribute between {@link #HARDLY_ANYTHING} and
     * {@link #INSIGNIFICANT}.
     */
    private static final double MORE_THAN_ENOUGH = 40.0;

    /** The number of effective contributions that suffice in any case: many small contributions, from all around. */
    private static final double PLENTY = 200.0;

    /**
     * Twice {@link #PLENTY} are needed if rays contribute less than this fraction: a few strong rays would then change
     * the level more.
     */
    private static final double APPRECIABLE = 0.05;

    /** A ray that may have been missed is not taken to contribute more than this fraction of the sound heard. */
    private static final double MOST_MISSED = 0.02;

    /**
     * A missed ray that would contribute less than this fraction of the sound heard is weak; if many rays contribute,
     * it is limited by {@link #MISSED_OF_MANY} instead of {@link #MOST_MISSED}.
     */
    private static final double WEAK = 0.01;

    /**
     * A {@link #WEAK} missed ray is not taken to contribute more than this fraction of the contribution of all rays, if
     * these are many.
     */
    private static final double MISSED_OF_MANY = 0.1;

    /**
     * If rays contribute much, a missed ray of at most the fraction {@link #WEAK} is added to their scatter, but the
     * error is at least that caused by this fraction of the missed ray or, if that is less, by {@link #LEAST_OF_MUCH}.
     */
    private static final double LEAST_MISSED = 0.7;

    /**
     * The error is at least that caused by a ray with this fraction of the contribution of all rays, or by
     * {@link #LEAST_MISSED} if that is less.
     */
    private static final double LEAST_OF_MUCH = 0.3;

    /** Root mean square of a contribution that may be anything from 0 to 1. */
    private static final double ROOT_MEAN_SQUARE = 1.0 / Math.sqrt(3.0);

    /** The smallest error that is stated if few rays contribute and there is anything that may have been missed, dB. */
    private static final double LEAST_ERROR = 0.005;

    /**
     * The relative error with which several thousand rays determine their contribution, however little they scatter; it
     * is limited by {@link #MOST_OFF}.
     */
    private static final double RELATIVE_ERROR = 0.046;

    /**
     * An upper limit on the error that {@link #RELATIVE_ERROR} gives for the contribution of rays, as a fraction of the
     * sound heard; less if more than {@link #HUNDREDS} effective contributions were drawn.
     */
    private static final double MOST_OFF = 0.0035;

    /**
     * Above this number of effective contributions, {@link #MOST_OFF} decreases with the square root of their number.
     */
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
     * Whether no more rays are needed. If nothing is heard at all, the contribution of further rays is unknown.
     *
     * @param quantity a band or {@link EnergyTally#A_WEIGHTED}
     * @param heard the sum of exact paths and rays, as intensity over the source's power, 1/m2
     * @param accuracy the standard error to be reached by the rays that were drawn, dB
     */
    boolean isAccurate(int quantity, double heard, double accuracy) {
        return heard > 0.0
                && hasPassedWalls()
                && tally.rays() * STRONG_PASSING * heard >= missed.passing(quantity)
                && drawnError(quantity, heard) < accuracy
                && (isInsignificant(quantity, heard) ? hasShownMost(quantity, heard) : isEnough(quantity));
    }

    /**
     * The error due to the rays that were drawn alone, without any allowance, dB; infinity as long as nothing is heard.
     *
     * @param heard the sum of exact paths and rays
     */
    double drawnError(int quantity, double heard) {
        return heard > 0.0 ? Levels.ofRatio(1.0 + tally.standardError(quantity) / heard) : Double.POSITIVE_INFINITY;
    }

    /**
     * The number of rays that must be traced so that a missed ray is no longer appreciable; fewer may suffice.
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

    /** The error if rays contribute much, dB. */
    private static double errorOfMuch(double heard, double received, double drawn, double one) {
        double ofRays = Math.hypot(drawn, Math.min(one, WEAK * heard) * ROOT_MEAN_SQUARE);
        double least = Math.min(LEAST_MISSED * one, LEAST_OF_MUCH * received) * ROOT_MEAN_SQUARE;
        return Levels.ofRatio(1.0 + Math.max(ofRays, least) / heard);
    }

    /** The error if rays contribute little, dB. */
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
     * Whether the level rests on more than a few rays. If nothing is heard at all, rays may have missed the only path,
     * so silence is not certain.
     *
     * @param heard the sum of exact paths and rays
     */
    boolean isReached(int quantity, double heard) {
        return heard > 0.0
                && (isInsignificant(quantity, heard)
                        || hasPassedWalls() && (isEnough(quantity) || tally.strongest(quantity) * ENOUGH <= heard));
    }

    /**
     * Whether there are enough rays for some to have passed the walls on the straight path, if there are any such
     * walls.
     */
    private boolean hasPassedWalls() {
        return !isThroughWalls || tally.rays() >= SEVERAL_THOUSAND;
    }

    private boolean isEnough(int quantity) {
        return tally.effectiveRays(quantity) >= ENOUGH;
    }

    private boolean isInsignificant(int quantity, double heard) {
        return tally.received(quantity) <= INSIGNIFICANT * heard;
    }

    /** Whether rays that contribute little would hardly contribute more if further ones were traced. */
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
