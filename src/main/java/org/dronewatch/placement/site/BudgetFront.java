package org.dronewatch.placement.site;

import java.util.List;

/**
 * The best layouts for several budgets: each costs more than the one before, and is worth more.
 *
 * @param <L> a layout for some objective
 * @param points the layouts in ascending order of cost, at least one; the last is the one for the whole budget
 * @param tried the budgets that were tried, also those without a better layout
 * @param complete whether each search ran to completion
 */
public record BudgetFront<L extends PlacedLayout>(List<FrontPoint<L>> points, TriedBudgets tried, boolean complete) {
    /** Copies the list. */
    public BudgetFront {
        points = List.copyOf(points);
    }

    /** The layout for the whole budget. */
    public L best() {
        return points.get(points.size() - 1).layout();
    }
}
