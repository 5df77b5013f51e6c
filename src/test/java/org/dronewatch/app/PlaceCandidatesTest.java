package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.placement.site.PlacedSite;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Warnings of candidates that can see nothing from where they are. */
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
}
