package org.dronewatch.placement;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.dronewatch.placement.solver.ExactSolver;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CandidateTableReaderTest {
    private static final String SENSORS = "name,cost\nA,100\nB,200\nC,400\nD,500\n";

    @TempDir
    private Path directory;

    /** The worked example of chama's documentation, whose optimum is 7.2 with A, C and D. */
    @Test
    void readsTheExampleOfChama() throws IOException {
        CandidateTable table = table(
                SENSORS,
                """
                # scenario, sensor, time of detection, probability
                row,candidate,value,weight
                S1,A,2,0.15
                S2,A,3,0.5
                S3,B,4,0.05
                S4,C,1,0.2
                S5,D,2,0.1
                S1,,50,0.15
                S2,,250,0.5
                S3,,100,0.05
                S4,,75,0.2
                S5,,225,0.1
                """);
        PlacementResult result = new ExactSolver()
                .solve(
                        new PlacementProblem(
                                table, PlacementObjective.MEAN_IMPACT, PlacementConditions.NONE.withBudget(1000)),
                        SolverLimits.NONE)
                .orElseThrow();

        assertThat(result.chosen()).isEqualTo(List.of(0, 2, 3));
        assertThat(result.value()).isCloseTo(7.2, within(1e-12));
    }

    @Test
    void readsEveryColumnOfCandidatesInAnyOrder() throws IOException {
        CandidateTable table = table(
                "\uFEFFfixed,kind,name,exclusive,cost\ntrue,radar,\"roof, north\",roof,1e4\n,,mast,,0\n",
                "candidate,row,value\nmast,cell 1,0.5\n");

        assertThat(table.candidates())
                .containsExactly(
                        new Candidate("roof, north", 10_000.0, "radar", "roof", true), new Candidate("mast", 0.0));
        assertThat(table.rows()).isEqualTo(1);
        assertThat(table.weight(0)).isEqualTo(1.0);
        assertThat(table.undetected(0)).isNaN();
        assertThat(table.column(0).size()).isZero();
        assertThat(table.column(1).value(0)).isEqualTo(0.5);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "cost                 | c.csv:1: column 'name' is missing",
                "name,price           | c.csv:1: column 'price' must be one of name, cost, kind, exclusive, fixed",
                "name,name            | c.csv:1: column 'name' appears twice",
                "name                 | c.csv: must have at least one candidate",
                "name~A~A             | c.csv:3: name 'A': appears twice",
                "name,cost~A,-1       | c.csv:2: cost '-1': must be a number of 0 or more",
                "name,cost~A,NaN      | c.csv:2: cost 'NaN': must be a number of 0 or more",
                "name,cost~A,x        | c.csv:2: cost 'x': must be a number of 0 or more",
                "name,cost~A          | c.csv:2: number of values is 1 but must be 2",
                "name,cost~,1         | c.csv:2: name is empty",
                "name,fixed~A,perhaps | c.csv:2: fixed 'perhaps': must be true or false"
            })
    void namesWhatIsWrongWithCandidates(String text, String message) {
        assertThatThrownBy(() -> table(text.replace('~', '\n'), "row,candidate,value\n"))
                .isInstanceOf(InputException.class)
                .message()
                .endsWith(message);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "S,E,1                | v.csv:2: candidate 'E': is not in the table of candidates",
                "S,A,1,1~S,A,2,1      | v.csv:3: candidate 'A': has two values in row 'S'",
                "S,,1,1~S,,2,1        | v.csv:3: row 'S': gives the impact without a detection twice",
                "S,A,1,1~S,B,2,2      | v.csv:3: weight '2': differs from that of an earlier line of row 'S'",
                "S,A,,1               | v.csv:2: value is empty",
                "S,A,Infinity,1       | v.csv:2: value 'Infinity': must be a number of 0 or more",
                "S,A                  | v.csv:2: number of values is 2 but must be 4",
                ",A,1,1               | v.csv:2: row is empty"
            })
    void namesWhatIsWrongWithValues(String lines, String message) {
        String header = lines.startsWith("S,E") ? "row,candidate,value\n" : "row,candidate,value,weight\n";

        assertThatThrownBy(() -> table(SENSORS, header + lines.replace('~', '\n')))
                .isInstanceOf(InputException.class)
                .message()
                .endsWith(message);
    }

    @Test
    void refusesWhatIsNoText() {
        assertThatThrownBy(() -> table("name\n\0", ""))
                .hasMessageEndingWith("c.csv: is not text; a table is a CSV file in UTF-8");
        assertThatThrownBy(() -> table(SENSORS, ""))
                .hasMessageEndingWith("v.csv: is empty; the first line must name the columns: row, candidate, value");
        assertThatThrownBy(() -> CandidateTableReader.read(directory.resolve("none.csv"), directory))
                .isInstanceOf(InputException.class)
                .hasMessageEndingWith("none.csv: cannot be read: no such file");
    }

    @Test
    void namesTheRowWithoutAnImpactWhereNothingDetects() throws IOException {
        CandidateTable table = table(SENSORS, "row,candidate,value\nS,A,1\n");

        assertThatThrownBy(() -> new PlacementProblem(table, PlacementObjective.WORST_IMPACT, PlacementConditions.NONE))
                .hasMessage("row 0: impacts for 1 of 4 candidates only, and the impact without a detection is missing");
    }

    private CandidateTable table(String candidates, String values) throws IOException {
        Path first = Files.writeString(directory.resolve("c.csv"), candidates);
        Path second = Files.writeString(directory.resolve("v.csv"), values);
        return CandidateTableReader.read(first, second);
    }
}
