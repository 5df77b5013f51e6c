package org.dronewatch.sensor.acoustic.energy;

import org.dronewatch.sound.Levels;

/**
 * Judges whether the rays traced so far tell a level, and how accurately. One per thread.
 *
 * <p>Where rays contribute little, a rare strong one may still change the level by more than all others, and the
 * scatter of a thousand rays does not show it if it is not among them. So the error allows for what one ray more may
 * contribute: as much as the strongest so far, and as much as paths of one scattering allow ({@link StrongestRay}).
 */
final class Convergence {
    /** If rays contribute less than this fraction of what is heard, a reading converges whatever their number. */
    private static final double INSIGNIFICANT = 0.1;

    /**
     * With fewer effective contributions than this, their scatter is not known, unless even the strongest is less than
     * the reciprocal of this of what is heard.
     */
    private static final double ENOUGH = 20.0;

    /** Where rays contribute little, they are traced until one more would change what is heard by less than this. */
    private static final double OF_ONE_RAY = 0.02;

    /** There they are also traced until there are this many effective contributions, or the error is negligible. */
    private static final double MORE_THAN_ENOUGH = 40.0;

    /** A standard error below this does not matter, dB. */
    private static final double NEGLIGIBLE = 0.02;

    /** Root mean square of a contribution that may be anything from 0 to 1. */
    private static final double ROOT_MEAN_SQUARE = 1.0 / Math.sqrt(3.0);

    private final EnergyTally tally;
    private final StrongestRay strongest;

    Convergence(EnergyTally tally, StrongestRay strongest) {
        this.tally = tally;
        this.strongest = strongest;
    }

    /**
     * Whether no more rays are needed. As long as none has contributed anything, the contribution of further rays is
     * unknown.
     *
     * @param quantity a band or {@link EnergyTally#A_WEIGHTED}
     * @param heard the sum of exact paths and rays, as intensity over the source's power, 1/m2
     * @param accuracy the standard error to be reached, dB
     */
    boolean isAccurate(int quantity, double heard, double accuracy) {
        return tally.received(quantity) > 0.0
                && error(quantity, heard) < accuracy
                && (isInsignificant(quantity, heard) ? hasShownAll(quantity, heard) : isEnough(quantity));
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
        double drawn = isInsignificant(quantity, heard)
                ? tally.standardErrorWithAnother(quantity)
                : tally.standardError(quantity);
        double missed = Math.min(strongest.scatteredOnce(quantity) / tally.rays(), OF_ONE_RAY * heard);
        return Levels.ofRatio(1.0 + Math.max(drawn, missed * ROOT_MEAN_SQUARE) / heard);
    }

    /**
     * Whether the level does not stand on a few rays. Where nothing is heard at all, rays may have missed the only
     * path: silence is not known.
     *
     * @param heard the sum of exact paths and rays
     */
    boolean isReached(int quantity, double heard) {
        return heard > 0.0
                && (isInsignificant(quantity, heard)
                        || isEnough(quantity)
                        || tally.strongest(quantity) * ENOUGH <= heard);
    }

    private boolean isEnough(int quantity) {
        return tally.effectiveRays(quantity) >= ENOUGH;
    }

    private boolean isInsignificant(int quantity, double heard) {
        return tally.received(quantity) <= INSIGNIFICANT * heard;
    }

    /** Whether rays that contribute little would hardly contribute more if more of them were traced. */
    private boolean hasShownAll(int quantity, double heard) {
        return strongest.scatteredOnce(quantity) <= OF_ONE_RAY * heard * tally.rays()
                && (error(quantity, heard) < NEGLIGIBLE || tally.effectiveRays(quantity) >= MORE_THAN_ENOUGH);
    }
}
