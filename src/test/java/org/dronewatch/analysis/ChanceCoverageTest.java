package org.dronewatch.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.dronewatch.Thorough;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.Cause;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Sensors that decide by chance cover what they detect with an even chance, without speckle. */
class ChanceCoverageTest {
    private static final CoverageGrid GRID = new CoverageGrid(0, 0, 600, 40, 2);

    @TempDir
    private Path directory;

    private Coverage coverage(long seed) throws IOException {
        Files.writeString(
                directory.resolve("plain.obj"),
                "v -500 0 -500\nv 500 0 -500\nv 500 0 500\nv -500 0 500\nf 1 4 3\nf 1 3 2\n");
        Path file = Files.writeString(
                directory.resolve("site.yaml"),
                """
                world: {models: [plain.obj]}
                drones:
                  one: {model: packaged:quadrotor.obj, flight: {kind: hover, position: [0, 300, 2]}}
                sensors:
                  radar: {kind: radar, position: [0, 0, 2], minRange: 1, minSpeed: 0, elevationWidth: 90 deg, budget: {range: 180, crossSection: 0.01}, detection: {kind: chance}}
                  heat: {kind: thermal, position: [0, -250, 2], aim: {azimuth: 0 deg, elevation: 0 deg}, fov: 60 deg, byChance: true}
                  eye: {kind: camera, position: [0, -250, 2], aim: {azimuth: 0 deg, elevation: 0 deg}, detection: {kind: target-task, byChance: true}}
                """);
        SceneRunner runner = new SceneRunner(new SceneFile(file)).seed(seed).set("run.seed", Long.toString(seed));
        SceneSettings settings = runner.settings();
        Stage stage = runner.stage(settings);
        return Coverage.of(settings, stage, "one", GRID, points -> {});
    }

    @Thorough
    @Test
    void aCellIsCoveredWhereAnEvenChanceIsReachedWhateverTheSeed() throws IOException {
        Coverage one = coverage(1);
        Coverage other = coverage(99);

        for (String sensor : new String[] {"radar", "heat", "eye"}) {
            assertThat(one.reachedCells(sensor)).as(sensor).isBetween(10, GRID.cells() * GRID.cells() - 10);
            for (int row = 0; row < GRID.cells(); row++) {
                for (int column = 0; column < GRID.cells(); column++) {
                    double probability =
                            one.assess(sensor, column, row).orElseThrow().probability();
                    assertThat(one.isReached(sensor, column, row))
                            .as("%s in column %d, row %d: %s", sensor, column, row, probability)
                            .isEqualTo(probability >= 0.5)
                            .isEqualTo(other.isReached(sensor, column, row));
                }
            }
        }
    }

    /** What an unlucky draw used to leave out inside the range of a radar counted as too weak there. */
    @Thorough
    @Test
    void noCellInsideTheEvenChanceIsTooWeak() throws IOException {
        Coverage coverage = coverage(1);
        Map<Cause, Integer> causes = coverage.causes("radar");
        int cells = GRID.cells() * GRID.cells();

        assertThat(coverage.reachedCells("radar")
                        + causes.values().stream().mapToInt(Integer::intValue).sum())
                .isEqualTo(cells);
        assertThat(causes).doesNotContainKey(Cause.DETECTED);
    }
}
