package org.dronewatch.placement.solver;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import org.dronewatch.placement.Candidate;
import org.dronewatch.placement.CandidateLosses;
import org.dronewatch.placement.PlacementConditions;
import org.dronewatch.placement.PlacementProblem;
import org.dronewatch.placement.PlacementResult;
import org.dronewatch.placement.PlacementSolver;
import org.dronewatch.placement.RowOracle;
import org.dronewatch.placement.SolverLimits;

/**
 * Finds the layout with the greatest sum of values in its weakest row where there are too many rows to list: the best
 * layout for the rows found so far is given to an oracle, and the rows that the oracle returns are added, until it
 * finds no weaker row for the layout (E. Israeli and R. K. Wood, Networks 40, 2002). Fewer rows are never harder to
 * serve, so each round gives a bound. Not thread-safe.
 */
public final class CuttingPlanes {
    /** The gap to which early rounds are solved: their layouts will change anyway. */
    private static final double EARLY_GAP = 0.1;

    private final List<Candidate> candidates;
    private final PlacementConditions conditions;
    private final CandidateLosses losses;
    private final RowOracle oracle;
    private final PlacementSolver solver;
    private final double enough;

    /** What earlier searches of the same candidates have found: rows, and the layouts past which they are all known. */
    private final Known known;

    private record Known(List<double[]> rows, List<List<Integer>> layouts) {}

    /**
     * A search.
     *
     * @param conditions what a layout must comply with; the condition on a loss applies to all rows
     * @param solver solves the problems with the rows found so far
     * @param enough values above this count as equal to it; above 0
     */
    public CuttingPlanes(
            List<Candidate> candidates,
            PlacementConditions conditions,
            RowOracle oracle,
            PlacementSolver solver,
            double enough) {
        this(candidates, conditions, oracle, solver, enough, new Known(new ArrayList<>(), new ArrayList<>()));
    }

    private CuttingPlanes(
            List<Candidate> candidates,
            PlacementConditions conditions,
            RowOracle oracle,
            PlacementSolver solver,
            double enough,
            Known known) {
        this.candidates = List.copyOf(candidates);
        this.conditions = conditions;
        this.losses =
                new CandidateLosses(candidates.stream().map(Candidate::name).toList(), conditions);
        this.oracle = oracle;
        this.solver = solver;
        this.enough = enough;
        this.known = known;
    }

    /**
     * A search with another budget, which begins with the rows that this search has found and those that the oracle
     * knows.
     */
    public CuttingPlanes within(double budget) {
        return new CuttingPlanes(candidates, conditions.withBudget(budget), oracle, solver, enough, known);
    }

    /**
     * The best layout that is found within some limits, whose time all rounds share; the oracle's answer on a layout is
     * awaited, and a first layout is tried even if the time is up. An interruption of this thread also ends the
     * search, and its interrupt status is kept. Empty if no layout complies, or none was found in time.
     *
     * @param round receives the number of layouts that have been given to the oracle so far
     * @throws CancellationException when the user ends the search before the oracle has answered for the first layout
     */
    public Optional<CutResult> solve(SolverLimits limits, IntConsumer round) {
        limits.end().begin();
        Search search = new Search(limits);
        if (known.rows().isEmpty()) {
            search.cut(fixed());
        }
        search.run(round);
        return search.result();
    }

    private List<Integer> fixed() {
        return IntStream.range(0, candidates.size())
                .filter(number -> candidates.get(number).fixed())
                .boxed()
                .toList();
    }

    /** One search: the rows and layouts so far. */
    private final class Search {
        private final SolverLimits limits;
        private final CutRows rows = new CutRows(candidates, conditions);
        private final List<List<Integer>> layouts = new ArrayList<>(known.layouts());
        private final Set<List<Integer>> tried = new HashSet<>(layouts);
        private double bound = enough;
        private boolean isInterrupted;
        private boolean isProven;

        Search(SolverLimits limits) {
            this.limits = limits;
            rows.addAll(known.rows());
            rows.addAll(oracle.known());
        }

        void cut(List<Integer> layout) {
            add(layout);
            if (conditions.anyoneLost().isPresent()) {
                for (Integer lost : layout) {
                    add(losses.remaining(layout, lost));
                }
            }
        }

        private void add(List<Integer> layout) {
            List<double[]> found = oracle.weakest(layout);
            rows.addAll(found);
            known.rows().addAll(found);
        }

        void run(IntConsumer round) {
            double gap = Math.max(EARLY_GAP, limits.gap());
            while (!isProven && !isInterrupted && !isEnded()) {
                Optional<PlacementResult> best = solver.solve(rows.problem(bound), limits.withGap(gap));
                if (best.isEmpty()) {
                    // No layout complies even with the rows known so far, unless the search has ended early.
                    isProven = !limits.end().isDue();
                    return;
                }
                bound = Math.min(bound, best.get().bound());
                List<Integer> layout = best.get().chosen();
                boolean isNew = tried.add(layout);
                if (isNew) {
                    cutUnlessInterrupted(layout);
                    round.accept(layouts.size());
                }
                double value = rows.best(layouts).map(this::value).orElse(Double.NEGATIVE_INFINITY);
                // What the oracle cannot cut in an accurately solved round is the best.
                boolean isAccurate = gap <= limits.gap() && best.get().complete();
                isProven = bound <= value * (1.0 + limits.gap()) || !isNew && isAccurate;
                gap = isNew ? gap : limits.gap();
            }
        }

        private boolean isEnded() {
            return limits.end().isStopped() || limits.end().isTimeOver() && !layouts.isEmpty();
        }

        private void cutUnlessInterrupted(List<Integer> layout) {
            try {
                cut(layout);
                layouts.add(layout);
                known.layouts().add(layout);
            } catch (CancellationException e) {
                isInterrupted = true;
            }
        }

        private double value(List<Integer> layout) {
            return Math.min(enough, rows.value(layout));
        }

        Optional<CutResult> result() {
            PlacementProblem problem = rows.problem(enough);
            if (layouts.isEmpty() && (isInterrupted || limits.end().isStopped()) && !isProven) {
                throw new CancellationException("ended before the first layout was compared with routes");
            }
            boolean isComplete = isProven && !isInterrupted;
            return rows.best(layouts).map(tried -> {
                // Nothing is recommended for what it does not gain; a complete search may still compare costs.
                boolean isUseless = !isComplete && value(tried) == 0.0 && problem.isAllowed(fixed());
                List<Integer> layout = isUseless ? fixed() : tried;
                double value = value(layout);
                PlacementResult result =
                        new PlacementResult(layout, value, Math.max(bound, value), problem.cost(layout), isComplete);
                return new CutResult(problem, result, layouts.size());
            });
        }
    }
}
