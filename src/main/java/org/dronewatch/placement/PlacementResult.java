package org.dronewatch.placement;

import java.util.List;

/**
 * The best layout that was found, and how much better, at most, another could be.
 *
 * @param chosen indices of the chosen candidates, ascending
 * @param value value of the objective
 * @param bound a bound on the value: no layout has a better one
 * @param cost sum of the costs
 * @param complete whether the search ran to completion: no layout is better by more than the gap that was asked for
 */
public record PlacementResult(List<Integer> chosen, double value, double bound, double cost, boolean complete) {
    /** Copies the list. */
    public PlacementResult {
        chosen = List.copyOf(chosen);
    }

    /** The difference between bound and value as a fraction of the value; 0 if they are equal. */
    public double gap() {
        double difference = Math.abs(bound - value);
        return difference == 0.0 ? 0.0 : difference / Math.abs(value);
    }
}
