package org.dronewatch.placement.route;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.placement.PlacementProblem;
import org.dronewatch.placement.PlacementResult;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.site.BuyingOrder;
import org.dronewatch.placement.site.PlaceStep;
import org.dronewatch.placement.site.PresentLayout;
import org.dronewatch.placement.solver.CutResult;

/** What is stated about a layout that was found: routes are searched for past each part of it. */
final class RouteFigures {
    private final PlacePlan plan;
    private final FieldGrid grid;
    private final RouteRows rows;

    RouteFigures(PlacePlan plan, FieldGrid grid, RouteRows rows) {
        this.plan = plan;
        this.grid = grid;
        this.rows = rows;
    }

    /** The figures; without those of parts of the layout and of the scene if this thread is interrupted. */
    RoutePlacement of(CutResult cut) {
        return withParts(inBrief(cut), cut);
    }

    /** Without the figures of parts of the layout and of the scene. */
    RoutePlacement inBrief(CutResult cut) {
        PlacementResult found = cut.result();
        // These routes have been searched for already.
        List<DirectedRoute> past = rows.pastCandidates(found.chosen());
        Map<Optional<String>, Double> values = rows.values(found.chosen());
        double value = values.values().stream().mapToDouble(Double::doubleValue).reduce(found.value(), Math::min);
        double lower =
                past.stream().mapToDouble(one -> one.route().lower()).min().orElse(0.0);
        Map<String, Double> byCondition = new LinkedHashMap<>();
        plan.conditions().forEach(one -> byCondition.put(one.name(), values.get(Optional.of(one.name()))));
        return new RoutePlacement(
                plan,
                grid,
                new PlacementResult(found.chosen(), value, found.bound(), found.cost(), found.complete()),
                past.get(0),
                Math.min(lower, value),
                values.get(Optional.<String>empty()),
                byCondition,
                RouteParts.NONE,
                cut.rounds(),
                cut.problem().table().rows(),
                found.complete());
    }

    /**
     * A layout together with the figures of its parts and of the scene; without them if this thread is interrupted.
     *
     * @param brief the layout, without these figures
     * @param cut the result from which it comes
     */
    RoutePlacement withParts(RoutePlacement brief, CutResult cut) {
        try {
            return brief.with(new RouteParts(alone(cut), without(cut), purchases(brief, cut.problem()), present()));
        } catch (CancellationException e) {
            return brief.incomplete();
        }
    }

    private Map<String, Double> alone(CutResult cut) {
        Map<String, Double> alone = new LinkedHashMap<>();
        cut.result()
                .chosen()
                .forEach(one -> alone.put(plan.candidates().get(one).name(), value(cut.problem(), List.of(one))));
        return alone;
    }

    private Map<String, Double> without(CutResult cut) {
        Map<String, Double> without = new LinkedHashMap<>();
        for (Integer lost : cut.result().chosen()) {
            List<Integer> rest = cut.result().chosen().stream()
                    .filter(other -> !other.equals(lost))
                    .toList();
            without.put(plan.candidates().get(lost).name(), value(cut.problem(), rest));
        }
        return without;
    }

    private Optional<PresentLayout> present() {
        Set<String> own = plan.present().enabledSensors().keySet();
        return own.isEmpty() ? Optional.empty() : Optional.of(new PresentLayout(own.size(), counted(rows.past(own))));
    }

    private static double counted(List<DirectedRoute> routes) {
        return Math.min(WeakestRouteSearch.ENOUGH, routes.get(0).exposure());
    }

    /**
     * The exposure on the weakest route past some candidates; no route is searched for if one is known without
     * exposure.
     */
    private double value(PlacementProblem problem, List<Integer> candidates) {
        double known = problem.value(candidates);
        return known == 0.0
                ? 0.0
                : Math.min(known, rows.pastCandidates(candidates).get(0).exposure());
    }

    /** What is missed least over all routes decides where the weakest of them are equally exposed. */
    private List<PlaceStep> purchases(RoutePlacement brief, PlacementProblem problem) {
        return new BuyingOrder(
                        number -> plan.candidates().get(number).candidate().cost(),
                        some -> Math.min(WeakestRouteSearch.ENOUGH, value(problem, some)),
                        some -> Math.min(WeakestRouteSearch.ENOUGH, problem.value(some)),
                        some -> mean(problem, some))
                .steps(brief, problem, 1.0);
    }

    /** The mean over the routes of what counts on each. */
    private static double mean(PlacementProblem problem, List<Integer> candidates) {
        double[] sums = new double[problem.table().rows()];
        for (int candidate : candidates) {
            var column = problem.table().column(candidate);
            for (int at = 0; at < column.size(); at++) {
                sums[column.row(at)] += column.value(at);
            }
        }
        double mean = 0.0;
        for (double sum : sums) {
            mean += Math.min(WeakestRouteSearch.ENOUGH, sum) / sums.length;
        }
        return mean;
    }
}
