package org.dronewatch.render.canvas;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronewatch.render.RunHistory;
import org.dronewatch.run.DetectionEvent;
import org.dronewatch.run.DetectionIntervals;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.Stage;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scenes.PackagedScene;
import org.junit.jupiter.api.Test;

/** The parts of a flight, against the events of its run. */
class FlightStretchTest {
    @Test
    void aFlightIsDividedWhereWhoDetectsItChanges() {
        SceneRunner runner = new SceneRunner(
                PackagedScene.find("multi-sensor").orElseThrow().factory().get());
        runner.set("sensors.microphone.enabled", "false");
        RunHistory history = new RunHistory();
        RunResult run = runner.listener(history).run().runs().get(0);
        Stage stage = history.stage().orElseThrow();
        DetectionIntervals intervals = DetectionIntervals.of(run.events());
        List<FlightStretch> stretches = FlightStretch.of("quadrotor", run, stage);

        assertThat(run.events()).hasSizeGreaterThan(3);
        assertThat(stretches).hasSizeGreaterThan(2);
        assertThat(stretches.get(0).from()).isZero();
        for (int i = 0; i < stretches.size(); i++) {
            FlightStretch one = stretches.get(i);
            double end = i + 1 < stretches.size() ? stretches.get(i + 1).from() : run.simulated();
            double middle = 0.5 * (one.from() + end);
            assertThat(one.path().get(0)).isEqualTo(stage.positionOf("quadrotor", one.from()));
            assertThat(one.path().get(one.path().size() - 1).distance(stage.positionOf("quadrotor", end)))
                    .isLessThan(1e-6);
            assertThat(one.sensors())
                    .containsExactlyElementsOf(run.settings().enabledSensors().keySet().stream()
                            .filter(sensor -> intervals.isDetected(sensor, "quadrotor", middle))
                            .toList());
            if (i > 0) {
                assertThat(one.sensors()).isNotEqualTo(stretches.get(i - 1).sensors());
                assertThat(run.events().stream().map(FlightStretchTest::arrival))
                        .contains(one.from());
            }
        }
    }

    private static double arrival(DetectionEvent event) {
        return event.observation().arrival();
    }
}
