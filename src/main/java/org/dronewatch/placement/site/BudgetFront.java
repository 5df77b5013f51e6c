package org.dronewatch.placement.site;

import java.util.List;
import java.util.Optional;
import org.dronewatch.placement.SolverLimits;

/**
 * The best layouts for several budgets: each costs more than the one before, and has a better value.
 *
 * @param <L> a layout for some objective
 * @param points the layouts in ascending order of cost, at least one; the last is the one for the whole budget
 * @param tried the budgets that were tried, including those without a better layout
 * @param complete whether each search ran to completion, and nothing else was cut short by a time limit
 * @param stopped what the time limit has stopped; empty if it stopped nothing, or a search was interrupted
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

    /**
     * These layouts, marked as lacking a part that the time limit cut short.
     *
     * @param limits limits of the searches
     */
    public BudgetFront<L> without(LeftOut part, SolverLimits limits) {
        TimeStop stop = stopped.orElseGet(() -> new TimeStop(limits.end().seconds(), limits.gap(), true, false));
        return new BudgetFront<>(points, tried, false, Optional.of(stop.with(part)));
    }

    /** Whether the time limit has cut a part short, or prevented it. */
    public boolean isWithout(LeftOut part) {
        return stopped.filter(stop -> stop.leftOut().contains(part)).isPresent();
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
