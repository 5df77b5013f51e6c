package org.dronewatch.viewer.coverage;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What the tab proposes in a hall of 40 x 20 m that is 8 m high, and around it. */
class CoverageProposalTest {
    private static final String FLOOR = "v -20 0 -10\nv 20 0 -10\nv 20 0 10\nv -20 0 10\nf 1 4 3\nf 1 3 2\n";
    private static final String CEILING = "v -20 8 -10\nv 20 8 -10\nv 20 8 10\nv -20 8 10\nf 5 7 8\nf 5 6 7\n";

    @TempDir
    private Path directory;

    private CoverageProposal with(String... positions) throws Exception {
        Files.writeString(directory.resolve("hall.obj"), FLOOR + CEILING);
        StringBuilder text = new StringBuilder("world: {models: [hall.obj]}\nsensors:\n");
        for (int i = 0; i < positions.length; i++) {
            text.append("  r" + i + ": {use: spotterrf-c550, position: " + positions[i] + "}\n");
        }
        Path file = directory.resolve("hall.yaml");
        Files.writeString(file, text + "run: {duration: 1 s}\n");
        SceneRunner runner = new SceneRunner(new SceneFile(file));
        SceneSettings settings = runner.settings();
        return CoverageProposal.of(settings, runner.stage(settings).world());
    }

    /** 30 m from the middle of the sensors to the farthest wall. */
    @Test
    void indoorsItIsTheBuildingBelowTheCeiling() throws Exception {
        assertThat(with("[5, 0, 4]", "[15, 0, 4]")).isEqualTo(new CoverageProposal(60.0, List.of(2.0, 5.0)));
    }

    @Test
    void ifASensorIsUnderTheOpenSkyItIsThatOfTheCommand() throws Exception {
        CoverageProposal outdoors = new CoverageProposal(FieldGrid.DEFAULT_SIDE, FieldGrid.HEIGHTS);
        assertThat(with("[5, 0, 4]", "[15, 0, 9]")).as("on the roof").isEqualTo(outdoors);
        assertThat(with("[5, 0, 4]", "[50, 0, 4]")).as("beside it").isEqualTo(outdoors);
    }
}
