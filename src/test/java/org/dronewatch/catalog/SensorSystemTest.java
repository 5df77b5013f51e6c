package org.dronewatch.catalog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Aimed;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.setting.FormerNames;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.file.SettingsFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Systems of several sensors, taken by one name. */
class SensorSystemTest {
    private static final Position MAST = new Position(1, 2, 30);

    @TempDir
    private Path directory;

    private SceneSettings scene(String sensors) throws IOException {
        Path file = directory.resolve("scene.yaml");
        Files.writeString(
                file,
                """
                world: {models: [packaged:hill.obj]}
                drones: {a: {model: packaged:quadrotor.obj, flight: {kind: hover, position: [0, 9, 9]}}}
                sensors:
                """
                        + sensors);
        return SettingsFile.read(
                file, SceneSettings.class, SensorKinds.kinds(Catalog.beside(directory)), new FormerNames());
    }

    @Test
    void allPartsAreWhereTheSystemIsAndAreThoseOfTheCatalogue() throws IOException {
        SceneSettings scene = scene("  eye: {kind: camera, position: [0, 0, 9]}\n"
                + "  gate: {use: droneshield-sentry, position: [1, 2, 30], aim: {azimuth: 40 deg}}\n");

        assertThat(scene.sensors().keySet())
                .containsExactly("eye", "gate-radar", "gate-rf", "gate-acoustic", "gate-camera", "gate-thermal");
        assertThat(scene.sensors().values())
                .extracting(SensorSettings::position)
                .endsWith(MAST, MAST, MAST);
        assertThat(scene.sensors().get("gate-acoustic"))
                .isEqualTo(Catalog.packaged().settings("droneshield-widealert", Map.of("position", MAST)));
        Aim aim =
                scene.sensors().get("gate-radar").as(Aimed.class).orElseThrow().aim();
        assertThat(scene.sensors().get("gate-radar"))
                .isEqualTo(Catalog.packaged().settings("droneshield-radarone", Map.of("position", MAST, "aim", aim)));
    }

    @Test
    void partsCueOneAnotherUnderTheirNewNames() throws IOException {
        SceneSettings scene = scene("  hill: {use: liteye, position: [1, 2, 30], aim: {azimuth: 0}}\n");

        CameraSettings camera = (CameraSettings) scene.sensors().get("hill-camera");
        assertThat(camera.positioner().orElseThrow().cues()).containsExactly("hill-radar");
    }

    @Test
    void aSystemIsSwitchedOffAsAWholeAndChangedInWhatItsPartsHave() throws IOException {
        SceneSettings off = scene("  gate: {use: droneshield-sentry, position: [1, 2, 30], enabled: false}\n");
        assertThat(off.disabled()).hasSize(5);
        SceneSettings slow = scene("  gate: {use: droneshield-sentry, position: [1, 2, 30], rate: 2 Hz}\n");
        assertThat(slow.sensors().values()).extracting(SensorSettings::rate).containsOnly(2.0);
    }

    @Test
    void aPartThatIsThereAlreadyAndASettingThatNoPartHasAreRefused() {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> scene("  gate-radar: {kind: radar, position: [0, 0, 9]}\n"
                        + "  gate: {use: droneshield-sentry, position: [1, 2, 30]}\n"))
                .withMessageContaining("sensors.gate-radar: is defined twice: once as a part of a system");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> scene("  gate: {use: droneshield-sentry, position: [1, 2, 30], colour: 1}\n"))
                .withMessageContaining("scene.yaml:4:")
                .withMessageContaining("sensors.gate-radar: unknown setting 'colour'");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> Catalog.packaged().settings("liteye", Map.of("position", MAST)))
                .withMessage(
                        "'liteye' is a system of several sensors: a scene file uses it with 'use: liteye', and --set"
                                + " sensors.ID=liteye replaces the sensor or system ID with it");
    }

    @Test
    void anEntryOfTheUserGoesBeforeASystemOfItsName() throws IOException {
        Files.writeString(
                directory.resolve("liteye.yaml"),
                """
                title: Our own
                source: measured
                basis: assumed
                coverage: wide
                ranges: []
                sensor: {kind: camera}
                """);
        assertThat(scene("  hill: {use: liteye, position: [1, 2, 30]}\n")
                        .sensors()
                        .keySet())
                .containsExactly("hill");
    }

    @ParameterizedTest
    @MethodSource("org.dronewatch.catalog.Catalog#systemNames")
    void everyPartIsAnEntryOfTheCatalogue(String name) {
        SensorSystem system = Catalog.system(name).orElseThrow();
        assertThat(system.source()).isNotBlank();
        assertThat(system.sensors()).isNotEmpty().allSatisfy((part, settings) -> assertThat(Catalog.packagedNames())
                .contains(settings.text("use").orElseThrow()));
    }
}
