package org.dronewatch.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.geometry.Position;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Aimed;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A system takes the place of another one by its name, as a sensor does. */
class SystemSwapTest {
    private static final Position MAST = new Position(1, 2, 30);
    private static final String SENTRY =
            "gate: {use: droneshield-sentry, position: [1, 2, 30], aim: {azimuth: 40 deg}}";

    @TempDir
    private Path directory;

    private SceneRunner scene(String... sensors) throws IOException {
        Path file = directory.resolve("scene.yaml");
        Files.writeString(
                file,
                """
                world: {models: [packaged:hill.obj]}
                drones: {a: {model: packaged:quadrotor.obj, flight: {kind: hover, position: [0, 9, 9]}}}
                sensors:
                """
                        + "  first: {kind: rf, position: [5, 5, 5]}\n  " + String.join("\n  ", sensors)
                        + "\n  last: {kind: rf, position: [6, 6, 6]}\n");
        return new SceneRunner(new SceneFile(file));
    }

    private static Aim aim(SensorSettings<?> sensor) {
        return sensor.as(Aimed.class).orElseThrow().aim();
    }

    @Test
    void theOtherSystemIsWhatAFileWouldHave() throws IOException {
        SceneSettings swapped = scene(SENTRY).set("sensors.gate", "liteye").settings();

        assertThat(swapped.sensors().keySet())
                .containsExactly("first", "gate-radar", "gate-camera", "gate-thermal", "last");
        assertThat(swapped)
                .isEqualTo(scene("gate: {use: liteye, position: [1, 2, 30], aim: {azimuth: 40 deg}}")
                        .settings());
        assertThat(((CameraSettings) swapped.sensors().get("gate-camera"))
                        .positioner()
                        .orElseThrow()
                        .cues())
                .containsExactly("gate-radar");
    }

    @Test
    void backAgainItIsTheSame() throws IOException {
        assertThat(scene(SENTRY.replace("droneshield-sentry", "liteye"))
                        .set("sensors.gate", "droneshield-sentry")
                        .settings())
                .isEqualTo(scene(SENTRY).settings());
    }

    @Test
    void aPartThatWasMovedKeepsItsPlaceAndAPartThatIsOffStaysOff() throws IOException {
        SceneSettings swapped = scene(SENTRY)
                .set("sensors.gate-camera.position.z", "33 m")
                .set("sensors.gate-camera.aim.azimuth", "50 deg")
                .set("sensors.gate-camera.enabled", "false")
                .set("sensors.gate-rf.enabled", "false")
                .set("sensors.gate", "liteye")
                .set("sensors.gate-thermal.rate", "2 Hz")
                .settings();

        assertThat(swapped.sensors().get("gate-camera").position()).isEqualTo(new Position(1, 2, 33));
        assertThat(aim(swapped.sensors().get("gate-camera"))).isEqualTo(new Aim.Direction(Math.toRadians(50), 0.0));
        assertThat(aim(swapped.sensors().get("gate-thermal"))).isEqualTo(new Aim.Direction(Math.toRadians(40), 0.0));
        assertThat(swapped.sensors().get("gate-thermal").rate()).isEqualTo(2.0);
        assertThat(swapped.disabled()).containsExactly("gate-camera");
    }

    @Test
    void aSensorTakesThePlaceOfASystemAndTheReverse() throws IOException {
        SceneSettings one = scene(SENTRY).set("sensors.gate", "blighter-a400").settings();
        Aim forty = new Aim.Direction(Math.toRadians(40), 0.0);
        assertThat(one.sensors().keySet()).containsExactly("first", "gate", "last");
        assertThat(one.sensors().get("gate"))
                .isEqualTo(Catalog.packaged().settings("blighter-a400", Map.of("position", MAST, "aim", forty)));

        SceneSettings several = scene("gate: {use: blighter-a400, position: [1, 2, 30], aim: {azimuth: 40 deg}}")
                .set("sensors.gate", "droneshield-sentry")
                .settings();
        assertThat(several).isEqualTo(scene(SENTRY).settings());
    }

    @Test
    void whatDoesNotFitIsRefused() throws IOException {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> scene(SENTRY).set("sensors.gate", "litey").settings())
                .withMessage("--set sensors.gate=litey: no sensor 'litey' in the catalogue; closest matches: liteye, "
                        + "camera, thermal");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> scene(
                                "gate: {use: blighter-a400, position: [0, 0, 9]}",
                                "gate-radar: {use: blighter-a400, position: [0, 0, 9]}")
                        .set("sensors.gate", "liteye")
                        .settings())
                .withMessage("--set sensors.gate=liteye: the scene already has a sensor 'gate-radar'");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> scene(
                                SENTRY, "eye: {kind: camera, position: [0, 0, 9], positioner: {cues: [gate-camera]}}")
                        .set("sensors.gate", "droneshield-v2")
                        .settings())
                .withMessageStartingWith(
                        "--set sensors.gate=droneshield-v2: sensors.eye.positioner.cues: sensor 'eye' is cued by"
                                + " 'gate-camera': there is no such sensor; closest matches: ");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> scene(SENTRY).set("sensors.gat", "liteye").settings())
                .withMessageStartingWith("--set setting 'sensors.gat': there is no 'gat'; 'sensors' has: ");
    }

    /** The runs of a sweep are compared sensor by sensor. */
    @Test
    void aSweepKeepsItsSensors() throws IOException {
        scene(SENTRY);
        Path file = directory.resolve("scene.yaml");
        String text = Files.readString(file);
        Files.writeString(file, text + "sweep: {parameter: sensors.first, values: [droneshield-rfone, liteye]}\n");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> new SceneRunner(new SceneFile(file)).settings())
                .withMessageContaining("sweep of sensors.first: ")
                .withMessageContaining("'liteye' is a system of several sensors");
    }
}
