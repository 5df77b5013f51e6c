package org.dronewatch.placement.site;

import java.util.List;
import java.util.Optional;

/**
 * The best layouts for several budgets: each costs more than the one before, and is worth more.
 *
 * @param <L> a layout for some objective
 * @param points the layouts in ascending order of cost, at least one; the last is the one for the whole budget
 * @param tried the budgets that were tried, also those without a better layout
 * @param complete whether each search ran to completion
 * @param stopped what the time limit has stopped; empty if each search is complete, or was interrupted
 */
public record BudgetFront<L extends PlacedLayout>(
        List<FrontPoint<L>> points, TriedBudgets tried, boolean complete, Optional<TimeStop> stopped) {
    /** Copies the list. */
    public BudgetFront {
        points = List.copyOf(points);
    }

    /** Layouts of searches that no time limit has stopped. */
    public BudgetFront(List<FrontPoint<L>> points, TriedBudgets tried, boolean complete) {
        this(points, tried, complete, Optional.empty());
    }

    /** Whether a search was interrupted before it was complete. */
    public boolean isInterrupted() {
        return !complete && stopped.isEmpty();
    }

    /** The layout for the whole budget. */
    public L best() {
        return points.get(points.size() - 1).layout();
    }
}
