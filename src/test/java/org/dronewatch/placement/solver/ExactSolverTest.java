package org.dronewatch.placement.solver;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import org.dronewatch.LongForm;
import org.dronewatch.placement.Candidate;
import org.dronewatch.placement.CandidateColumn;
import org.dronewatch.placement.CandidateTable;
import org.dronewatch.placement.KindLimits;
import org.dronewatch.placement.PlacementConditions;
import org.dronewatch.placement.PlacementObjective;
import org.dronewatch.placement.PlacementProblem;
import org.dronewatch.placement.PlacementResult;
import org.dronewatch.placement.SolverLimits;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The solver against all choices of small problems. */
class ExactSolverTest {
    /** The conditions of random problems; each alone, and all together. */
    private enum Condition {
        NUMBER,
        BUDGET,
        KINDS,
        PLACES,
        FOLD,
        LOSS,
        NEEDS,
        NEEDS_AND_LOSS,
        ALL
    }

    @ParameterizedTest
    @EnumSource
    void findsTheBestOfAllChoices(PlacementObjective objective) {
        int problems = LongForm.count(15, 500);
        int found = 0;
        for (int seed = 0; seed < problems; seed++) {
            for (Condition condition : Condition.values()) {
                found += assertIsBest(
                        problem(objective, condition, seed), objective + " " + condition + ", seed " + seed);
            }
        }
        assertThat(found).as("problems that have a solution").isGreaterThan(problems * 3);
    }

    /**
     * The most valuable candidate takes a place and a kind, which two others could use, one each: neither greedy
     * choices nor swaps find these, and a relaxation that picks greedily would prove the wrong choice.
     */
    @Test
    void doesNotBoundByPlacesThatSeveralKindsShare() {
        List<Candidate> candidates = List.of(
                new Candidate("a", 1, "radar", "mast", false),
                new Candidate("b", 1, "radar", "", false),
                new Candidate("c", 1, "camera", "mast", false));
        List<CandidateColumn> columns = List.of(
                new CandidateColumn(new int[] {0}, new double[] {3.0}),
                new CandidateColumn(new int[] {1}, new double[] {2.9}),
                new CandidateColumn(new int[] {2}, new double[] {2.9}));
        PlacementConditions conditions = PlacementConditions.NONE.withKinds(
                Map.of("radar", new KindLimits(0, 1), "camera", new KindLimits(0, 1)));
        PlacementProblem problem = new PlacementProblem(
                new CandidateTable(candidates, columns, new double[] {1, 1, 1}),
                PlacementObjective.COVERED_WEIGHT,
                conditions);

        assertThat(new ExactSolver()
                        .solve(problem, SolverLimits.NONE)
                        .orElseThrow()
                        .chosen())
                .containsExactly(1, 2);
    }

    /** A stopped search gives the best so far, whole, and a bound that holds; with a gap, it is complete. */
    @Test
    void givesABoundThatHoldsHoweverEarlyItEnds() {
        PlacementProblem problem = new PlacementProblem(
                KnownInstances.network("pmed1.txt"),
                PlacementObjective.MEAN_IMPACT,
                PlacementConditions.NONE.withAtMost(5));
        for (int calls = 0; calls < 200; calls += LongForm.count(19, 1)) {
            AtomicInteger left = new AtomicInteger(calls);
            SolverLimits limits = new SolverLimits(0.0, 1e9, () -> left.decrementAndGet() < 0);
            PlacementResult result = new ExactSolver().solve(problem, limits).orElseThrow();

            assertThat(result.value()).as(calls + " calls").isGreaterThanOrEqualTo(5819.0);
            assertThat(result.bound()).as(calls + " calls").isLessThanOrEqualTo(5819.0);
            assertThat(result.complete()).isEqualTo(result.bound() == result.value());
            assertThat(problem.isAllowed(result.chosen())).isTrue();
        }
    }

    /** Also under conditions for which only trials find a first choice. */
    @Test
    void findsAChoiceHoweverEarlyItEnds() {
        PlacementConditions five = PlacementConditions.NONE.withAtMost(5);
        assertStoppedAtOnceChooses(PlacementObjective.MEAN_IMPACT, five);
        assertStoppedAtOnceChooses(PlacementObjective.MEAN_IMPACT, five.withFold(2));
        assertStoppedAtOnceChooses(PlacementObjective.WORST_IMPACT, five);
        assertStoppedAtOnceChooses(PlacementObjective.WORST_IMPACT, five.withFold(2));
        assertStoppedAtOnceChooses(PlacementObjective.MEAN_IMPACT, five.withAnyoneLost(9000.0));
    }

    private static void assertStoppedAtOnceChooses(PlacementObjective objective, PlacementConditions conditions) {
        PlacementProblem problem = new PlacementProblem(KnownInstances.network("pmed1.txt"), objective, conditions);
        SolverLimits stopped = new SolverLimits(0.0, Double.POSITIVE_INFINITY, () -> true);
        PlacementResult result = new ExactSolver().solve(problem, stopped).orElseThrow();

        assertThat(result.chosen()).as(objective + " " + conditions).isNotEmpty();
        assertThat(problem.isAllowed(result.chosen())).isTrue();
        assertThat(result.bound()).isLessThanOrEqualTo(result.value());
        assertThat(result.complete()).isFalse();
    }

    private static int assertIsBest(PlacementProblem problem, String name) {
        BruteForce all = new BruteForce(problem);
        double best = all.best();
        Optional<PlacementResult> result = new ExactSolver().solve(problem, SolverLimits.NONE);

        assertThat(result.isPresent()).as(name + ": found").isEqualTo(!Double.isNaN(best));
        if (result.isEmpty()) {
            return 0;
        }
        int choice =
                result.get().chosen().stream().mapToInt(number -> 1 << number).sum();
        double tolerance = 1e-8 * Math.max(1.0, Math.abs(best));
        assertThat(all.complies(choice)).as(name + ": complies").isTrue();
        assertThat(all.value(choice)).as(name).isCloseTo(best, within(tolerance));
        assertThat(result.get().value()).as(name + ": value").isCloseTo(best, within(tolerance));
        assertThat(result.get().bound()).as(name + ": bound").isCloseTo(best, within(tolerance));
        assertThat(result.get().complete()).as(name + ": complete").isTrue();
        return 1;
    }

    private static PlacementProblem problem(PlacementObjective objective, Condition condition, int seed) {
        SplittableRandom random = new SplittableRandom(31L * seed + condition.ordinal());
        boolean hasKinds = condition == Condition.KINDS || condition == Condition.PLACES || condition == Condition.ALL;
        CandidateTable table = RandomTable.of(random, objective == PlacementObjective.JOINT_PROBABILITY, hasKinds);
        if (objective == PlacementObjective.LEAST_COVERED_WEIGHT) {
            int groups = 1 + seed % Math.min(4, table.rows());
            table = table.withGroups(IntStream.range(0, table.rows())
                    .map(row -> row < groups ? row : random.nextInt(groups))
                    .toArray());
        }
        PlacementConditions conditions = PlacementConditions.NONE;
        boolean hasAll = condition == Condition.ALL;
        if (condition == Condition.NEEDS || condition == Condition.NEEDS_AND_LOSS || hasAll && random.nextBoolean()) {
            conditions = conditions.withNeedsOneOf(needs(table, random));
        }
        if (condition != Condition.BUDGET || hasAll) {
            conditions = conditions.withAtMost(random.nextInt(1, 7));
        }
        if (condition == Condition.BUDGET || hasAll) {
            conditions = conditions.withBudget(random.nextDouble(15.0));
        }
        if (condition == Condition.KINDS || hasAll && random.nextBoolean()) {
            conditions = conditions.withKinds(kinds(random));
        }
        if ((condition == Condition.FOLD || hasAll) && objective.takesBest()) {
            conditions = conditions.withFold(random.nextInt(1, 4));
        }
        if (condition == Condition.LOSS || condition == Condition.NEEDS_AND_LOSS || hasAll && random.nextBoolean()) {
            conditions =
                    conditions.withAnyoneLost(remaining(new PlacementProblem(table, objective, conditions), random));
        }
        return new PlacementProblem(table, objective, conditions);
    }

    private static Map<String, KindLimits> kinds(SplittableRandom random) {
        Map<String, KindLimits> kinds = new HashMap<>();
        for (int kind = 0; kind < 3; kind++) {
            int atLeast = random.nextInt(6) == 0 ? 1 : 0;
            kinds.put("k" + kind, new KindLimits(atLeast, atLeast + random.nextInt(3)));
        }
        return kinds;
    }

    /** Some candidates need one of up to three others, or of none, which may be themselves in need. */
    private static Map<String, Set<String>> needs(CandidateTable table, SplittableRandom random) {
        Map<String, Set<String>> needs = new HashMap<>();
        for (Candidate one : table.candidates()) {
            if (random.nextBoolean()) {
                Set<String> others = new HashSet<>();
                for (int count = random.nextInt(4); count > 0; count--) {
                    others.add("c" + random.nextInt(table.size()));
                }
                others.remove(one.name());
                needs.put(one.name(), others);
            }
        }
        return needs;
    }

    /** Somewhere between the values of none and of all. */
    private static double remaining(PlacementProblem problem, SplittableRandom random) {
        List<Integer> all = IntStream.range(0, problem.table().size()).boxed().toList();
        double part = random.nextDouble();
        return (1.0 - part) * problem.value(List.of()) + part * problem.value(all);
    }
}
