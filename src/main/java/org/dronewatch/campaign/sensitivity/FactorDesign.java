package org.dronewatch.campaign.sensitivity;

/**
 * A choice of factor values at which a function is evaluated, so that the influence of each factor can be estimated.
 * Evaluations come in groups. Within a group each factor has one of two values, the first or the second. Immutable and
 * thread-safe.
 */
public sealed interface FactorDesign permits SaltelliDesign, MorrisDesign {
    /** The number of factors. */
    int factors();

    /** The number of groups. */
    int base();

    /** The number of evaluations in each group. */
    int groupSize();

    /** Whether a factor has its second value in an evaluation. */
    boolean isSecond(int evaluation, int factor);

    /**
     * The value of a factor in an evaluation, given as its cumulative probability in the factor's distribution, 0 or
     * more and below 1.
     *
     * @param evaluation number of the evaluation, from 0, below {@link #size()}
     */
    double quantile(int evaluation, int factor);

    /** The number of all evaluations. */
    default int size() {
        return Math.multiplyExact(base(), groupSize());
    }

    /** The group of an evaluation. */
    default int group(int evaluation) {
        return evaluation / groupSize();
    }

    /** Random numbers that depend on nothing but the arguments. */
    @FunctionalInterface
    interface Uniform01 {
        /**
         * A number of 0 or more and below 1.
         *
         * @param isSecond whether the number is for the second value of the factor
         */
        double draw(int group, int factor, boolean isSecond);
    }
}
