package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.run.PairResult;
import org.dronewatch.run.SceneResult;
import org.dronewatch.run.SweepPoint;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Observation;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A sensor that is switched off observes nothing, and nobody else notices. */
class DisabledSensorTest {
    private static final Path LIMITS = Path.of("src/test/resources/fuzz/limits.yaml");

    @TempDir
    private Path directory;

    private static SceneRunner runner() {
        return new SceneRunner(new SceneFile(LIMITS));
    }

    private static List<Observation> observations(SceneRunner runner) {
        List<Observation> all = new ArrayList<>();
        runner.onFrame(frame -> all.addAll(frame.observations())).run();
        return all;
    }

    private Path file(String sensors) throws IOException {
        Files.copy(LIMITS.resolveSibling("square.obj"), directory.resolve("square.obj"));
        String drone = "drones: {d: {model: square.obj, flight: {kind: hover, position: [0, 30, 10]}}}";
        return Files.writeString(
                directory.resolve("site.yaml"),
                "world: {models: [square.obj]}\n" + drone + "\nrun: {duration: 0.5}\nsensors:\n" + sensors);
    }

    @ParameterizedTest
    @CsvSource({"eye", "ear", "radar"})
    void theOthersObserveExactlyWhatTheyDid(String off) {
        List<Observation> before = observations(runner());
        List<Observation> after = observations(runner().set("sensors." + off + ".enabled", "false"));

        assertThat(before).anyMatch(o -> o.sensor().equals(off));
        assertThat(after)
                .isEqualTo(before.stream().filter(o -> !o.sensor().equals(off)).toList())
                .isNotEmpty();
    }

    @Test
    void theHashOfTheSettingsKnowsWhatIsOff() {
        String all = runner().inputs().settingsHash();
        String withoutEye =
                runner().set("sensors.eye.enabled", "false").inputs().settingsHash();
        String withoutEar =
                runner().set("sensors.ear.enabled", "false").inputs().settingsHash();

        assertThat(withoutEye).isNotEqualTo(all).isNotEqualTo(withoutEar);
        assertThat(runner().set("sensors.eye.enabled", "true").inputs().settingsHash())
                .isEqualTo(all);
    }

    @Test
    void chanceIsTheSameForOthersOfTheSameKind() throws IOException {
        String dice =
                "{kind: camera, position: [0, 0, 9], width: 64, height: 48, detection: {kind: target-task, byChance: true}}";
        Path file = file("  a: " + dice + "\n  b: " + dice + "\n");
        List<Observation> before = observations(new SceneRunner(new SceneFile(file)));
        List<Observation> after = observations(new SceneRunner(new SceneFile(file)).set("sensors.a.enabled", "no"));

        assertThat(after)
                .isNotEmpty()
                .isEqualTo(before.stream().filter(o -> o.sensor().equals("b")).toList());
    }

    @Test
    void aFileSaysSoBesideTheOtherSettings() throws IOException {
        Path file = file("  off: {kind: camera, position: [0, 0, 9], enabled: false}\n"
                + "  mast: {use: spotterrf-c550, position: [0, 0, 9], enabled: false}\n"
                + "  on: {enabled: true, position: [0, 0, 9], kind: rf}\n");
        SceneRunner runner = new SceneRunner(new SceneFile(file));

        assertThat(runner.settings().disabled()).containsExactlyInAnyOrder("off", "mast");
        assertThat(runner.settings().sensors()).containsOnlyKeys("off", "mast", "on");
        assertThat(runner.settings().enabledSensors()).containsOnlyKeys("on");
        assertThat(runner.run().pairs()).extracting(PairResult::sensor).containsOnly("on");
        assertThat(runner.set("sensors.off.enabled", "true").run().pairs())
                .extracting(PairResult::sensor)
                .containsExactly("off", "on");
    }

    @Test
    void itsSettingsAreCheckedLikeThoseOfOthers() throws IOException {
        Path file = file("  off: {kind: camera, position: [0, 0, 9], enabled: false, width: 0}\n"
                + "  odd: {kind: camera, position: [0, 0, 9], enabled: perhaps}\n");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> new SceneRunner(new SceneFile(file)).settings())
                .withMessageContaining("site.yaml:5:67: sensors.off.width: width 0 px")
                .withMessageContaining("site.yaml:6:53: sensors.odd.enabled: 'perhaps' is neither true nor false");
    }

    @Test
    void cuesPricesAndAlertsMayNameIt() throws IOException {
        Path file = file("  radar: {use: spotterrf-c550, position: [0, 0, 9], enabled: false}\n"
                + "  eye: {kind: camera, position: [0, 0, 9], positioner: {cues: [radar]}}\n"
                + "alert: {rule: {kind: several-sensors, count: 2}}\nprices: {sensors: {radar: 100}}\n");
        SceneResult result = new SceneRunner(new SceneFile(file)).run();

        assertThat(result.firstDetectionRange("eye", "d")).isPresent();
        assertThat(result.alert("d").time()).isEmpty();
    }

    @Test
    void aSweepTriesASceneWithAndWithoutIt() throws IOException {
        Path file = file("  ear: {kind: acoustic, position: [0, 0, 9]}\n  eye: {kind: camera, position: [0, 0, 9]}\n"
                + "sweep: {parameter: sensors.eye.enabled, values: [true, false]}\n");
        SceneResult result = new SceneRunner(new SceneFile(file)).run();

        assertThat(result.pairs())
                .extracting(PairResult::run, PairResult::sensor)
                .map(Object::toString)
                .containsExactly("(0, \"ear\")", "(0, \"eye\")", "(1, \"ear\")");
        assertThat(result.sweep()).extracting(SweepPoint::value).containsExactly(true, true, false);
    }

    @Test
    void withAllOffNothingIsObserved() {
        SceneRunner runner = runner();
        runner().settings().sensors().keySet().forEach(id -> runner.set("sensors." + id + ".enabled", "false"));
        List<String> notes = new ArrayList<>();
        SceneResult result = runner.notes(notes::add).run();

        assertThat(result.complete()).isTrue();
        assertThat(result.pairs()).isEmpty();
        assertThat(notes).contains("warning: all sensors are switched off: nothing is observed");
    }

    @Test
    void whereASweepSwitchesTheLastOneOffTheWarningNamesTheRun() throws IOException {
        Path file = file("  eye: {kind: camera, position: [0, 0, 9]}\n"
                + "sweep: {parameter: sensors.eye.enabled, values: [true, false]}\n");
        List<String> notes = new ArrayList<>();
        new SceneRunner(new SceneFile(file)).notes(notes::add).run();

        assertThat(notes.stream().filter(note -> note.contains("switched off")))
                .containsExactly(
                        "warning: with sensors.eye.enabled=false all sensors are switched off: nothing is observed");
    }

    @Test
    void messagesThatListTheSettingsOfASensorNameTheSwitch() throws IOException {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> runner().set("sensors.eye.pixels", "1").settings())
                .withMessageContaining("'sensors.eye' has: position, ")
                .withMessageEndingWith(", enabled");
        Path file = file("  eye: {kind: camera, position: [0, 0, 9], enabeld: false}\n");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> new SceneRunner(new SceneFile(file)).settings())
                .withMessageContaining("sensors.eye: unknown setting 'enabeld'; did you mean 'enabled'? (position, ");
    }

    @Test
    void aSensorThatIsNotThereCannotBeSwitched() {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> runner().set("sensors.eyes.enabled", "false").settings())
                .withMessageContaining("no 'eyes'");
        SceneSettings settings = runner().settings();
        for (boolean enabled : new boolean[] {true, false}) {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> settings.withEnabled("eyes", enabled))
                    .withMessageStartingWith("sensor 'eyes' cannot be switched " + (enabled ? "on" : "off"));
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> SceneSettings.of(settings.world()).withEnabled("eye", enabled))
                    .withMessageEndingWith("the scene has no sensors");
        }
        assertThat(settings.withEnabled("eye", false).isEnabled("eye")).isFalse();
        assertThat(settings.withEnabled("eye", false).withEnabled("eye", true)).isEqualTo(settings);
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> runner().set("sensors.eye.enabled", "perhaps").settings())
                .withMessageContaining("sensors.eye.enabled=perhaps: 'perhaps' is neither true nor false");
    }

    /** A custom kind, which knows nothing of it, in a Java scene. */
    @Test
    void aKindOfOnesOwnIsSwitchedOffToo() {
        Scene scene = new Scene() {
            private static final long serialVersionUID = 1L;

            @Override
            protected void build() {
                loadWorld(loadPackaged("hill.obj"));
                add("d", DroneSettings.of(ModelSettings.packaged("quadrotor.obj"), Hover.at(new Position(0, 0, 200))));
                add("a", new DiceSettings(new Position(0, 0, 150), 2.0, 0.5));
                add("b", new DiceSettings(new Position(0, 0, 150), 2.0, 0.5));
                disable("a");
                setRun(RunSettings.DEFAULT.withDuration(1.0));
            }
        };
        List<Observation> off = observations(new SceneRunner(scene));
        List<Observation> on = observations(new SceneRunner(scene).set("sensors.a.enabled", "true"));

        assertThat(off).hasSize(3).allMatch(o -> o.sensor().equals("b"));
        assertThat(on).hasSize(6).containsAll(off);
    }
}
