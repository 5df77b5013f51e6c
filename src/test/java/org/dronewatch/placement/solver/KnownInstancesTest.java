package org.dronewatch.placement.solver;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.dronewatch.LongForm;
import org.dronewatch.placement.Candidate;
import org.dronewatch.placement.CandidateColumn;
import org.dronewatch.placement.CandidateTable;
import org.dronewatch.placement.CandidateTableReader;
import org.dronewatch.placement.PlacementConditions;
import org.dronewatch.placement.PlacementObjective;
import org.dronewatch.placement.PlacementProblem;
import org.dronewatch.placement.PlacementResult;
import org.dronewatch.placement.SolverLimits;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The solver on published instances; the README beside the files states their sources and optima. */
class KnownInstancesTest {
    @TempDir
    private Path directory;

    /** J. E. Beasley, A note on solving large p-median problems (1985): optima of the OR-Library. */
    @ParameterizedTest
    @CsvSource({"pmed1.txt, 5819", "pmed2.txt, 4093", "pmed5.txt, 1355", "pmed10.txt, 1255"})
    void provesMediansOfNetworks(String name, double optimum) throws IOException {
        PlacementResult result = median(name, SolverLimits.NONE);

        assertThat(result.value()).isEqualTo(optimum);
        assertThat(result.bound()).isEqualTo(optimum);
        assertThat(result.complete()).isTrue();
        assertThat(result.chosen()).hasSizeLessThanOrEqualTo(KnownInstances.chosen(name));
    }

    /** 900 vertices, of which 90 are chosen; the optimum is 5128. */
    @Test
    void comesWithinOnePercentOfTheLargestNetwork() throws IOException {
        assumeTrue(LongForm.IS_ON, "the long form alone");
        PlacementResult result = median("pmed40.txt", SolverLimits.NONE.withGap(0.01));

        assertThat(result.complete()).isTrue();
        assertThat(result.value()).isBetween(5128.0, 5179.0);
        assertThat(result.bound()).isBetween(result.value() / 1.01, 5128.0);
    }

    private PlacementResult median(String name, SolverLimits limits) throws IOException {
        return solve(
                reread(KnownInstances.network(name)),
                PlacementObjective.MEAN_IMPACT,
                PlacementConditions.NONE.withAtMost(KnownInstances.chosen(name)),
                limits);
    }

    @Test
    void provesTheCentreOfANetwork() throws IOException {
        PlacementResult result = solve(
                reread(KnownInstances.network("pmed1.txt")),
                PlacementObjective.WORST_IMPACT,
                PlacementConditions.NONE.withAtMost(5),
                SolverLimits.NONE);

        assertThat(result.value()).isEqualTo(127.0);
        assertThat(result.bound()).isEqualTo(127.0);
    }

    @Test
    void provesTheSensorsOfTheWaterNetwork() throws IOException {
        CandidateTable table = reread(KnownInstances.waterNetwork());
        PlacementResult result =
                solve(table, PlacementObjective.MEAN_IMPACT, PlacementConditions.NONE.withAtMost(5), SolverLimits.NONE);

        assertThat(result.value()).isCloseTo(8655.8064, within(5e-5));
        assertThat(result.bound()).isCloseTo(result.value(), within(1e-4));
        assertThat(names(table, result)).containsExactlyInAnyOrder("16", "21", "28", "38", "65");
    }

    /** Chama's tests: the greedy choice has 8822.19, and swaps lead from it to the optimum. */
    @Test
    void greedyAndSwapsOfTheWaterNetworkAreThoseOfChama() {
        PlacementProblem problem = new PlacementProblem(
                KnownInstances.waterNetwork(), PlacementObjective.MEAN_IMPACT, PlacementConditions.NONE.withAtMost(5));
        Gains gains = new Gains(problem);
        Rules rules = new Rules(problem);
        int[] greedy = new LazyGreedy(gains, rules, false).extended(new int[0]);
        int[] swapped = new Interchange(gains, rules, () -> false).swapped(greedy);

        assertThat(value(problem, greedy)).isCloseTo(8822.19, within(0.005));
        assertThat(value(problem, swapped)).isCloseTo(8655.8064, within(5e-5));
    }

    private static double value(PlacementProblem problem, int[] chosen) {
        return problem.value(Arrays.stream(chosen).boxed().toList());
    }

    /** The four stores, found by trying all choices; pysal/spopt has the data. */
    @Test
    void provesTheStoresOfSanFrancisco() throws IOException {
        CandidateTable byDemand = reread(KnownInstances.stores(true));
        CandidateTable byNumber = reread(KnownInstances.stores(false));
        PlacementResult demand = stores(byDemand);
        PlacementResult number = stores(byNumber);

        assertThat(demand.value()).isEqualTo(875_247.0);
        assertThat(names(byDemand, demand)).containsExactlyInAnyOrder("Store_2", "Store_11", "Store_12", "Store_15");
        assertThat(number.value()).isEqualTo(185.0);
        assertThat(number.bound()).isEqualTo(185.0);
    }

    private static PlacementResult stores(CandidateTable table) {
        return solve(
                table, PlacementObjective.COVERED_WEIGHT, PlacementConditions.NONE.withAtMost(4), SolverLimits.NONE);
    }

    /** The worked example of chama's documentation. */
    @Test
    void provesTheExampleOfChama() throws IOException {
        List<Candidate> sensors = List.of(
                new Candidate("A", 100), new Candidate("B", 200), new Candidate("C", 400), new Candidate("D", 500));
        List<CandidateColumn> impacts = List.of(
                column(new int[] {0, 1}, 2, 3),
                column(new int[] {2}, 4),
                column(new int[] {3}, 1),
                column(new int[] {4}, 2));
        CandidateTable table = reread(new CandidateTable(
                sensors, impacts, new double[] {.15, .5, .05, .2, .1}, new double[] {50, 250, 100, 75, 225}));
        PlacementResult result = solve(
                table, PlacementObjective.MEAN_IMPACT, PlacementConditions.NONE.withBudget(1000), SolverLimits.NONE);

        assertThat(names(table, result)).containsExactly("A", "C", "D");
        assertThat(result.value()).isCloseTo(7.2, within(1e-12));
        assertThat(result.bound()).isCloseTo(7.2, within(1e-9));
        assertThat(result.cost()).isEqualTo(1000.0);
    }

    /** A table as users give it: written to two files, and read as theirs are. */
    private CandidateTable reread(CandidateTable table) throws IOException {
        StringBuilder candidates = new StringBuilder("name,cost\n");
        StringBuilder values = new StringBuilder("row,candidate,value,weight\n");
        for (int row = 0; row < table.rows(); row++) {
            if (!Double.isNaN(table.undetected(row))) {
                values.append(line(table, row, "", table.undetected(row)));
            }
        }
        for (int number = 0; number < table.size(); number++) {
            Candidate candidate = table.candidates().get(number);
            candidates
                    .append(candidate.name())
                    .append(',')
                    .append(candidate.cost())
                    .append('\n');
            CandidateColumn column = table.column(number);
            for (int at = 0; at < column.size(); at++) {
                values.append(line(table, column.row(at), candidate.name(), column.value(at)));
            }
        }
        return CandidateTableReader.read(
                Files.writeString(directory.resolve("candidates.csv"), candidates),
                Files.writeString(directory.resolve("values.csv"), values));
    }

    private static String line(CandidateTable table, int row, String candidate, double value) {
        return "row " + row + "," + candidate + "," + value + "," + table.weight(row) + "\n";
    }

    private static CandidateColumn column(int[] rows, double... values) {
        return new CandidateColumn(rows, values);
    }

    /** E. Israeli and R. K. Wood, Networks 40 (2002): B sensors in W columns give e floor(B/W), in parts e B/W. */
    @ParameterizedTest
    @CsvSource({"5, 12, 0.7, 1.4, 1.68", "3, 7, 1, 2, 2.33333333333", "4, 8, 0.3, 0.6, 0.6", "6, 5, 1, 0, 0.83333333333"
    })
    void provesTheWeakestColumnOfACorridor(int width, int number, double exposure, double binary, double relaxed)
            throws IOException {
        StringBuilder candidates = new StringBuilder("name,cost\n");
        StringBuilder values = new StringBuilder("row,candidate,value\n");
        for (int cell = 0; cell < width * (number / width + 1); cell++) {
            candidates.append("cell ").append(cell).append(",1\n");
            values.append("column ").append(cell % width).append(",cell ").append(cell);
            values.append(',').append(exposure).append('\n');
        }
        CandidateTable table = CandidateTableReader.read(
                Files.writeString(directory.resolve("candidates.csv"), candidates),
                Files.writeString(directory.resolve("values.csv"), values));
        PlacementConditions conditions = PlacementConditions.NONE.withAtMost(number);
        PlacementResult result = solve(table, PlacementObjective.WEAKEST_ROW, conditions, SolverLimits.NONE);

        assertThat(result.value()).isCloseTo(binary, within(1e-12));
        assertThat(result.bound()).isCloseTo(binary, within(1e-12));
        assertThat(Relaxation.of(new PlacementProblem(table, PlacementObjective.WEAKEST_ROW, conditions)))
                .isCloseTo(relaxed, within(1e-9));
    }

    private static PlacementResult solve(
            CandidateTable table, PlacementObjective objective, PlacementConditions conditions, SolverLimits limits) {
        return new ExactSolver()
                .solve(new PlacementProblem(table, objective, conditions), limits)
                .orElseThrow();
    }

    private static List<String> names(CandidateTable table, PlacementResult result) {
        return result.chosen().stream()
                .map(chosen -> table.candidates().get(chosen).name())
                .collect(Collectors.toList());
    }
}
