package org.dronewatch.route.proof;

import org.dronewatch.statistics.Proportion;

/**
 * A predicted probability, and the proportion of runs in which the event occurred.
 *
 * @param predicted predicted probability of the event, the mean over all runs, 0 to 1
 * @param error standard error of the prediction, due to looks that are estimated with random rays; 0 if there are none
 * @param flown proportion of the runs in which the event occurred
 */
public record ProvenChance(double predicted, double error, Proportion flown) {
    /** The confidence of the interval. */
    public static final double CONFIDENCE = 0.99;

    /** A prediction of exactly 0 or 1 may be off by rounding. */
    private static final double ROUNDING = 1e-12;

    /** The Wilson interval for the probability, with a confidence of 99 %. */
    public Proportion.Interval interval() {
        return flown.wilson(CONFIDENCE);
    }

    /** Whether the prediction lies in the Wilson {@linkplain #interval interval} of the runs. */
    public boolean isInInterval() {
        return predicted >= interval().low() - ROUNDING
                && predicted <= interval().high() + ROUNDING;
    }

    /**
     * Whether the prediction lies in the Wilson {@linkplain #interval interval} of the runs, or is
     * {@linkplain #isPlausible plausible} with a confidence of 99 %.
     */
    public boolean agrees() {
        return isInInterval() || isPlausible(CONFIDENCE);
    }

    /**
     * Whether the exact confidence interval of the runs overlaps that of the prediction, whose error is taken to be
     * normally distributed. An exact interval is used because, where fewer than one occurrence is expected, a single
     * one is less unlikely than the Wilson interval implies.
     *
     * @param confidence confidence of each interval, above 0 and below 1
     */
    public boolean isPlausible(double confidence) {
        double mayBeOff = error * Proportion.normal(confidence);
        double nearest = Math.max(predicted - mayBeOff, Math.min(predicted + mayBeOff, flown.share()));
        return flown.isPlausible(Math.max(0.0, Math.min(1.0, nearest)), confidence);
    }
}
