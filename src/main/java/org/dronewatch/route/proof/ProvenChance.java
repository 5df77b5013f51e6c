package org.dronewatch.route.proof;

import org.dronewatch.statistics.Proportion;

/**
 * A predicted probability, and the proportion of runs in which the event occurred.
 *
 * @param predicted mean probability of all runs, 0 to 1
 * @param flown proportion of the runs
 */
public record ProvenChance(double predicted, Proportion flown) {
    /** The confidence of the interval. */
    public static final double CONFIDENCE = 0.99;

    /** A prediction of exactly 0 or 1 may be off by rounding. */
    private static final double ROUNDING = 1e-12;

    /** The Wilson interval for the probability, with a confidence of 99 %. */
    public Proportion.Interval interval() {
        return flown.wilson(CONFIDENCE);
    }

    /** Whether the prediction lies in this interval. */
    public boolean isInInterval() {
        return predicted >= interval().low() - ROUNDING
                && predicted <= interval().high() + ROUNDING;
    }

    /**
     * Whether the prediction lies in this interval or in the exact one: if less than one case is expected, a single one
     * is less rare than the Wilson interval implies.
     */
    public boolean agrees() {
        return isInInterval() || flown.isPlausible(predicted, CONFIDENCE);
    }
}
