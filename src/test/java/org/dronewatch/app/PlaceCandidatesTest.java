package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.placement.site.PlacedSite;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What is said of candidates that can see nothing from where they are, or cannot be bought. */
class PlaceCandidatesTest {
    @TempDir
    private Path directory;

    @Test
    void candidatesInsideABuildingAreNamed() throws Exception {
        Path file = PlacedSite.in(directory, "budget: 4\n");
        // The building is 30 m high.
        String inside = Files.readString(file).replace("places: [[0, 0, 30]]", "places: [[0, 0, 30], [0, 65, 10]]");
        Files.writeString(file, inside);

        Outcome outcome = Program.run("place", file.toString(), "--budgets=1", "--quiet");

        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.err())
                .containsOnlyOnce("inside a wall")
                .containsPattern("warning: candidates 'eye-2-\\d+', 'eye-2-\\d+', 'eye-2-\\d+' and 1 more seem to be"
                        + " inside a wall or under the ground: most surfaces around them face away from them");
    }

    @Test
    void otherCandidatesAreNot() throws Exception {
        Path file = PlacedSite.in(directory, "budget: 4\n");

        assertThat(Program.run("place", file.toString(), "--budgets=1", "--quiet")
                        .err())
                .doesNotContain("inside a wall");
    }

    @Test
    void aBudgetBelowAllPricesIsStated() throws Exception {
        assertThat(placed("budget: 0.5\n"))
                .contains("No sensor is affordable: the cheapest, eye-1-0, costs 1, and the budget is 0.5.")
                .doesNotContain("Buying nothing");
    }

    /** Numbers of sensors that no layout has are refused in one line, before anything is assessed. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "budget: 9\\nconditions: {fold: 10} | conditions.fold 10: must be at most 7, the number of sensors"
                        + " that the budget of 9 allows",
                "budget: 99\\nconditions: {fold: 4, atMost: 3} | conditions.fold 4: must be at most 3, which is"
                        + " conditions.atMost",
                "budget: 99\\nconditions: {atMost: 2}\\nkeep: [round]\\n+ | conditions.atMost 2: must be at least 3,"
                        + " the number of sensors that are kept or that 'atLeast' asks for",
                "budget: 3\\n+ | budget 3: must be at least 4, the price of the sensors that 'atLeast' asks for",
                "budget: 99\\nconditions: {fold: 10}\\n- | conditions.fold 10: must be at most 7, the number of"
                        + " sensors that the candidates allow",
            })
    void impossibleNumbersAreRefused(String lines, String message) throws Exception {
        String more = lines.replace("\\n", "\n");
        Path file = PlacedSite.in(directory, more.replaceAll("[+-]$", "") + "\n");
        String text = Files.readString(file);
        text = more.endsWith("+") ? text.replace("price: 2\n", "price: 2\n    atLeast: 2\n") : text;
        text = more.endsWith("-") ? text.replace("price: 1.5\n", "price: 1.5\n    atMost: 0\n") : text;
        Files.writeString(file, text);
        Outcome outcome = Program.run("place", file.toString(), "--quiet");

        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.err().strip()).matches(".*place\\.yaml:\\d+:\\d+: \\Q" + message + "\\E");
        assertThat(outcome.out()).isEmpty();
    }

    /** As many as there are is possible; what comes of it is said in one line. */
    @Test
    void aFoldOfAllCandidatesIsNoMistake() throws Exception {
        assertThat(placed("budget: 99\nconditions: {fold: 10, atMost: 10}\n"))
                .containsOnlyOnce("Buying nothing would do as well: with a conditions.fold of 10, no layout within the"
                        + " budget gains anything.");
    }

    private String placed(String more) throws Exception {
        Path file = PlacedSite.in(directory, more);
        Outcome outcome = Program.run("place", file.toString(), "--budgets=1", "--quiet");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        return outcome.out();
    }
}
