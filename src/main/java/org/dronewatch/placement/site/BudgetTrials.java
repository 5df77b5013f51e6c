package org.dronewatch.placement.site;

import java.util.ArrayList;
import java.util.List;
import java.util.NavigableMap;
import java.util.NavigableSet;
import java.util.Optional;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.ConcurrentSkipListSet;
import java.util.function.IntConsumer;
import java.util.stream.Stream;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.plan.SiteCandidate;

/**
 * Tries budgets below that of a layout. Where conditions can only be met with more money, the cheapest budget that
 * suffices is found by bisection, and the others are spread above it. As many budgets are tried as are allowed, if
 * there are that many sums of prices.
 *
 * @param <L> a layout for some objective
 */
final class BudgetTrials<L extends PlacedLayout> {
    private final CheaperLayouts<L> layouts;
    private final double limit;
    private final NavigableSet<Double> sums;
    private final SolverLimits limits;
    private final IntConsumer progress;
    private final NavigableMap<Double, L> found = new ConcurrentSkipListMap<>();
    private final NavigableSet<Double> infeasible = new ConcurrentSkipListSet<>();

    /** The budgets that are to be tried, or have been tried, and have no answer so far. */
    private final NavigableSet<Double> unknown = new ConcurrentSkipListSet<>();

    private volatile boolean isStopped;
    private Optional<L> nothing = Optional.empty();

    /**
     * Budgets that are to be tried.
     *
     * @param progress receives 1 for each budget with a layout; from any thread
     */
    BudgetTrials(CheaperLayouts<L> layouts, SolverLimits limits, IntConsumer progress) {
        this.layouts = layouts;
        this.limit = layouts.best().result().cost();
        this.sums = BudgetSteps.sums(
                limit,
                layouts.best().plan().candidates().stream()
                        .map(SiteCandidate::candidate)
                        .toList());
        this.limits = limits;
        this.progress = progress;
    }

    /**
     * Tries budgets on the {@link org.dronewatch.parallel.Workers} of the calling thread.
     *
     * @param most greatest number of budgets with a layout
     * @throws java.util.concurrent.CancellationException when this thread is interrupted; its interrupt status is kept
     */
    void run(int most) {
        attempt(BudgetSteps.spread(sums, limit, most));
        if (!infeasible.isEmpty() && !isStopped) {
            cheapest();
        }
        if (!found.isEmpty() && !isStopped) {
            // Where one sensor is dear and others are cheap, few sums are near evenly spaced budgets.
            List<Double> had = new ArrayList<>(found.keySet());
            had.add(limit);
            had.add(infeasible.isEmpty() ? Double.valueOf(0.0) : infeasible.last());
            attempt(BudgetSteps.between(sums, had, most - found.size()));
        }
        if (limit > 0.0 && !isStopped) {
            nothing = unlessStopped(0.0);
        }
    }

    private void attempt(List<Double> budgets) {
        unknown.addAll(budgets);
        layouts.forEach(
                budgets.size(), at -> within(budgets.get(at)).ifPresent(layout -> add(budgets.get(at), layout)));
    }

    private void add(double budget, L layout) {
        found.put(budget, layout);
        progress.accept(1);
    }

    /** The best layout; if there is none, the budget counts as infeasible unless the search was stopped. */
    private Optional<L> within(double budget) {
        unknown.add(budget);
        Optional<L> layout = unlessStopped(budget);
        if (layout.isEmpty() && !isStopped) {
            infeasible.add(budget);
        }
        if (layout.isPresent() || infeasible.contains(budget)) {
            unknown.remove(budget);
        }
        return layout;
    }

    /** The best layout; empty if there is none, or the search is stopped. */
    private Optional<L> unlessStopped(double budget) {
        Optional<L> layout = limits.end().isDue() ? Optional.empty() : layouts.within(budget, limits);
        if (layout.isEmpty() && limits.end().isDue()) {
            isStopped = true;
        }
        return layout;
    }

    /** What suffices at a lower budget suffices at a higher one, too. */
    private void cheapest() {
        double high = found.isEmpty() ? limit : found.firstKey();
        List<Double> between = List.copyOf(sums.subSet(infeasible.last(), false, high, false));
        Optional<L> cheapest = Optional.empty();
        int from = 0;
        int to = between.size();
        while (from < to && !isStopped) {
            int middle = (from + to) >>> 1;
            Optional<L> layout = within(between.get(middle));
            cheapest = layout.isPresent() ? layout : cheapest;
            to = layout.isPresent() ? middle : to;
            from = layout.isPresent() ? from : middle + 1;
        }
        if (cheapest.isPresent()) {
            add(between.get(to), cheapest.get());
        }
    }

    /** The layout that costs nothing; empty if it does not comply with the conditions, or was not sought. */
    Optional<L> nothing() {
        return nothing;
    }

    /** The layouts by the budgets for which they were sought. */
    NavigableMap<Double, L> found() {
        return found;
    }

    /** What was tried besides the whole budget. */
    TriedBudgets tried() {
        boolean isEach = BudgetSteps.isWhole(sums)
                && sums.stream()
                        .allMatch(sum -> found.containsKey(sum) || !infeasible.isEmpty() && sum <= infeasible.last());
        return new TriedBudgets(
                1 + found.size() + infeasible.size(), List.copyOf(infeasible), List.copyOf(unknown), isEach);
    }

    /** Whether each budget has its answer, and the search for each layout ran to completion. */
    boolean isWhole() {
        return !isStopped
                && unknown.isEmpty()
                && Stream.concat(found.values().stream(), nothing.stream()).allMatch(PlacedLayout::complete);
    }
}
