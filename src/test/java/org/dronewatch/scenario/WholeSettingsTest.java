package org.dronewatch.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scenes.CameraRange;
import org.dronewatch.scenes.ClosedSpace;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.SettingsPath;
import org.dronewatch.world.WorldSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Who sets a part of what is not set, or the kind of something, is told what works instead. */
class WholeSettingsTest {
    private static final Pattern EXAMPLE = Pattern.compile("as in ([^=]+)=(\\S+)$");

    private static SceneSettings set(String path, String value) {
        return new SceneRunner(new CameraRange()).set(path, value).settings();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "world.light.sun.azimuth | 200deg | there is no 'azimuth'; 'world.light.sun' is not set: first set all of azimuth,"
                        + " elevation, in this order, as in world.light.sun=10deg,10deg",
                "drones.quadrotor.swarm.count | 3 | there is no 'count'; 'drones.quadrotor.swarm' is not set: first set count, as in"
                        + " drones.quadrotor.swarm=10",
                "world.origin.latitude | 50deg | there is no 'latitude'; 'world.origin' is not set: only a scene file can set it",
                "drones.quadrotor.flight.kind | recorded | only a scene file can change the kind of"
                        + " 'drones.quadrotor.flight', since each kind needs its own settings",
                "sensors.camera.detection.kind | target-task | set 'sensors.camera.detection' itself to pixel-threshold or"
                        + " target-task",
                "sensors.camera.aim.kind | look-at | set 'sensors.camera.aim' itself to direction; a scene file can set it"
                        + " to any kind",
                "sensors.camera.kind | rf | set 'sensors.camera' itself to the name of a kind or of an entry of the"
                        + " catalogue",
            })
    void theMessageNamesTheWay(String path, String value, String message) {
        assertThatThrownBy(() -> set(path, value))
                .isInstanceOf(InputException.class)
                .hasMessage("--set setting '" + path + "': " + message);
    }

    @Test
    void anEmptyListHasNoIndices() {
        SettingsPath path = new SettingsPath("models.0.file");

        assertThatThrownBy(() -> path.read(WorldSettings.of(List.of())))
                .isInstanceOf(InputException.class)
                .hasMessageEndingWith("no '0'; 'models' is an empty list");
    }

    @ParameterizedTest
    @CsvSource({
        "world.light.sun.azimuth",
        "drones.quadrotor.swarm.count",
        "drones.quadrotor.spectrum.hz63",
        "drones.quadrotor.tones.blades"
    })
    void theExampleWorks(String path) {
        assertThatThrownBy(() -> set(path, "1")).satisfies(refused -> {
            Matcher example = EXAMPLE.matcher(refused.getMessage());
            assertThat(example.find()).as(refused.getMessage()).isTrue();
            assertThat(set(example.group(1), example.group(2))).isNotEqualTo(new CameraRange().describe());
        });
    }

    @Test
    void theKindsThatAreNamedWork() {
        assertThat(set("sensors.camera.detection", "target-task")).isNotEqualTo(new CameraRange().describe());
        SceneSettings swapped =
                new SceneRunner(new ClosedSpace()).set("sensors.camera", "rf").settings();
        assertThat(swapped.sensors().get("camera").kind()).isEqualTo("rf");
    }
}
