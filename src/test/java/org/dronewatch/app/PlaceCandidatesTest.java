package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.placement.site.PlacedSite;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

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

    @Test
    void aFoldOfMoreSensorsThanTheBudgetBuysIsStated() throws Exception {
        assertThat(placed("budget: 9\nconditions: {fold: 10}\n"))
                .contains("No layout can gain anything: conditions.fold asks for 10 sensors at once, and the"
                        + " budget allows a layout of at most 7.")
                .doesNotContain("Buying nothing");
    }

    private String placed(String more) throws Exception {
        Path file = PlacedSite.in(directory, more);
        Outcome outcome = Program.run("place", file.toString(), "--budgets=1", "--quiet");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        return outcome.out();
    }
}
