package org.dronewatch.placement.site;

import java.util.List;

/**
 * The best layouts for several budgets: each costs more than the one before, and covers more.
 *
 * @param points in ascending order of cost, at least one; the last is that for the whole budget
 * @param complete whether each search ended by itself
 */
public record BudgetFront(List<FrontPoint> points, boolean complete) {
    /** Copies the list. */
    public BudgetFront {
        points = List.copyOf(points);
    }

    /** The layout for the whole budget. */
    public SitePlacement best() {
        return points.get(points.size() - 1).layout();
    }
}
