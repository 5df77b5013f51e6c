package org.dronewatch.placement.site;

import java.util.List;

/**
 * The budgets for which layouts were sought.
 *
 * @param count number of budgets for which the search has an answer, including the whole budget, 1 or more
 * @param infeasible budgets for which no layout complies with the conditions, ascending
 * @param unknown further budgets for which the search was stopped before it found a layout: whether one complies is not
 *     known; ascending
 * @param all whether each sum of prices below the cost of the best layout was tried, or is less than a budget that is
 *     known to be infeasible: then no other budget buys anything better
 */
public record TriedBudgets(int count, List<Double> infeasible, List<Double> unknown, boolean all) {
    /** Copies the lists. */
    public TriedBudgets {
        infeasible = List.copyOf(infeasible);
        unknown = List.copyOf(unknown);
    }

    /** The budgets of a search that was not stopped. */
    public TriedBudgets(int count, List<Double> infeasible, boolean all) {
        this(count, infeasible, List.of(), all);
    }
}
