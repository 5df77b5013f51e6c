package org.dronewatch.placement.site;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.DoubleFunction;
import java.util.function.IntConsumer;
import org.dronewatch.placement.SolverLimits;

/**
 * Finds the best layouts for lower budgets, which show what more money buys.
 *
 * @param <L> a layout for some objective
 */
public final class FrontSearch<L extends PlacedLayout> {
    /** Maximum number of budgets. */
    public static final int MOST = 12;

    private final CheaperLayouts<L> layouts;
    private final L best;
    private final DoubleFunction<String> text;

    /** A search in which values count as different even if they differ by very little. */
    public FrontSearch(CheaperLayouts<L> layouts) {
        this(layouts, Double::toString);
    }

    /**
     * A search whose values are printed.
     *
     * @param text converts a value to the text that is printed; of several layouts whose values are printed alike, the
     *     cheapest is kept
     */
    public FrontSearch(CheaperLayouts<L> layouts, DoubleFunction<String> text) {
        this.layouts = layouts;
        this.best = layouts.best();
        this.text = text;
    }

    /**
     * Finds a layout for each budget on the {@link org.dronewatch.parallel.Workers} of the calling thread; the result
     * does not depend on the number of workers, unless the searches are stopped.
     *
     * @param budgets maximum number of budgets, including the whole budget, 1 to {@link #MOST}; budgets for which no
     *     layout complies with the conditions do not count
     * @param progress receives 1 for each budget; from any thread
     */
    public BudgetFront<L> found(int budgets, SolverLimits limits, IntConsumer progress) {
        BudgetTrials<L> trials = new BudgetTrials<>(layouts, limits, progress);
        boolean isCancelled = false;
        try {
            if (best.complete()) {
                trials.run(budgets - 1);
            }
        } catch (CancellationException e) {
            isCancelled = true;
        }
        List<L> found = new ArrayList<>(trials.found().values());
        List<Double> asked = new ArrayList<>(trials.found().keySet());
        boolean isCheaperWhole = best.complete() && !isCancelled && trials.isWhole();
        found.add(best);
        asked.add(best.plan().settings().budget());
        List<FrontPoint<L>> points = points(bounded(found), asked, trials.nothing(), limits);
        boolean isWhole =
                isCheaperWhole && points.get(points.size() - 1).layout().complete();
        boolean isOutOfTime =
                !isWhole && !limits.end().isStopped() && limits.end().isTimeOver();
        Optional<TimeStop> stopped = isOutOfTime
                ? Optional.of(new TimeStop(
                        limits.end().seconds(), limits.gap(), best.result().complete(), budgets > 1 && !isCheaperWhole))
                : Optional.empty();
        return new BudgetFront<>(points, trials.tried(), isWhole, stopped);
    }

    /** A bound for more money holds for less, too. */
    private List<L> bounded(List<L> found) {
        List<L> bounded = new ArrayList<>(found);
        L tightest = best;
        for (int at = found.size() - 1; at >= 0; at--) {
            L layout = found.get(at);
            tightest = layout.bound() < tightest.bound() ? layout : tightest;
            bounded.set(at, layouts.bounded(layout, tightest.result().bound()));
        }
        return bounded;
    }

    /** The points without layouts that, as printed, are worth no more than a cheaper one, or than buying nothing. */
    private List<FrontPoint<L>> points(List<L> found, List<Double> budgets, Optional<L> nothing, SolverLimits limits) {
        double atLeast = nothing.map(PlacedLayout::value).orElse(0.0);
        List<FrontPoint<L>> points = new ArrayList<>();
        for (int at = 0; at < found.size(); at++) {
            Optional<L> before = points.isEmpty()
                    ? Optional.empty()
                    : Optional.of(points.get(points.size() - 1).layout());
            boolean isLast = at == found.size() - 1;
            L layout = found.get(at);
            double least = before.map(PlacedLayout::value).orElse(atLeast);
            boolean isCompared = before.isPresent() || nothing.isPresent() && !isLast;
            boolean isAlike = isCompared && text.apply(layout.value()).equals(text.apply(least));
            if (!isAlike && layouts.isBetter(layout, least, limits)) {
                points.add(point(budgets.get(at), before, layout));
            } else if (before.isEmpty() && isLast) {
                L free = nothing.map(its -> layouts.bounded(its, layout.result().bound()))
                        .orElse(layout);
                points.add(point(budgets.get(at), before, free));
            } else if (isLast) {
                points.set(points.size() - 1, closing(points.get(points.size() - 1), layout));
            }
        }
        FrontPoint<L> last = points.get(points.size() - 1);
        points.set(points.size() - 1, last.with(layouts.described(last.layout())));
        return points;
    }

    /** A cheaper layout that is as good as the one for the whole budget takes its place. */
    private FrontPoint<L> closing(FrontPoint<L> cheaper, L whole) {
        return new FrontPoint<>(
                whole.plan().settings().budget(),
                layouts.bounded(cheaper.layout(), whole.result().bound()),
                cheaper.added(),
                cheaper.removed(),
                cheaper.gain());
    }

    private FrontPoint<L> point(double budget, Optional<L> before, L layout) {
        List<Integer> had = before.map(cheaper -> cheaper.result().chosen()).orElseGet(() -> kept(layout));
        List<Integer> has = layout.result().chosen();
        return new FrontPoint<>(
                budget,
                layout,
                names(layout, without(has, had)),
                names(layout, without(had, has)),
                layouts.gain(before, layout));
    }

    /** The numbers of the sensors that are kept. */
    static List<Integer> kept(PlacedLayout layout) {
        return layout.result().chosen().stream()
                .filter(number ->
                        layout.plan().candidates().get(number).candidate().fixed())
                .toList();
    }

    private static List<Integer> without(List<Integer> all, List<Integer> some) {
        return all.stream().filter(number -> !some.contains(number)).toList();
    }

    private static List<String> names(PlacedLayout layout, List<Integer> numbers) {
        return numbers.stream()
                .map(number -> layout.plan().candidates().get(number).name())
                .toList();
    }
}
