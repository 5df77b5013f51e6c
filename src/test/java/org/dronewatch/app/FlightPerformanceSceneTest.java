package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** What a user reads when a scene's flight exceeds the performance stated for its drone. */
class FlightPerformanceSceneTest extends CommandLines {
    private Program.Outcome check(String performance) throws IOException {
        Path scene = directory.resolve("scene.yaml");
        Files.writeString(
                scene,
                """
                world: {models: [packaged:house.obj]}
                drones:
                  visitor:
                    model: packaged:quadrotor.obj
                    flight: {kind: approach, from: [0, 90, 20], to: [0, 50, 50]}
                    %s
                sensors:
                  eye: {kind: camera, position: [0, -30, 25], aim: {lookAt: [0, 50, 16]}, fov: 50 deg, rate: 1 Hz}
                run: {duration: 20 s}
                """
                        .formatted(performance));
        return Program.run("check", scene.toString());
    }

    @Test
    void aFlightBeyondWhatTheDroneCanFlyIsWarnedOf() throws IOException {
        Program.Outcome outcome = check("performance: {climb: 2 m/s, ceiling: 45 m}");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.err())
                .containsPattern("drone 'visitor' climbs at 3 m/s, [0-9.]+ s after the start, at \\(.*\\) m:"
                        + " its performance allows 2 m/s")
                .as("the house is below nothing of the flight: no surface, no height")
                .doesNotContain("ceiling");
    }

    @Test
    void withoutAStatedPerformanceNothingIsChecked() throws IOException {
        assertThat(check("").err()).doesNotContain("performance");
    }

    @Test
    void limitsOfPerformanceAreChecked() throws IOException {
        Program.Outcome outcome = check("performance: {climb: 900 m/s}");
        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.err())
                .contains("drones.visitor.performance")
                .contains("900")
                .contains("200");
    }
}
