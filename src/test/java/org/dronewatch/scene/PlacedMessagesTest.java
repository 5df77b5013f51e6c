package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A message about a file says in which line, also when the mistake shows only later than in reading. */
class PlacedMessagesTest {
    @TempDir
    private Path directory;

    private SceneRunner runner(String more) throws IOException {
        Files.writeString(directory.resolve("square.obj"), "v 0 0 0\nv 9 0 0\nv 0 0 9\nf 1 2 3\n");
        Files.writeString(directory.resolve("broken.obj"), "v 0 0 0\nv 9 0 0\nf 1 2 7\n");
        Path file = Files.writeString(
                directory.resolve("site.yaml"),
                "world:\n  models: [square.obj]\nsensors:\n  eye: {kind: camera, position: [0, 0, 9]}\n" + more);
        return new SceneRunner(new SceneFile(file));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            sweep: {parameter: sensors.eye.width, values: [10, 20.5]} | site.yaml:5:52 | not a whole number
            sweep: {parameter: sensors.eye.width, values: [10, 0]} | site.yaml:5:52 | must be 1 to
            sweep: {parameter: sensors.eye.widht, values: [10]} | site.yaml:5:20 | no 'widht'
            sweep: {parameter: sensors.eye.width, from: a, to: b, count: 2} | site.yaml:5:45 | not a number
            alert: {rule: {kind: several-sensors, count: 3}} | site.yaml:5:46 | at most 1
            prices: {sensors: {eyes: 3}} | site.yaml:5:26 | no such sensor
            drones: {d: {model: 'packaged:nosuch.obj', flight: {kind: hover, position: [0, 0, 9]}}} | site.yaml:5:21 | nosuch.obj
            drones: {d: {model: broken.obj, flight: {kind: hover, position: [0, 0, 9]}}} | site.yaml:5:21 | broken.obj:3
            """)
    void aMistakeThatShowsLaterHasItsLineToo(String line, String place, String what) throws IOException {
        SceneRunner runner = runner(line + "\n");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> runner.stage(runner.settingsOfRuns().get(0)))
                .withMessageContaining(place + ": ")
                .withMessageContaining(what);
    }

    @Test
    void anOverrideNamesTheOption() throws IOException {
        SceneRunner wrong = runner("").set("sensors.eye.width", "0");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(wrong::settings)
                .withMessageStartingWith("--set sensors.eye.width=0: width 0 px must be 1 to");
        SceneRunner missing = runner("").set("world.models.0.file", "nosuch.obj");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> missing.stage(missing.settings()))
                .withMessageStartingWith("--set world.models.0.file=nosuch.obj: world.models.0: ");
    }

    /** The override is innocent of a file that is broken, and the file of one that an override names. */
    @ParameterizedTest
    @CsvSource({"scale, 2", "heading, 90 deg", "upAxis, z"})
    void anOverrideBesideTheFileIsNotBlamedForIt(String setting, String value) throws IOException {
        Files.writeString(directory.resolve("torn.obj"), "v 0 0 0\nv 9 0 0\nf 1 2 7\n");
        Path file = Files.writeString(directory.resolve("torn.yaml"), "world:\n  models: [{file: torn.obj}]\n");
        SceneRunner runner = new SceneRunner(new SceneFile(file)).set("world.models.0." + setting, value);
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> runner.stage(runner.settings()))
                .withMessageContaining("torn.yaml:2:12: world.models.0: ")
                .withMessageNotContaining("--set");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(
                        () -> runner.set("world.models.0.file", "nosuch.obj").stage(runner.settings()))
                .withMessageStartingWith("--set world.models.0.file=nosuch.obj: world.models.0: ");
    }

    @Test
    void wholeNumbersAreSwept() throws IOException {
        SceneRunner widths = runner("sweep: {parameter: sensors.eye.width, from: 100, to: 500, count: 5}\n");
        assertThat(widths.settingsOfRuns())
                .extracting(settings -> settings.sweep().orElseThrow().valueIn(settings))
                .isEqualTo(List.of(100, 200, 300, 400, 500));
        SceneRunner seeds = runner("sweep: {parameter: run.seed, from: 1, to: 3, count: 3}\n");
        assertThat(seeds.settingsOfRuns())
                .extracting(settings -> settings.run().seed())
                .containsExactly(1L, 2L, 3L);
    }
}
