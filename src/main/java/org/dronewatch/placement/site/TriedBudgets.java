package org.dronewatch.placement.site;

import java.util.List;

/**
 * The budgets for which layouts were sought.
 *
 * @param count their number, including the whole budget, 1 or more
 * @param infeasible those for which no layout complies with the conditions, ascending
 * @param all whether each sum of prices below the cost of the best layout was tried, or is less than a budget that is
 *     known to be infeasible: then no other budget buys anything better
 */
public record TriedBudgets(int count, List<Double> infeasible, boolean all) {
    /** Copies the list. */
    public TriedBudgets {
        infeasible = List.copyOf(infeasible);
    }
}
