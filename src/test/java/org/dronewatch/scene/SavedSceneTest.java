package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.examples.GateWatch;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.RunReport;
import org.dronewatch.run.DetectionEvent;
import org.dronewatch.run.Frame;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scenes.CameraRange;
import org.dronewatch.scenes.PackagedScene;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.camera.DetectionFunction;
import org.dronewatch.sensor.camera.DroneView;
import org.dronewatch.sensor.radar.LinkBudget;
import org.dronewatch.sensor.radar.RadarSettings;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** What is saved is read again as it was, and runs as it did. */
class SavedSceneTest {
    /** The project's scenes and their files: a scene is saved beside its models. */
    @TempDir
    private static Path copies;

    private static final Path PROJECT = Path.of("scenes");

    /** How long a scene may run in every build, s; with {@code -Ddronewatch.scenes=all}, as long as it takes. */
    private static final double SHORT = 1.0;

    @TempDir
    private Path directory;

    private SceneRunner saved(SceneRunner runner, SceneSettings settings) throws IOException {
        return saved(runner, settings, directory);
    }

    private static SceneRunner saved(SceneRunner runner, SceneSettings settings, Path folder) throws IOException {
        Path file = folder.resolve("saved.yaml");
        return new SceneRunner(new SceneFile(Files.writeString(file, runner.text(settings, file))));
    }

    static Stream<Scene> scenes() throws IOException {
        List<Scene> scenes = new ArrayList<>();
        PackagedScene.all().forEach(scene -> scenes.add(scene.factory().get()));
        copyScenes(copies);
        files().forEach(name -> scenes.add(new SceneFile(copies.resolve(name))));
        scenes.add(new GateWatch());
        scenes.add(new Odd());
        scenes.add(new Swept());
        return scenes.stream();
    }

    /** The files of the project's scenes, by name. */
    static Stream<String> files() throws IOException {
        try (Stream<Path> files = Files.list(PROJECT)) {
            return files
                    .map(file -> file.getFileName().toString())
                    .filter(name -> name.endsWith(".yaml"))
                    .filter(name -> !name.endsWith(".campaign.yaml") && !name.endsWith(".place.yaml"))
                    // That is no scene but an entry of a catalogue, which one of the scenes uses.
                    .filter(name -> !name.equals("roof-camera.yaml"))
                    .sorted()
                    .toList()
                    .stream();
        }
    }

    private static void copyScenes(Path target) throws IOException {
        try (Stream<Path> files = Files.list(PROJECT)) {
            for (Path file : files.toList()) {
                Files.copy(file, target.resolve(file.getFileName()), StandardCopyOption.REPLACE_EXISTING);
            }
        }
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void everySceneReadsBackAsItWas(Scene scene) throws IOException {
        SceneRunner runner = new SceneRunner(scene);
        SceneSettings settings = runner.settings();

        assertThat(saved(runner, settings, copies).settings()).isEqualTo(settings);
        List<SceneSettings> runs = runner.settingsOfRuns();
        assertThat(saved(runner, settings, copies).settingsOfRuns()).isEqualTo(runs);
        SceneSettings last = runs.get(runs.size() - 1);
        assertThat(saved(runner, last, copies).settings()).isEqualTo(last);
        assertThat(saved(runner, last, copies).settingsOfRuns()).containsExactly(last);
    }

    /** Numbers without a short decimal form, a sensor that is off, prices, a positioner, names that need quotes. */
    private static final class Odd extends Scene {
        private static final long serialVersionUID = 1L;

        @Override
        protected void build() {
            loadWorld(loadPackaged("hill.obj").withHeading(Math.PI / 7.0).withScale(0.1 + 0.2));
            surface("null", "grass_turf");
            surface("a: \"b\" #c, [d] \u00fc \u2028\ud83d\ude00", "brick_rough");
            setRain(1.0 / 3.0);
            setBackgroundNoise(Math.nextUp(31.0));
            add(
                    "drone",
                    DroneSettings.of(loadPackaged("quadrotor.obj"), Hover.at(new Position(-0.0, 1e-300, 4e3 / 7.0)))
                            .withSpeed(Math.E));
            Position mast = new Position(0, 0, 144);
            add(
                    "radar",
                    RadarSettings.at(mast, LinkBudget.DataSheet.of(1234.5, 0.01))
                            .withFieldOfView(1.1, 0.3));
            add("eye", CameraSettings.at(mast).withHorizontalFov(Math.toRadians(33.3)));
            add("off", Catalog.packaged().settings("spotterrf-c550", Map.of("position", mast)));
            disable("off");
            setAlert(AlertSettings.DEFAULT);
            setRun(RunSettings.DEFAULT.withDuration(1.0).withSeed(123_456_789_012_345_678L));
        }
    }

    private static final class Swept extends Scene {
        private static final long serialVersionUID = 1L;

        @Override
        protected void build() {
            loadWorld(loadPackaged("hill.obj"));
            add("drone", DroneSettings.of(loadPackaged("quadrotor.obj"), Hover.at(new Position(0, 20, 144))));
            add("eye", CameraSettings.at(new Position(0, 0, 144)));
            setRun(RunSettings.DEFAULT.withDuration(0.3));
            sweep("sensors.eye.rate", 5.0, 10.0, 1.0 / 3.0);
        }
    }

    private static List<Observation> observations(SceneRunner runner) {
        List<Observation> all = new ArrayList<>();
        runner.onFrame((Frame frame) -> all.addAll(frame.observations())).run();
        return all;
    }

    /** Scenes, with how long they run and what brings something into range by then. */
    static Stream<Arguments> shortRuns() {
        return Stream.of(
                Arguments.of(new GateWatch(), List.of("run.duration=5")),
                Arguments.of(new Odd(), List.of()),
                Arguments.of(new Swept(), List.of()));
    }

    @ParameterizedTest
    @MethodSource("shortRuns")
    void aSavedSceneRunsToTheSameBytes(Scene scene, List<String> changes) throws IOException {
        SceneRunner runner = new SceneRunner(scene);
        for (String change : changes) {
            String[] parts = change.split("=", 2);
            runner.set(parts[0], parts[1]);
        }
        Path file = directory.resolve(scene.name() + ".yaml");
        Files.writeString(file, runner.text(runner.settings(), file));
        Map<String, String> expected = written(scene, runner, "given");

        assertThat(expected.get("observations.csv").lines()).as("looks").hasSizeGreaterThan(3);
        Scene read = new SceneFile(file);
        assertThat(written(read, new SceneRunner(read), "read")).isEqualTo(expected);
    }

    @ParameterizedTest
    @MethodSource("files")
    void aSceneOfTheProjectRunsToTheSameBytes(String name) throws IOException {
        copyScenes(directory);
        Path file = directory.resolve(name);
        Scene scene = new SceneFile(file);
        SceneRunner runner = new SceneRunner(scene);
        String saved = runner.text(runner.settings(), file);
        if (!"all".equals(System.getProperty("dronewatch.scenes"))) {
            runner.cancelWhen(new Deadline());
        }
        Map<String, String> expected = written(scene, runner, "given");

        assertThat(expected.get("observations.csv").lines()).as("looks").hasSizeGreaterThan(3);
        assertThat(saved).isNotEqualTo(Files.readString(file));
        Scene read = new SceneFile(Files.writeString(file, saved));
        assertThat(written(read, new SceneRunner(read), "read")).isEqualTo(expected);
    }

    /** Has passed a while after it was first asked. */
    private static final class Deadline implements BooleanSupplier {
        private long start;

        @Override
        public boolean getAsBoolean() {
            start = start == 0 ? System.nanoTime() : start;
            return System.nanoTime() - start > SHORT * 1e9;
        }
    }

    /** The run's number differs, which alone is the first, and the seed, which is the run's and not the sweep's. */
    @Test
    void theThirdValueOfASweepRunsAloneToTheSameBytes() throws IOException {
        Scene scene = new CameraRange();
        SceneRunner sweep = new SceneRunner(scene)
                .set("run.duration", "2")
                .set("drones.quadrotor.flight.from.y", "40 m")
                .only(2);
        Path file = directory.resolve(scene.name() + ".yaml");
        SceneSettings third = sweep.settingsOfRuns().get(2);
        Files.writeString(file, sweep.text(third, file));
        Map<String, String> expected = new TreeMap<>(written(scene, sweep, "given"));
        expected.replaceAll((name, text) -> name.endsWith(".csv") ? text.replaceAll("(?m)^2,", "0,") : text);
        Scene read = new SceneFile(file);
        Map<String, String> alone = written(read, new SceneRunner(read), "read");

        assertThat(alone.get("detections.csv").lines()).hasSizeGreaterThan(1);
        assertThat(alone.get("observations.csv")).isEqualTo(expected.get("observations.csv"));
        assertThat(alone.get("detections.csv")).isEqualTo(expected.get("detections.csv"));
        assertThat(alone.get("flights.csv")).isEqualTo(expected.get("flights.csv"));
        assertThat(alone.get("result.json"))
                .isEqualTo(expected.get("result.json")
                        .replace("\"run\" : 2,", "\"run\" : 0,")
                        .replace("\"seed\" : 1,", "\"seed\" : " + third.run().seed() + ","));
    }

    /** The files of a run that depend on neither time nor place. */
    private Map<String, String> written(Scene scene, SceneRunner runner, String name) throws IOException {
        Path target = directory.resolve(name);
        try (RunReport report = new RunReport(scene, target, true)) {
            SceneResult result = runner.listener(report).run();
            assumeTrue(result.complete(), "takes longer than a second: -Ddronewatch.scenes=all");
            // As if it had been cut short: without the page and its pictures, which are not compared.
            report.finish(withoutPage(result));
        }
        Map<String, String> texts = new TreeMap<>();
        for (String file : List.of("observations.csv", "detections.csv", "flights.csv", "result.json")) {
            texts.put(file, Files.readString(target.resolve(file)));
        }
        return texts;
    }

    private static SceneResult withoutPage(SceneResult result) {
        return new SceneResult(result.scene(), result.seed(), result.threads(), false, result.runs(), result.timing());
    }

    @Test
    void theThirdRunOfASweepRunsAloneAsItDidAmongTheOthers() throws IOException {
        SceneRunner sweep = new SceneRunner(new CameraRange())
                .set("run.duration", "2")
                .set("drones.quadrotor.flight.from.y", "40 m");
        SceneSettings third = sweep.settingsOfRuns().get(2);
        assertThat(third.run().seed()).isNotEqualTo(sweep.settings().run().seed());
        SceneRunner saved = saved(sweep, third);
        RunResult alone = saved.run().runs().get(0);
        RunResult among = sweep.only(2).run().runs().get(0);

        assertThat(alone.settings()).isEqualTo(among.settings());
        assertThat(alone.events().stream().map(DetectionEvent::observation))
                .isNotEmpty()
                .isEqualTo(
                        among.events().stream().map(DetectionEvent::observation).toList());
        assertThat(observations(saved)).isEqualTo(observations(sweep));
    }

    @Test
    void aJavaSceneRunsTheSameFromItsFile() throws IOException {
        SceneRunner java = new SceneRunner(new GateWatch()).set("run.duration", "5");

        List<Observation> expected = observations(java);
        assertThat(observations(saved(java, java.settings())))
                .isEqualTo(expected)
                .isNotEmpty();
    }

    @Test
    void sensorsOfACatalogueBesideTheSceneAreWrittenOut() throws IOException {
        Path site = Files.createDirectory(directory.resolve("site"));
        Files.writeString(
                site.resolve("gate-camera.yaml"),
                """
                title: Gate camera
                source: none
                basis: assumed
                coverage: ahead
                ranges: []
                sensor: {kind: camera, width: 640, height: 360}
                """);
        Path file = Files.writeString(
                site.resolve("scene.yaml"),
                """
                world: {models: [packaged:hill.obj]}
                sensors:
                  gate: {use: gate-camera, position: [0, 0, 144]}
                """);
        SceneRunner runner = new SceneRunner(new SceneFile(file));
        String text = runner.text(runner.settings(), directory.resolve("saved.yaml"));

        assertThat(text).contains("kind: camera", "width: 640").doesNotContain("use:");
        assertThat(saved(runner, runner.settings()).settings()).isEqualTo(runner.settings());
    }

    @Test
    void modelsAreFoundFromWhereTheFileIs() throws IOException {
        Path site = Files.createDirectories(directory.resolve("site/models"));
        Files.writeString(site.resolve("site.obj"), RandomScenes.MODEL_TEXT);
        Path file = Files.writeString(
                directory.resolve("site/scene.yaml"), "world: {models: [models/site.obj, packaged:house.obj]}\n");
        SceneRunner runner = new SceneRunner(new SceneFile(file));
        SceneSettings settings = runner.settings();

        assertThat(runner.text(settings, directory.resolve("site/other.yaml")))
                .contains("models: [models/site.obj, packaged:house.obj]");
        assertThat(runner.text(settings, directory.resolve("above.yaml")))
                .contains("models: [site/models/site.obj, packaged:house.obj]");
        assertThat(runner.text(settings, site.resolve("below.yaml")))
                .contains("models: [site.obj, packaged:house.obj]");
        SceneRunner above = saved(runner, settings);
        assertThat(above.stage(above.settings()).world().mesh().triangleCount())
                .isEqualTo(runner.stage(settings).world().mesh().triangleCount());

        Path elsewhere = Files.createDirectory(directory.resolve("elsewhere"));
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> runner.text(settings, elsewhere.resolve("s.yaml")))
                .withMessageContaining("world.models.0.file: file '")
                .withMessageContaining("write the scene into " + site + " or a directory above it");
    }

    @Test
    void whatNoFileCanNameIsRefused() {
        Path file = directory.resolve("saved.yaml");
        SceneRunner own = new SceneRunner(new HillScene());
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> own.text(own.settings(), file))
                .withMessage("sensors.dice: " + DiceSettings.class.getName()
                        + ", which is not one of the kinds camera, acoustic, radar, rf, thermal, cannot be written to a"
                        + " file");

        SceneRunner nameless = new SceneRunner(new Swept());
        SceneSettings settings = nameless.settings();
        CameraSettings eye = (CameraSettings) settings.sensors().get("eye");
        SceneSettings changed = settings.withSensor("eye", eye.withDetection(new AnyPixel()));
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> nameless.text(changed, file))
                .withMessageStartingWith(
                        "sensors.eye.detection: " + AnyPixel.class.getName() + ", which is not one of the kinds ");
    }

    private static final class AnyPixel implements DetectionFunction {
        @Override
        public double value(DroneView view) {
            return view.pixels();
        }

        @Override
        public double threshold() {
            return 1.0;
        }

        @Override
        public String unit() {
            return "px";
        }
    }

    @Test
    void numbersAreWrittenByNameAndWithTheirUnits() throws IOException {
        SceneRunner runner = new SceneRunner(new CameraRange())
                .set("sensors.camera.fov", "30 deg")
                .set("sensors.camera.projection.shiftUp", "0.2")
                .set("sensors.camera.projection.far", "0.2 km")
                .set("world.tracing.costs.traversal", "7")
                .set("world.light.sun", "200 deg, 55 deg");
        SceneSettings settings = runner.settings();

        assertThat(runner.text(settings, directory.resolve("saved.yaml")))
                .contains(
                        "    fov: 30 deg\n",
                        "    projection: {shiftUp: 0.2, far: 200 m}\n",
                        "    costs: {traversal: 7}\n",
                        "    sun: {azimuth: 200 deg, elevation: 55 deg}\n",
                        "    position: [0, 0, 144]\n");
        assertThat(saved(runner, settings).settings()).isEqualTo(settings);
    }

    @Test
    void theFileIsWrittenAsPeopleWouldWriteIt() {
        SceneRunner runner = new SceneRunner(new Swept());

        assertThat(runner.text(runner.settingsOfRuns().get(2), directory.resolve("saved.yaml")))
                .isEqualTo(
                        """
                        # swept, as saved by dronewatch: positions are in metres, levels of octave bands in decibels.
                        world:
                          models: [packaged:hill.obj]
                        drones:
                          drone:
                            model: packaged:quadrotor.obj
                            flight: {kind: hover, position: [0, 20, 144]}
                        sensors:
                          eye:
                            kind: camera
                            position: [0, 0, 144]
                            rate: 0.3333333333333333 Hz
                        run:
                          duration: 0.3 s
                          seed: 1454173614451846
                        sweep:
                          kind: values
                          parameter: sensors.eye.rate
                          values: [0.3333333333333333]
                        """);
    }
}
