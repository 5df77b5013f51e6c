package org.dronewatch.placement.route;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.CancellationException;
import java.util.function.IntConsumer;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.parallel.Workers;
import org.dronewatch.placement.PlacementConditions;
import org.dronewatch.placement.PlacementSolver;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.plan.PlanConditions;
import org.dronewatch.placement.plan.SiteCandidate;
import org.dronewatch.placement.site.CheaperLayouts;
import org.dronewatch.placement.site.SectorGain;
import org.dronewatch.placement.solver.CuttingPlanes;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Quantity;

/**
 * Finds the layouts of a plan that are best against the weakest routes past them, once all candidates have been
 * assessed: for the whole budget and, starting from the routes that were found for it, for lower budgets. Not
 * thread-safe.
 */
public final class RouteLayouts {
    /** The greatest number of times that layouts are compared again because flights have revealed further routes. */
    public static final int MOST_COMPARED = 20;

    private final PlacePlan plan;
    private final RouteRows rows;
    private final RouteFigures figures;
    private final CuttingPlanes planes;

    RouteLayouts(PlacePlan plan, FieldGrid grid, RouteRows rows, PlacementSolver solver) {
        this.plan = plan;
        this.rows = rows;
        this.figures = new RouteFigures(plan, grid, rows);
        this.planes = new CuttingPlanes(
                plan.candidates().stream().map(SiteCandidate::candidate).toList(),
                conditions(),
                rows,
                solver,
                WeakestRouteSearch.ENOUGH);
    }

    private PlacementConditions conditions() {
        PlacementConditions conditions = PlanConditions.of(plan);
        return plan.settings()
                .conditions()
                .anyoneLost()
                .map(loss ->
                        conditions.withAnyoneLost(Math.min(WeakestRouteSearch.ENOUGH, -Math.log1p(-loss.fraction()))))
                .orElse(conditions);
    }

    /**
     * The best layout that is found; if this thread is interrupted, the best of those tried so far, and the interrupt
     * status is kept.
     *
     * @param round receives the number of layouts that have been tried so far
     * @throws InputException when no layout complies with the conditions, or there is no route
     * @throws CancellationException when this thread is interrupted before the first layout has been tried
     */
    public RoutePlacement found(SolverLimits limits, IntConsumer round) {
        return figures.of(planes.solve(limits, round).orElseThrow(() -> limits.none(this::impossible)));
    }

    private InputException impossible() {
        return PlanConditions.impossible(
                plan,
                plan.settings()
                        .conditions()
                        .anyoneLost()
                        .map(loss -> "a probability of detection of " + Quantity.NUMBER.inWords(loss.fraction())));
    }

    /**
     * Adds routes that this search has not found itself, such as those that allow for what flights have shown. They are
     * routes in the scene as it is; from now on, layouts are compared on them as well.
     *
     * @throws CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public void learn(List<SectorRoute> found) {
        rows.learn(found);
    }

    /**
     * Whether the figures of a layout still hold for all routes that are known by now; if not, {@link #found} may find
     * a better layout.
     *
     * @throws CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public boolean holds(RoutePlacement layout) {
        return figures.holds(layout) && survivesLosses(layout.result().chosen());
    }

    private boolean survivesLosses(List<Integer> chosen) {
        OptionalDouble needed = conditions().anyoneLost();
        return needed.isEmpty()
                || chosen.stream().allMatch(lost -> {
                    List<Integer> rest = RouteFigures.losses(plan).remaining(chosen, lost);
                    return rows.value(rest) >= (1.0 - RouteFigures.ROUNDING) * needed.getAsDouble();
                });
    }

    /**
     * The search for cheaper layouts.
     *
     * @param best the layout for the whole budget that was found
     */
    public CheaperLayouts<RoutePlacement> cheaper(RoutePlacement best) {
        return new Cheaper(best);
    }

    /** Layouts for less money, searched for one by one, since each search knows the routes found before it. */
    private final class Cheaper implements CheaperLayouts<RoutePlacement> {
        private final RoutePlacement best;

        Cheaper(RoutePlacement best) {
            this.best = best;
        }

        @Override
        public RoutePlacement best() {
            return best;
        }

        @Override
        public Optional<RoutePlacement> within(double budget, SolverLimits limits) {
            return planes.within(budget).solve(limits, round -> {}).map(figures::inBrief);
        }

        /**
         * {@inheritDoc} Exposures are those on the routes found, so that a difference smaller than the gap may not be
         * real.
         */
        @Override
        public boolean isBetter(RoutePlacement layout, double value, SolverLimits limits) {
            return layout.value() > (1.0 + limits.gap()) * value;
        }

        @Override
        public RoutePlacement bounded(RoutePlacement layout, double bound) {
            return layout.within(bound);
        }

        @Override
        public RoutePlacement described(RoutePlacement layout) {
            return best.complete() && layout.parts().alone().isEmpty()
                    ? figures.withParts(layout.countedAs(best))
                    : layout;
        }

        @Override
        public void forEach(int budgets, IntConsumer action) {
            for (int budget = budgets - 1; budget >= 0; budget--) {
                Workers.checkInterrupted();
                action.accept(budget);
            }
        }

        /**
         * {@inheritDoc} The gain is that in the direction from which the drone was least likely to be detected before;
         * in a tie, in the one from which the most is gained.
         */
        @Override
        public Optional<SectorGain> gain(Optional<RoutePlacement> before, RoutePlacement after) {
            if (before.isEmpty()) {
                return Optional.empty();
            }
            Map<Integer, Double> has = new HashMap<>();
            past(after).forEach(one -> has.merge(one.sector(), detection(one), Math::min));
            List<DirectedRoute> had = new ArrayList<>(past(before.get()));
            had.removeIf(one -> !has.containsKey(one.sector()));
            List<Double> heights = after.grid().heights();
            return had.stream()
                    .min(Comparator.comparingDouble(Cheaper::detection)
                            .thenComparingDouble(one -> -has.get(one.sector())))
                    .filter(one -> has.get(one.sector()) > detection(one))
                    .map(one -> new SectorGain(
                            one.bearing(),
                            heights.get(0),
                            heights.get(heights.size() - 1),
                            detection(one),
                            has.get(one.sector())));
        }

        private List<DirectedRoute> past(RoutePlacement layout) {
            return rows.pastCandidates(layout.result().chosen());
        }

        private static double detection(DirectedRoute one) {
            return RoutePlacement.detection(one.exposure());
        }
    }
}
