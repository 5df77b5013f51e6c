package org.dronewatch.placement;

/**
 * The objective of a placement: what is maximised or minimised. With k-fold conditions, the k-th best of the chosen
 * candidates counts in a row.
 */
public enum PlacementObjective {
    /**
     * The greatest sum, over the rows, of weight times the best value of a chosen candidate; 0 where none reaches the
     * row. With values of 1, it is the covered weight.
     */
    COVERED_WEIGHT(true),
    /**
     * The same sum over each group of rows, such as the cells under one weather condition: the greatest of the least
     * such sum.
     */
    LEAST_COVERED_WEIGHT(true),
    /**
     * The greatest sum, over the rows, of weight times the probability that any chosen candidate detects: 1 - prod(1 -
     * p). Values are probabilities, capped at 1 - 1e-6.
     */
    JOINT_PROBABILITY(true),
    /**
     * The least sum, over the rows, of weight times the least impact of a chosen candidate: the p-median. Where none
     * detects, the impact is that of the row.
     */
    MEAN_IMPACT(false),
    /** The least possible value of the greatest impact in any row, whatever the weights: the p-centre. */
    WORST_IMPACT(false),
    /** The greatest sum of values in the row where this sum is least, whatever the weights. */
    WEAKEST_ROW(true);

    private final boolean isGreatest;

    PlacementObjective(boolean isGreatest) {
        this.isGreatest = isGreatest;
    }

    /** Whether greater values are better. */
    public boolean isGreatest() {
        return isGreatest;
    }

    /** Whether values are impacts, of which less is better. */
    public boolean isImpact() {
        return this == MEAN_IMPACT || this == WORST_IMPACT;
    }

    /** Whether the candidate with the best value alone counts in a row, so that k-fold conditions make sense. */
    public boolean takesBest() {
        return this == COVERED_WEIGHT || this == LEAST_COVERED_WEIGHT || isImpact();
    }
}
