package org.dronewatch.placement.site;

import java.util.List;

/**
 * The best layouts for several budgets: each costs more than the one before, and is worth more.
 *
 * @param <L> a layout on some objective
 * @param points in ascending order of cost, at least one; the last is that for the whole budget
 * @param complete whether each search ended by itself
 */
public record BudgetFront<L extends PlacedLayout>(List<FrontPoint<L>> points, boolean complete) {
    /** Copies the list. */
    public BudgetFront {
        points = List.copyOf(points);
    }

    /** The layout for the whole budget. */
    public L best() {
        return points.get(points.size() - 1).layout();
    }
}
