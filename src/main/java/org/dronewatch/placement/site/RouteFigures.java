package org.dronewatch.placement.site;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BooleanSupplier;
import org.dronewatch.analysis.field.FieldGrid;
import org.dronewatch.placement.PlacementProblem;
import org.dronewatch.placement.PlacementResult;
import org.dronewatch.placement.solver.CutResult;
import org.dronewatch.route.WeakestRoute;

/** What is stated of a layout that was found: routes are searched for past each part of it. */
final class RouteFigures {
    private final PlacePlan plan;
    private final FieldGrid grid;
    private final RouteRows rows;
    private final BooleanSupplier isStopped;

    RouteFigures(PlacePlan plan, FieldGrid grid, RouteRows rows, BooleanSupplier isStopped) {
        this.plan = plan;
        this.grid = grid;
        this.rows = rows;
        this.isStopped = isStopped;
    }

    /**
     * The figures.
     *
     * @param others names of the scene's own sensors that are no candidates
     * @param isWhole whether all sensors were assessed
     */
    RoutePlacement of(CutResult cut, Set<String> others, boolean isWhole) {
        List<Integer> chosen = cut.result().chosen();
        List<WeakestRoute> past = rows.pastCandidates(chosen);
        Map<String, Double> alone = new LinkedHashMap<>();
        Map<String, Double> without = new LinkedHashMap<>();
        List<PlaceStep> front = new ArrayList<>();
        Optional<PresentLayout> present = Optional.empty();
        if (!isStopped.getAsBoolean()) {
            for (Integer one : chosen) {
                String name = plan.candidates().get(one).name();
                alone.put(name, value(cut.problem(), List.of(one)));
                without.put(
                        name,
                        value(
                                cut.problem(),
                                chosen.stream()
                                        .filter(other -> !other.equals(one))
                                        .toList()));
            }
            front = front(cut);
            present = present(others);
        }
        double value = Math.min(cut.result().value(), past.get(0).exposure());
        double lower = past.stream().mapToDouble(WeakestRoute::lower).min().orElse(0.0);
        boolean isComplete = isWhole && cut.result().complete();
        PlacementResult result = new PlacementResult(
                chosen,
                value,
                isWhole ? cut.result().bound() : WeakestRouteSearch.ENOUGH,
                cut.result().cost(),
                isComplete);
        return new RoutePlacement(
                plan,
                grid,
                result,
                past.get(0),
                Math.min(lower, value),
                alone,
                without,
                front,
                present,
                cut.rounds(),
                cut.problem().table().rows(),
                isComplete);
    }

    private Optional<PresentLayout> present(Set<String> others) {
        Set<String> own = plan.present().enabledSensors().keySet();
        boolean isAssessed = own.stream()
                .allMatch(name -> others.contains(name)
                        || plan.candidates().stream().anyMatch(one -> one.name().equals(name)));
        return own.isEmpty() || !isAssessed
                ? Optional.empty()
                : rows.least(own).map(exposure -> new PresentLayout(own.size(), exposure));
    }

    /** The exposure on the weakest route past some candidates; none is searched for if one without any is known. */
    private double value(PlacementProblem problem, List<Integer> candidates) {
        double known = problem.value(candidates);
        return known == 0.0
                ? 0.0
                : Math.min(known, rows.pastCandidates(candidates).get(0).exposure());
    }

    /** Each time the sensor that adds most for its price; where none closes the last gap yet, most over all routes. */
    private List<PlaceStep> front(CutResult cut) {
        PlacementProblem problem = cut.problem();
        List<Integer> bought = new ArrayList<>(cut.result().chosen().stream()
                .filter(number -> plan.candidates().get(number).candidate().fixed())
                .toList());
        List<Integer> left = new ArrayList<>(cut.result().chosen());
        left.removeAll(bought);
        List<PlaceStep> steps = new ArrayList<>();
        while (!left.isEmpty()) {
            Integer next = left.stream()
                    .max(Comparator.comparingDouble(
                                    (Integer number) -> perPrice(number, problem.value(with(bought, number))))
                            .thenComparingDouble(number -> perPrice(number, mean(problem, with(bought, number))))
                            .thenComparing(Comparator.reverseOrder()))
                    .orElseThrow();
            left.remove(next);
            bought.add(next);
            steps.add(new PlaceStep(plan.candidates().get(next).name(), problem.cost(bought), value(problem, bought)));
        }
        return steps;
    }

    private static List<Integer> with(List<Integer> bought, Integer number) {
        List<Integer> more = new ArrayList<>(bought);
        more.add(number);
        return more;
    }

    private double perPrice(int number, double value) {
        double price = plan.candidates().get(number).candidate().cost();
        return price > 0.0 ? value / price : value > 0.0 ? Double.MAX_VALUE : 0.0;
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
