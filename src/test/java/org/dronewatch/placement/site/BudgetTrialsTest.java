package org.dronewatch.placement.site;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.TreeSet;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.placement.PlacementProblem;
import org.dronewatch.placement.PlacementSolver;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.solver.ExactSolver;
import org.dronewatch.report.placement.CoveragePlaceResults;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Budgets that are too low for the conditions do not take the place of others. */
class BudgetTrialsTest {
    @TempDir
    private Path directory;

    private SitePlacement whole;
    private BudgetFront<SitePlacement> front;

    private static String named(List<Double> budgets) {
        return budgets.size() == 1 ? "this budget" : "these budgets";
    }

    private void search(String lines, int budgets) throws IOException {
        search(PlacedSite.in(directory, lines), budgets);
    }

    private void search(Path file, int budgets) throws IOException {
        PlacePlan plan = PlacePlan.read(file, runner -> {}, note -> {});
        CoveredCells cells = new CoveredCells(plan, plan.runner().stage(plan.present()), LayerStore.NONE);
        whole = new PlaceSearch(plan, cells, new ExactSolver()).found(SolverLimits.NONE, some -> {}, () -> {});
        front = new FrontSearch<>(new CheaperCoverage(whole, cells, new ExactSolver()))
                .found(budgets, SolverLimits.NONE, some -> {});
    }

    /** The cheapest of all choices that comply is on the front, and from there on each budget that buys more. */
    @Test
    void fromTheCheapestLayoutThatCompliesNoneIsMissing() throws IOException {
        search("budget: 9\nconditions: {anyoneLost: {atLeast: 0.3}}\n", FrontSearch.MOST);
        PlacementProblem problem = whole.problem();
        TreeSet<Double> costs = new TreeSet<>();
        List<List<Integer>> allowed = new ArrayList<>();
        for (int choice = 0; choice < 1 << problem.table().size(); choice++) {
            int set = choice;
            List<Integer> chosen = IntStream.range(0, problem.table().size())
                    .filter(one -> (set >> one & 1) == 1)
                    .boxed()
                    .toList();
            if (problem.isAllowed(chosen)) {
                costs.add(problem.cost(chosen));
                allowed.add(chosen);
            }
        }
        List<Double> bests = new ArrayList<>();
        for (double limit : costs.headSet(whole.result().cost(), true)) {
            double best = allowed.stream()
                    .filter(chosen -> problem.cost(chosen) <= limit)
                    .mapToDouble(problem::value)
                    .max()
                    .orElseThrow();
            if (bests.isEmpty() || best > bests.get(bests.size() - 1)) {
                bests.add(best);
            }
        }

        assertThat(front.points()).hasSameSizeAs(bests).hasSizeGreaterThan(1);
        for (int at = 0; at < bests.size(); at++) {
            assertThat(front.points().get(at).layout().result().value()).isCloseTo(bests.get(at), within(1e-9));
        }
        assertThat(front.points().get(0).cost()).isEqualTo(costs.first());
        assertThat(front.tried().all()).isTrue();
        assertThat(front.tried().infeasible()).isNotEmpty().isSorted().allMatch(budget -> budget < costs.first());
    }

    /** Between what all cheap sensors cost together and the price of a dear one, there is nothing to buy. */
    @Test
    void aDearSensorDoesNotTakeBudgetsFromCheapOnes() throws IOException {
        Path file = PlacedSite.in(directory, "budget: 46\n");
        search(Files.writeString(file, Files.readString(file).replace("price: 2\n", "price: 40\n")), FrontSearch.MOST);

        assertThat(front.tried().infeasible()).isEmpty();
        assertThat(front.tried().count()).isEqualTo(FrontSearch.MOST);
    }

    /** As many budgets with a layout are tried as were allowed, and the results name those without one. */
    @ParameterizedTest
    @CsvSource({"9, 0.3, 4", "9, 0.25, 4"})
    void budgetsThatAreTooLowDoNotCount(double budget, double remaining, int budgets) throws IOException {
        search("budget: " + budget + "\nconditions: {anyoneLost: {atLeast: " + remaining + "}}\n", budgets);
        TriedBudgets tried = front.tried();
        CoveragePlaceResults results = new CoveragePlaceResults(front, Optional.empty());

        assertThat(tried.infeasible()).isNotEmpty();
        assertThat(tried.count() - tried.infeasible().size()).isEqualTo(budgets);
        assertThat(tried.all()).isFalse();
        assertThat(results.lines())
                .contains(tried.count() + " budgets were tried: a better buy may lie between two of them.")
                .anyMatch(line -> line.startsWith(
                        "No layout meets the conditions for " + named(tried.infeasible()) + ", which "));
        assertThat(results.toJson().get("budgets").get("infeasible"))
                .hasSize(tried.infeasible().size());
    }

    /** A solver that runs out of time has not shown that no layout complies: whether one does is not known. */
    @Test
    void aTimeoutIsNotInfeasible() throws IOException {
        PlacePlan plan = PlacePlan.read(PlacedSite.in(directory, "budget: 6\n"), runner -> {}, note -> {});
        CoveredCells cells = new CoveredCells(plan, plan.runner().stage(plan.present()), LayerStore.NONE);
        whole = new PlaceSearch(plan, cells, new ExactSolver()).found(SolverLimits.NONE, some -> {}, () -> {});
        AtomicInteger solved = new AtomicInteger();
        PlacementSolver slow = (problem, limits) -> {
            if (solved.incrementAndGet() <= 3) {
                return new ExactSolver().solve(problem, SolverLimits.NONE);
            }
            limits.end().begin();
            while (!limits.end().isDue()) {
                Thread.onSpinWait();
            }
            return Optional.empty();
        };
        front = new FrontSearch<>(new CheaperCoverage(whole, cells, slow))
                .found(FrontSearch.MOST, new SolverLimits(0.001, 0.05, () -> false), some -> {});
        CoveragePlaceResults results = new CoveragePlaceResults(front, Optional.empty());

        assertThat(solved.get()).as("none is tried after the time").isEqualTo(4);
        assertThat(front.tried().infeasible()).isEmpty();
        assertThat(front.tried().unknown()).isNotEmpty().isSorted();
        assertThat(front.tried().count()).isEqualTo(4);
        assertThat(front.tried().all()).isFalse();
        assertThat(front.complete()).isFalse();
        assertThat(front.isInterrupted()).isFalse();
        assertThat(front.best().value()).isEqualTo(whole.value());
        assertThat(front.stopped()).contains(new TimeStop(0.05, 0.001, true, true));
        assertThat(results.lines())
                .anyMatch(line -> line.startsWith("The search ended before it found a layout for "
                        + named(front.tried().unknown())))
                .noneMatch(line -> line.startsWith("No layout meets the conditions"))
                .contains("The layout for the whole budget reached the gap of 0.1 %; the time limit of 0.05 s ended the"
                        + " search for cheaper layouts.");
        assertThat(results.toJson().get("budgets").get("unknown"))
                .hasSize(front.tried().unknown().size());
        assertThat(results.toJson().get("stopped").get("gap_reached").asBoolean())
                .isTrue();
    }
}
