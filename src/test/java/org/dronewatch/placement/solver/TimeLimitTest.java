package org.dronewatch.placement.solver;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import org.dronewatch.placement.Candidate;
import org.dronewatch.placement.CandidateColumn;
import org.dronewatch.placement.CandidateTable;
import org.dronewatch.placement.KindLimits;
import org.dronewatch.placement.PlacementConditions;
import org.dronewatch.placement.PlacementObjective;
import org.dronewatch.placement.PlacementProblem;
import org.dronewatch.placement.PlacementResult;
import org.dronewatch.placement.RowOracle;
import org.dronewatch.placement.SearchEnd;
import org.dronewatch.placement.SolverLimits;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** A choice among 60 candidates that takes longer than its time limit: it ends in time, with a whole layout. */
class TimeLimitTest {
    private static final int CANDIDATES = 60;
    private static final int ROWS = 600;
    private static final double SECONDS = 0.2;
    private static final long SEED = 3;

    private final SplittableRandom random = new SplittableRandom(SEED);

    private List<Candidate> candidates() {
        return IntStream.range(0, CANDIDATES)
                .mapToObj(number ->
                        new Candidate("c" + number, random.nextDouble(1.0, 3.0), "kind-" + number % 3, "", number == 0))
                .toList();
    }

    private PlacementProblem problem(PlacementObjective objective, PlacementConditions conditions) {
        double[] weights = random.doubles(ROWS, 0.5, 1.0).toArray();
        double[] undetected = new double[ROWS];
        Arrays.fill(undetected, 20.0);
        List<CandidateColumn> columns = new ArrayList<>();
        for (int candidate = 0; candidate < CANDIDATES; candidate++) {
            int[] rows = IntStream.range(0, ROWS)
                    .filter(row -> random.nextDouble() < 0.3)
                    .toArray();
            double most = objective == PlacementObjective.JOINT_PROBABILITY ? 0.9 : 19.0;
            columns.add(new CandidateColumn(
                    rows, random.doubles(rows.length, 0.1, most).toArray()));
        }
        CandidateTable table = new CandidateTable(candidates(), columns, weights, undetected);
        boolean isGrouped = objective == PlacementObjective.LEAST_COVERED_WEIGHT;
        return new PlacementProblem(
                isGrouped
                        ? table.withGroups(
                                IntStream.range(0, ROWS).map(row -> row % 5).toArray())
                        : table,
                objective,
                conditions.withBudget(25.0).withKinds(Map.of("kind-1", new KindLimits(2, 6))));
    }

    @ParameterizedTest
    @EnumSource(PlacementObjective.class)
    void everyObjectiveEndsInTime(PlacementObjective objective) {
        List<PlacementConditions> all = new ArrayList<>(List.of(PlacementConditions.NONE));
        if (objective.takesBest()) {
            all.add(PlacementConditions.NONE.withFold(2));
        }
        for (PlacementConditions conditions : all) {
            PlacementProblem problem = problem(objective, conditions);
            SolverLimits limits = new SolverLimits(0.0, SECONDS, () -> false);
            long begun = System.nanoTime();
            PlacementResult result = new ExactSolver().solve(problem, limits).orElseThrow();
            double elapsed = 1e-9 * (System.nanoTime() - begun);

            assertThat(elapsed).as(objective + ", seed " + SEED).isLessThan(SECONDS + SearchEnd.GRACE);
            assertThat(result.complete()).as(objective + ": was it cut?").isFalse();
            assertThat(problem.isAllowed(result.chosen())).isTrue();
            assertThat(result.chosen()).contains(0);
            assertThat(result.cost()).isLessThanOrEqualTo(25.0);
            assertThat(result.gap()).isPositive();
        }
    }

    /** A choice that takes longer than its time to find the first layout is given a grace. */
    @Test
    void aFirstLayoutIsFoundAfterTheTime() {
        PlacementConditions lost = PlacementConditions.NONE.withAnyoneLost(1000.0);
        PlacementProblem problem = problem(PlacementObjective.COVERED_WEIGHT, lost);
        PlacementResult result = new ExactSolver()
                .solve(problem, new SolverLimits(0.0, 1e-6, () -> false))
                .orElseThrow();

        assertThat(problem.isAllowed(result.chosen())).isTrue();
        assertThat(result.complete()).isFalse();
    }

    /** All rounds of cutting planes have one time limit together: each of them alone would take as long. */
    @Test
    void roundsShareTheTime() {
        List<Candidate> candidates = candidates();
        List<double[]> pool = IntStream.range(0, 5000)
                .mapToObj(row -> IntStream.range(0, CANDIDATES)
                        .mapToDouble(one -> Math.max(0.0, random.nextDouble(-2.0, 1.0)))
                        .toArray())
                .toList();
        AtomicInteger asked = new AtomicInteger();
        RowOracle oracle = chosen -> {
            asked.incrementAndGet();
            return List.of(pool.stream()
                    .min((one, other) -> Double.compare(sum(one, chosen), sum(other, chosen)))
                    .orElseThrow());
        };
        PlacementConditions conditions = PlacementConditions.NONE.withBudget(25.0);
        CuttingPlanes planes = new CuttingPlanes(candidates, conditions, oracle, new ExactSolver(), 100.0);
        SolverLimits limits = new SolverLimits(0.0, 2.0, () -> false);
        long begun = System.nanoTime();
        CutResult cut = planes.solve(limits, round -> {}).orElseThrow();
        double elapsed = 1e-9 * (System.nanoTime() - begun);
        int before = asked.get();

        assertThat(elapsed).as("seed " + SEED).isLessThan(2.0 + SearchEnd.GRACE);
        assertThat(cut.rounds()).isGreaterThan(4);
        assertThat(cut.result().complete()).isFalse();
        assertThat(cut.problem().isAllowed(cut.result().chosen())).isTrue();
        assertThat(cut.result().bound()).isGreaterThan(cut.result().value());
        // Nothing is left of the time for another budget, for which the known layouts may do.
        assertThat(planes.within(20.0).solve(limits, round -> {}).filter(its -> its.result()
                        .complete()))
                .isEmpty();
        assertThat(asked.get()).isEqualTo(before);
    }

    private static double sum(double[] row, List<Integer> chosen) {
        return chosen.stream().mapToDouble(one -> row[one]).sum();
    }

    /** However little time there is, a layout is given to the oracle: without one, there would be no result. */
    @Test
    void aFirstRoundIsMadeAfterTheTime() {
        AtomicInteger asked = new AtomicInteger();
        RowOracle oracle = chosen -> {
            asked.incrementAndGet();
            double[] row = new double[CANDIDATES];
            Arrays.fill(row, 1.0 / asked.get());
            return List.of(row);
        };
        CuttingPlanes planes = new CuttingPlanes(
                candidates(), PlacementConditions.NONE.withBudget(10.0), oracle, new ExactSolver(), 100.0);
        CutResult cut = planes.solve(new SolverLimits(0.0, 1e-9, () -> false), round -> {})
                .orElseThrow();

        assertThat(cut.rounds()).isEqualTo(1);
        assertThat(asked.get()).isEqualTo(2);
        assertThat(cut.result().chosen()).isNotEmpty();
        assertThat(cut.result().complete()).isFalse();
    }
}
