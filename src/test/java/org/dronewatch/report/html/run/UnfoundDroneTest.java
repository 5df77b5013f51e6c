package org.dronewatch.report.html.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What the report says of a drone that an observer could have found, but did not in time. */
class UnfoundDroneTest {
    @TempDir
    private Path directory;

    /** Three seconds from 120 m to 30 m: seed 2 gives an observer who sees well, but whose search takes longer. */
    @Test
    void aSearchThatDidNotSucceedInTimeIsTheReason() throws Exception {
        Path file = Files.writeString(
                directory.resolve("scene.yaml"),
                """
                world: {models: [packaged:house.obj]}
                drones:
                  intruder:
                    model: packaged:quadrotor.obj
                    flight: {kind: approach, from: [0, 150, 30], to: [0, 60, 30]}
                    speed: 30 m/s
                sensors:
                  eye:
                    kind: camera
                    position: [0, 0, 30]
                    aim: {azimuth: 0 deg, elevation: 0 deg}
                    detection: {kind: target-task, byChance: true}
                run: {duration: 2.9 s}
                """);
        SceneRunner runner = new SceneRunner(new SceneFile(file)).seed(2);
        RunLooks looks = new RunLooks(2.9, runner.stage(runner.settings()));
        runner.onFrame(looks::add).run();

        BestLook best = looks.best("eye", "intruder").orElseThrow();
        assertThat(best.isUnfound()).isTrue();
        assertThat(best.margin()).isZero();
        Reasons reasons = new Reasons(runner.settings(), looks.stage(), looks.pointings(), 2.9);
        assertThat(reasons.of("eye", List.of("intruder"), Optional.of(best)))
                .contains(String.format(
                        "could have been found at ranges up to %.0f m, but the search took too long", best.range()));
    }
}
