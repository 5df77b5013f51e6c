package org.dronewatch.route.proof;

import org.dronewatch.sensor.Assessment;

/**
 * The probability of a look: exact, or the mean of several estimates, each with other random rays.
 *
 * @param count number of estimates; 0 if the probability is exact
 * @param sum sum of the estimates, or the exact probability
 * @param margins sum of the margins of a level over its threshold, dB
 * @param squares sum of their squares, dB2
 * @param isLevel whether each estimate is a level, which is either above the threshold or below it
 */
record RayEstimate(int count, double sum, double margins, double squares, boolean isLevel) {
    /** A level this many standard errors or fewer from its threshold may be on the other side of it with other rays. */
    private static final double STANDARD_ERRORS = 8.0;

    /**
     * So may a level at most this far from it, dB, if it depends on random rays at all: a rare ray that arrives in one
     * look of a thousand raises the level by more than the standard errors that other looks state.
     */
    private static final double RARE_RAY = 0.5;

    /** The number of traces in one estimate by the level model, each of which either detects the drone or does not. */
    private static final double TRACES = 32.0;

    /** A probability that depends on no random rays. */
    static RayEstimate exact(double probability) {
        return new RayEstimate(0, probability, 0.0, 0.0, false);
    }

    /** The first estimate of a look, if it depends on its rays; otherwise its exact probability. */
    static RayEstimate first(Assessment look) {
        double error = look.standardError();
        boolean isNear = error > 0.0 && Math.abs(look.margin()) < Math.max(STANDARD_ERRORS * error, RARE_RAY);
        return isNear || look.probabilityError() > 0.0 ? one(look) : exact(look.probability());
    }

    /** One estimate of a look that depends on its rays. */
    static RayEstimate one(Assessment look) {
        double margin = look.margin();
        boolean isLevel = look.probabilityError() == 0.0;
        return new RayEstimate(1, look.probability(), margin, margin * margin, isLevel);
    }

    /** All estimates of both. */
    RayEstimate and(RayEstimate other) {
        return new RayEstimate(
                count + other.count, sum + other.sum, margins + other.margins, squares + other.squares, isLevel);
    }

    /** Whether other rays may give another probability. */
    boolean isRandom() {
        return count > 0;
    }

    /**
     * The probability, 0 to 1: the mean of the estimates. Of several levels, it is above 0 and below 1 even if none of
     * them has reached the threshold, or all have.
     */
    double probability() {
        double mean = isRandom() ? sum / count : sum;
        boolean isAll = mean >= 1.0;
        return isLevel && count > 1 && (isAll || mean <= 0.0) ? Math.abs((isAll ? 1.0 : 0.0) - other()) : mean;
    }

    /**
     * The probability that a level is on the other side of the threshold if none of the estimates is: the value given
     * by Laplace's rule of succession, or less if the levels are far from the threshold. Rare rays make them so skewed
     * that their tail is about exponential, not normal.
     */
    private double other() {
        double mean = margins / count;
        double deviation = Math.sqrt(Math.max(0.0, squares / count - mean * mean));
        double succession = 1.0 / (count + 2.0);
        // If no ray has arrived in some, no deviation is known.
        return deviation > 0.0 ? Math.min(succession, 0.5 * Math.exp(-Math.abs(mean) / deviation)) : succession;
    }

    /** The variance of one estimate; that of the level model counts as 0 where no trace differs from the others. */
    double variance() {
        double probability = probability();
        return !isRandom() ? 0.0 : isLevel ? probability * (1.0 - probability) : ofTraces(probability);
    }

    /** The variance of one estimate of a probability by the level model. */
    static double ofTraces(double probability) {
        return probability * (1.0 - probability) / TRACES;
    }

    /** The mean of some estimates by the level model if a single one of their traces detects the drone. */
    static double ofOneTrace(double estimates) {
        return 1.0 / (TRACES * estimates);
    }
}
