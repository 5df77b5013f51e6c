package org.dronewatch.placement.site;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.function.IntConsumer;
import org.dronewatch.parallel.Workers;
import org.dronewatch.placement.PlacementConditions;
import org.dronewatch.placement.PlacementProblem;
import org.dronewatch.placement.PlacementResult;
import org.dronewatch.placement.PlacementSolver;
import org.dronewatch.placement.SolverLimits;

/** Finds the best layouts for lower budgets, which show what more money buys. */
public final class FrontSearch {
    /** Maximum number of budgets. */
    public static final int MOST = 12;

    private final CoveredCells cells;
    private final PlacementSolver solver;

    /**
     * A search.
     *
     * @param cells in which the candidates were assessed
     */
    public FrontSearch(CoveredCells cells, PlacementSolver solver) {
        this.cells = cells;
        this.solver = solver;
    }

    /**
     * Solves for each budget on the {@link Workers} of the calling thread; the same for any number of them.
     *
     * @param best layout for the whole budget
     * @param budgets greatest number of budgets, including the whole, 1 to {@link #MOST}
     * @param progress receives 1 for each budget; from any thread
     */
    public BudgetFront found(SitePlacement best, int budgets, SolverLimits limits, IntConsumer progress) {
        List<Double> lower = BudgetSteps.below(
                best.result().cost(), budgets - 1, best.problem().table().candidates());
        AtomicReferenceArray<PlacementResult> results = new AtomicReferenceArray<>(lower.size());
        boolean isWhole = best.complete();
        try {
            Workers.forEach(isWhole ? lower.size() : 0, at -> {
                solved(best.problem(), lower.get(at), limits).ifPresent(result -> results.set(at, result));
                progress.accept(1);
            });
        } catch (CancellationException e) {
            isWhole = false;
        }
        List<SitePlacement> layouts = new ArrayList<>();
        List<Double> asked = new ArrayList<>();
        for (int at = 0; at < lower.size(); at++) {
            PlacementResult result = results.get(at);
            if (result != null) {
                layouts.add(best.with(result));
                asked.add(lower.get(at));
                isWhole &= result.complete();
            }
        }
        layouts.add(best);
        asked.add(best.plan().settings().budget());
        return new BudgetFront(points(layouts, asked), isWhole);
    }

    private Optional<PlacementResult> solved(PlacementProblem problem, double budget, SolverLimits limits) {
        PlacementConditions conditions = problem.conditions().withBudget(budget);
        return solver.solve(new PlacementProblem(problem.table(), problem.objective(), conditions), limits);
    }

    /** Without layouts that cover nothing or that a cheaper one equals; a bound for more money holds for less, too. */
    private List<FrontPoint> points(List<SitePlacement> layouts, List<Double> budgets) {
        double[] bounds = new double[layouts.size()];
        double least = Double.POSITIVE_INFINITY;
        for (int at = layouts.size() - 1; at >= 0; at--) {
            least = Math.min(least, layouts.get(at).result().bound());
            bounds[at] = least;
        }
        List<FrontPoint> points = new ArrayList<>();
        AirSectors sectors = new AirSectors(cells);
        for (int at = 0; at < layouts.size(); at++) {
            SitePlacement before =
                    points.isEmpty() ? null : points.get(points.size() - 1).layout();
            boolean isLast = at == layouts.size() - 1;
            SitePlacement bounded = layouts.get(at).within(bounds[at]);
            boolean isBetter = before == null
                    ? bounded.value() > 0.0
                    : bounded.result().value() > before.result().value();
            if (isBetter || before == null && isLast) {
                points.add(point(budgets.get(at), before, bounded, sectors));
            } else if (isLast) {
                points.set(points.size() - 1, closing(points.get(points.size() - 1), bounded));
            }
        }
        return points;
    }

    /** A cheaper layout that is as good as the one for the whole budget takes its place. */
    private static FrontPoint closing(FrontPoint cheaper, SitePlacement whole) {
        return new FrontPoint(
                whole.plan().settings().budget(),
                cheaper.layout().within(whole.result().bound()),
                cheaper.added(),
                cheaper.removed(),
                cheaper.gain());
    }

    private static FrontPoint point(double budget, SitePlacement before, SitePlacement layout, AirSectors sectors) {
        List<Integer> had = before == null ? fixed(layout) : before.result().chosen();
        List<Integer> has = layout.result().chosen();
        return new FrontPoint(
                budget,
                layout,
                names(layout, without(has, had)),
                names(layout, without(had, has)),
                sectors.gain(layout.problem(), had, has));
    }

    private static List<Integer> fixed(SitePlacement layout) {
        return layout.result().chosen().stream()
                .filter(number ->
                        layout.plan().candidates().get(number).candidate().fixed())
                .toList();
    }

    private static List<Integer> without(List<Integer> all, List<Integer> some) {
        return all.stream().filter(number -> !some.contains(number)).toList();
    }

    private static List<String> names(SitePlacement layout, List<Integer> numbers) {
        return numbers.stream()
                .map(number -> layout.plan().candidates().get(number).name())
                .toList();
    }
}
