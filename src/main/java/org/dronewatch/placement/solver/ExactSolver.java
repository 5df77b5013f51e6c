package org.dronewatch.placement.solver;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import org.dronewatch.placement.PlacementProblem;
import org.dronewatch.placement.PlacementResult;
import org.dronewatch.placement.PlacementSolver;
import org.dronewatch.placement.SearchEnd;
import org.dronewatch.placement.SolverLimits;

/**
 * Begins with a greedy choice and swaps, then proves which layout is best by branch and bound with Lagrangian
 * relaxation or, for the worst impact, by bisection over its levels. The result depends only on the problem and the
 * gap, unless a time limit or the user ends the search. Thread-safe.
 */
public final class ExactSolver implements PlacementSolver {
    @Override
    public Optional<PlacementResult> solve(PlacementProblem problem, SolverLimits limits) {
        limits.end().begin();
        Gains gains = new Gains(problem);
        OptionalDouble needed = problem.conditions().anyoneLost().isPresent()
                ? OptionalDouble.of(
                        gains.gainOf(problem.conditions().anyoneLost().getAsDouble()))
                : OptionalDouble.empty();
        Incumbent incumbent = new Incumbent(gains, new Rules(problem), needed);
        Cutoff cutoff = new Cutoff(gains, incumbent, limits.gap());
        double open = search(gains, incumbent, cutoff, needed, limits.end());
        if (!incumbent.isFound()) {
            return Optional.empty();
        }
        boolean isComplete = open <= incumbent.value() || cutoff.isHopeless(open);
        // No choice is better than all candidates together.
        int[] all = IntStream.range(0, gains.candidates()).toArray();
        double bound = Math.min(cutoff.bound(open), new Valuation(gains).value(all));
        return Optional.of(result(problem, incumbent, gains.reported(bound), isComplete));
    }

    /**
     * Searches; returns the greatest bound of what is left when the search is stopped, negative infinity if nothing is.
     */
    private static double search(
            Gains gains, Incumbent incumbent, Cutoff cutoff, OptionalDouble needed, SearchEnd end) {
        BooleanSupplier isStopped = () -> end.isDue() && (incumbent.isFound() || end.isGraceOver());
        if (gains.form == Gains.Form.BEST_LEAST) {
            Start start = new Start(gains, incumbent, end::isGraceOver);
            return new LevelSearch(gains, incumbent, cutoff, needed, start, isStopped).search();
        }
        Gains summed = gains.form == Gains.Form.LEAST_SUM
                ? gains.weighted(new GroupWeights(gains, incumbent, isStopped).found())
                : gains;
        return new BranchAndBound(summed, incumbent, cutoff, new Start(summed, incumbent, end::isGraceOver), isStopped)
                .search();
    }

    private static PlacementResult result(
            PlacementProblem problem, Incumbent incumbent, double bound, boolean isComplete) {
        List<Integer> chosen = trimmed(problem, incumbent);
        double value = problem.value(chosen);
        boolean isBeyond = problem.objective().isGreatest() ? bound > value : bound < value;
        boolean isProven = Math.abs(bound - value) <= 1e-9 * Math.max(1.0, Math.abs(value));
        return new PlacementResult(
                chosen, value, isBeyond && !isProven ? bound : value, problem.cost(chosen), isComplete);
    }

    /** The choice without candidates that add nothing; the dearest are removed first. */
    private static List<Integer> trimmed(PlacementProblem problem, Incumbent incumbent) {
        int[] chosen = incumbent.chosen();
        double[] costs = incumbent.rules().cost;
        List<Integer> byCost = IntStream.of(chosen)
                .boxed()
                .sorted(Comparator.comparingDouble((Integer candidate) -> -costs[candidate])
                        .thenComparing(Comparator.reverseOrder()))
                .toList();
        for (int candidate : byCost) {
            int[] fewer =
                    IntStream.of(chosen).filter(other -> other != candidate).toArray();
            boolean isFixed = problem.table().candidates().get(candidate).fixed();
            if (!isFixed && incumbent.isAsGood(fewer)) {
                chosen = fewer;
            }
        }
        return Arrays.stream(chosen).sorted().boxed().toList();
    }
}
