package org.dronewatch.placement;

/**
 * The objective of a placement: what is maximised or minimised. If the {@linkplain PlacementConditions#fold fold} is k,
 * the value of a row (a cell, flight or route to be covered) is the k-th best value among the chosen candidates.
 */
public enum PlacementObjective {
    /**
     * The greatest sum, over the rows, of weight times the best value of any chosen candidate, which is 0 where none
     * reaches the row. If all values are 1, the sum is the covered weight.
     */
    COVERED_WEIGHT(true),
    /**
     * The greatest possible value of the least covered weight of any group of rows, such as the cells under one weather
     * condition. The sum over a group is that of {@link #COVERED_WEIGHT}.
     */
    LEAST_COVERED_WEIGHT(true),
    /**
     * The greatest sum, over the rows, of weight times the probability that at least one chosen candidate detects the
     * drone: {@code 1 - prod(1 - p)}, where the values p are probabilities, capped at 1 - 1e-6.
     */
    JOINT_PROBABILITY(true),
    /**
     * The least sum, over the rows, of weight times the least impact of any chosen candidate: the p-median. Where none
     * detects anything, the impact is the one stated for the row.
     */
    MEAN_IMPACT(false),
    /** The least possible value of the greatest impact in any row, whatever the weights: the p-centre. */
    WORST_IMPACT(false),
    /**
     * The greatest possible value of the least sum, in any row, of the values of all chosen candidates, whatever the
     * weights.
     */
    WEAKEST_ROW(true);

    private final boolean isGreatest;

    PlacementObjective(boolean isGreatest) {
        this.isGreatest = isGreatest;
    }

    /** Whether greater values are better. */
    public boolean isGreatest() {
        return isGreatest;
    }

    /** Whether values are impacts, so that smaller ones are better. */
    public boolean isImpact() {
        return this == MEAN_IMPACT || this == WORST_IMPACT;
    }

    /**
     * Whether the value of a row is the best value of any chosen candidate, so that a
     * {@linkplain PlacementConditions#fold fold} above 1 makes sense.
     */
    public boolean takesBest() {
        return this == COVERED_WEIGHT || this == LEAST_COVERED_WEIGHT || isImpact();
    }
}
