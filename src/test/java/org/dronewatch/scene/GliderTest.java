package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.dronewatch.run.DetectionEvent;
import org.dronewatch.run.SceneResult;
import org.junit.jupiter.api.Test;

/** The attack that the thesis ends with: over cameras and microphones without motors. */
class GliderTest {
    private static final List<String> BLIND_AND_DEAF =
            List.of("north-east", "north", "north-west", "microphone", "radio");

    /** When it is over the house, s: it climbs for 268.3 m, then glides 607.6 m, at 15 m/s. */
    private static final double OVERHEAD = (268.3 + 607.6) / 15.0;

    private static SceneResult run(String... overrides) {
        SceneRunner runner = new SceneRunner(new SceneFile(Path.of("scenes", "glider.yaml")));
        for (String override : overrides) {
            runner.set(override.substring(0, override.indexOf('=')), override.substring(override.indexOf('=') + 1));
        }
        return runner.run();
    }

    @Test
    void isMissedByCamerasMicrophonesAndRadioAndFoundByARadar() {
        SceneResult result = run();
        for (String sensor : BLIND_AND_DEAF) {
            assertThat(result.firstDetectionRange(sensor, "glider")).as(sensor).isEmpty();
        }
        assertThat(result.firstDetectionRange("radar", "glider").orElseThrow()).isGreaterThan(600.0);
    }

    @Test
    void theCameraThatFacesSouthSeesItWhenItHasPassed() {
        DetectionEvent seen = run().runs().get(0).events().stream()
                .filter(event -> event.observation().sensor().equals("south"))
                .findFirst()
                .orElseThrow();

        assertThat(seen.observation().arrival()).isGreaterThan(OVERHEAD);
        assertThat(run("drones.glider.model=packaged:quadrotor.obj").firstDetectionRange("south", "glider"))
                .as("a smaller drone")
                .isEmpty();
    }

    @Test
    void itsMotorsWouldHaveGivenItAway() {
        assertThat(run("drones.glider.glideReduction=0").firstDetectionRange("microphone", "glider"))
                .isPresent();
    }

    @Test
    void soWouldARemoteControl() {
        assertThat(run("drones.glider.radio.control=radio").firstDetectionRange("radio", "glider"))
                .isPresent();
    }

    @Test
    void lowerAndWithinTheirFieldsOfViewTheCamerasSeeIt() {
        assertThat(run("drones.glider.flight.to=0, 20, 147").firstDetectionRange("north", "glider"))
                .isPresent();
    }
}
