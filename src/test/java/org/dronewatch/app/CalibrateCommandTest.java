package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronewatch.Thorough;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.catalog.CatalogEntry;
import org.dronewatch.catalog.CatalogEntry.PublishedRange;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.Light;
import org.dronewatch.world.WorldSettings;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A calibrated sensor has the range to which it was fitted, and other conditions move it as they move a real one. */
class CalibrateCommandTest {
    /** Flown between two looks, m: 5 m/s, ten looks a second. */
    private static final double LOOK = 0.5;

    private static final double NOISE = 30.0;

    @TempDir
    private Path directory;

    @BeforeEach
    void anOpenSite() throws IOException {
        // Nothing is in the open but a triangle of a square metre, 30 km away.
        write("far.obj", "v 30000 0 30000\nv 30001 0 30000\nv 30000 0 30002\nf 1 2 3\n");
        for (String sensor : List.of(
                "level: {kind: acoustic, position: [0, 0, 20]}",
                "energy: {kind: acoustic, position: [0, 0, 20], propagation: energy-model}",
                "rf: {kind: rf, position: [0, 0, 20], rate: 10 Hz}",
                "camera: {kind: camera, position: [0, 0, 20], aim: {azimuth: 30 deg, elevation: 0}, fov: 10 deg}",
                "judge: {kind: camera, position: [0, 0, 20], detection: target-task}",
                "radar: {use: blighter-a400, position: [0, 0, 20]}")) {
            write(sensor.replaceFirst(":.*", "") + "-scene.yaml", scene(sensor, 100));
        }
    }

    private void write(String name, String text) throws IOException {
        Files.writeString(directory.resolve(name), text);
    }

    /** A drone that comes to the sensor from 30 degrees east of north. */
    private static String scene(String sensor, double from) {
        return "world: {models: [far.obj], surfaces: {materials: {default: solid}}, backgroundNoise: " + NOISE + "}\n"
                + "drones:\n  drone:\n    model: packaged:quadrotor.obj\n    speed: 5 m/s\n"
                + "    flight: {kind: approach, from: " + place(from) + ", to: " + place(0.5 * from) + "}\n"
                + "sensors:\n  " + sensor + "\nrun: {duration: " + 0.5 * from / 5.0 + "}\n";
    }

    private static String place(double range) {
        return "[" + 0.5 * range + ", " + Math.sqrt(0.75) * range + ", 20]";
    }

    private Outcome calibrate(String sensor, String range, String... more) {
        Stream<String> words = Stream.of(
                "calibrate",
                directory.resolve(sensor + "-scene.yaml").toString(),
                "--sensor",
                sensor,
                "--drone",
                "drone",
                "--range",
                range,
                "--out",
                directory.resolve("fitted.yaml").toString());
        return Program.run(Stream.concat(words, Stream.of(more)).toArray(String[]::new));
    }

    /** The range of the first detection in a run with the fitted sensor, which ends there. */
    private double firstRange(double from, String... settings) throws IOException {
        String aim = Files.readString(directory.resolve("fitted.yaml")).contains("kind: camera")
                ? ", aim: {azimuth: 30 deg, elevation: 0}"
                : "";
        write("open.yaml", scene("s: {use: fitted, position: [0, 0, 20]" + aim + "}", from));
        List<Observation> seen = new ArrayList<>();
        SceneRunner runner = new SceneRunner(new SceneFile(directory.resolve("open.yaml")));
        for (String setting : settings) {
            runner.set(setting.replaceFirst("=.*", ""), setting.replaceFirst(".*=", ""));
        }
        runner.onFrame(frame -> seen.addAll(frame.observations()))
                .cancelWhen(() -> !seen.isEmpty() && seen.get(seen.size() - 1).isDetected())
                .run();
        return seen.stream()
                .filter(Observation::isDetected)
                .findFirst()
                .orElseThrow(() -> new AssertionError("never detected, last " + seen.get(seen.size() - 1)))
                .range();
    }

    private static void assertWithinALook(double found, double range) {
        assertThat(found).isBetween(range - LOOK, range + 1e-4);
    }

    @Thorough
    @ParameterizedTest
    @CsvSource({"level, 120.3", "level, 60", "energy, 120.3", "energy, 400", "rf, 900.1", "rf, 77"})
    void aRunInTheOpenGivesTheRange(String sensor, double range) throws IOException {
        assertThat(calibrate(sensor, range + " m")).extracting(Outcome::code).isEqualTo(0);

        assertWithinALook(firstRange(1.5 * range), range);
        // A look is half a metre: the fit itself is closer than that.
        assertThat(firstRange(range + 1e-3)).isCloseTo(range, within(0.51));
    }

    /** Level model: W - m r falls by 5 dB in 5 dB / m. */
    @Test
    void moreNoiseShortensTheRangeOfTheLevelModelByTheAttenuation() throws IOException {
        calibrate("level", "300 m");

        assertWithinALook(firstRange(320, "world.backgroundNoise=" + (NOISE + 5.0)), 300.0 - 5.0 / 0.05);
    }

    /** Energy model: spreading and absorption by ISO 9613-1, added up over A-weighted octave bands. */
    @Thorough
    @Test
    void moreNoiseShortensTheRangeOfTheEnergyModelBySpreadingAndAir() throws IOException {
        double range = 300.0;
        double wanted = aWeighted(range) + 5.0;
        double near = 1.0;
        double far = range;
        while (far - near > 1e-9) {
            double middle = 0.5 * (near + far);
            near = aWeighted(middle) > wanted ? middle : near;
            far = aWeighted(middle) > wanted ? far : middle;
        }
        // Neither spreading alone nor the attenuation of one band gives it.
        assertThat(near).isBetween(range * Math.pow(10.0, -0.25) + 5.0, range - 5.0);
        calibrate("energy", range + " m");

        assertWithinALook(firstRange(320, "world.backgroundNoise=" + (NOISE + 5.0)), near);
    }

    private static double aWeighted(double range) {
        List<Double> power = DroneSettings.of(
                        ModelSettings.packaged("quadrotor.obj"),
                        new FlightPathSettings.Hover(new Position(0, 0, 0), 0.0))
                .soundPower();
        double sum = 0.0;
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            double level = power.get(band)
                    - 10.0 * Math.log10(4.0 * Math.PI * range * range)
                    - Atmosphere.STANDARD.attenuation(OctaveBands.midband(band)) * range
                    + OctaveBands.aWeight(band);
            sum += Math.pow(10.0, 0.1 * level);
        }
        return 10.0 * Math.log10(sum);
    }

    /** Radio: 20 lg r rises by 5 dB. */
    @Test
    void moreNoiseShortensTheRangeOfAReceiverAsInFreeSpace() throws IOException {
        calibrate("rf", "900 m");

        assertWithinALook(firstRange(920, "sensors.s.noiseFigure=11"), 900.0 * Math.pow(10.0, -5.0 / 20.0));
    }

    @Test
    void aCameraSaysWhatRangeItsWholePixelsGive() throws IOException {
        Outcome outcome = calibrate("camera", "150 m");
        List<String> lines = outcome.out().lines().toList();

        assertThat(lines).hasSize(3);
        assertThat(lines.get(1)).endsWith("(fitted)");
        double[] ranges = lines.stream()
                .mapToDouble(line -> Double.parseDouble(line.replaceFirst(".*: ([0-9.]+) m.*", "$1")))
                .toArray();
        assertThat(ranges[0]).isGreaterThan(ranges[1]);
        assertThat(ranges[1]).isGreaterThan(ranges[2]);
        for (double other : ranges) {
            assertThat(Math.abs(ranges[1] - 150.0)).isLessThanOrEqualTo(Math.abs(other - 150.0));
        }
        double[] pixels = lines.stream()
                .mapToDouble(line -> Double.parseDouble(line.replaceFirst("detection.pixels ([0-9]+) px.*", "$1")))
                .toArray();
        assertThat(pixels).containsExactly(pixels[1] - 1, pixels[1], pixels[1] + 1);
        for (int i = 0; i < 3; i++) {
            // A look may fall on a position farther out at which the drone happens to cover a pixel more, but for one
            // of a pixel fewer.
            assertThat(firstRange(200, "sensors.s.detection.pixels=" + pixels[i]))
                    .as("%s px", pixels[i])
                    .isBetween(ranges[i] - LOOK, i == 0 ? 1.03 * ranges[0] : ranges[i - 1]);
        }
    }

    /** Neither its path nor the sensors that cue the camera can be in a file that is for any scene. */
    @Test
    void aCuedCameraIsFittedToADroneOfASwarm() throws IOException {
        String camera =
                "cued: {kind: camera, width: 640, height: 360, fov: 10 deg, position: [0, 0, 20], aim: {azimuth: 30"
                        + " deg, elevation: 0}, positioner: {cues: [radar], panSpeed: 30 deg/s}}\n"
                        + "  radar: {use: blighter-a400, position: [0, 0, 20]}";
        write("cued-scene.yaml", scene(camera, 100).replace("    speed:", "    swarm: {count: 3}\n    speed:"));
        Outcome outcome = Program.run(
                "calibrate",
                directory.resolve("cued-scene.yaml").toString(),
                "--sensor",
                "cued",
                "--drone",
                "drone-2",
                "--range",
                "80 m",
                "--out",
                directory.resolve("fitted.yaml").toString());
        assertThat(outcome.code()).as(outcome.err()).isZero();
        CatalogEntry entry = Catalog.beside(directory).entry("fitted").orElseThrow();

        assertThat(entry.sensor().mapping("positioner").orElseThrow().values()).containsOnlyKeys("panSpeed");
        assertThat(entry.ranges().get(0).drone().orElseThrow().values()).containsKey("speed");
        assertThat(entry.sensor().values()).containsKey("rate");
        assertThat(entry.note()).contains("for a drone that approaches at 5 m/s, and for a look rate of 10 Hz. ");
        double stated = entry.ranges().get(0).distance();
        assertThat(firstRange(stated + 0.02)).isBetween(stated - LOOK, stated + 0.02);
    }

    /** There the drone fills a large part of the image, and nothing nearer is looked at. */
    @Thorough
    @Test
    void aCameraCanBeFittedToTheNearestRange() {
        Outcome outcome =
                calibrate("camera", "1 m", "--set", "sensors.camera.width=240", "--set", "sensors.camera.height=135");

        assertThat(outcome.code()).isZero();
        assertThat(outcome.out()).containsPattern("px: 1\\.00\\d m \\(fitted\\)");
    }

    /** Noise is nothing to a camera; with twice the focal length the same pixels are seen from twice as far. */
    @Test
    void theRangeOfACameraFollowsItsFocalLengthAndNotTheNoise() throws IOException {
        calibrate("camera", "150 m");
        double range = firstRange(200);

        assertThat(firstRange(200, "world.backgroundNoise=" + (NOISE + 5.0))).isEqualTo(range);
        double half = 2.0 * Math.atan(0.5 * Math.tan(Math.toRadians(5.0)));
        assertThat(firstRange(400, "sensors.s.fov=" + half)).isCloseTo(2.0 * range, within(0.01 * 2.0 * range));
    }

    /**
     * One pixel changes the range by several metres: the entry states what it has, and how far it is from what was
     * asked.
     */
    @Thorough
    @ParameterizedTest
    @CsvSource({"150", "90", "40"})
    void theEntryOfACameraStatesTheRangeThatARunGives(double asked) throws IOException {
        Outcome outcome = calibrate("camera", asked + " m");
        CatalogEntry entry = Catalog.beside(directory).entry("fitted").orElseThrow();
        double stated = entry.ranges().get(0).distance();

        assertThat(outcome.out().lines().filter(line -> line.endsWith("(fitted)")))
                .singleElement()
                .asString()
                .contains(String.format(Locale.ROOT, ": %.3f m ", stated));
        assertThat(stated).isNotEqualTo(asked);
        assertThat(entry.note())
                .endsWith(String.format(
                        Locale.ROOT,
                        "The fitted range is %.3f m %s than the %.0f m requested.",
                        Math.abs(stated - asked),
                        stated > asked ? "greater" : "less",
                        asked));
        // From there on it stays detected; begun a little farther out, no look falls on an isolated position beyond.
        assertThat(firstRange(stated + 0.02)).isBetween(stated - LOOK, stated + 0.02);
    }

    /** They belong to the place, and are heard through its models. */
    @Test
    void noiseSourcesAreLeftOutWithAWarning() throws IOException {
        for (String sensor : List.of("level", "camera")) {
            Path scene = directory.resolve(sensor + "-scene.yaml");
            Files.writeString(
                    scene,
                    Files.readString(scene)
                            .replace(
                                    ", backgroundNoise",
                                    ", noiseSources: {plant: {positions: [[9, 9, 9]], soundPowerLevel: 70, soundLevel: 70}}, backgroundNoise"));
        }
        Outcome microphone = calibrate("level", "120 m");

        assertThat(microphone.code()).isZero();
        assertThat(microphone.complaints())
                .contains("warning: world.noiseSources and all models are left out: the only noise is"
                        + " world.backgroundNoise");
        assertThat(calibrate("camera", "120 m").err()).doesNotContain("all models are left out");
    }

    @Test
    void ofASweepTheEntryIsForOneRunAndSaysWhich() throws IOException {
        Files.writeString(
                directory.resolve("level-scene.yaml"),
                "sweep: {parameter: world.backgroundNoise, values: [30, 25]}\n",
                StandardOpenOption.APPEND);
        assertThat(calibrate("level", "300 m").err())
                .contains("fitted for run 0 of the sweep, world.backgroundNoise=30 dB; --run chooses another");
        double threshold = threshold();
        Outcome second = calibrate("level", "300 m", "--run", "1");

        assertThat(second.err()).contains("fitted for run 1 of the sweep, world.backgroundNoise=25 dB\n");
        // 5 dB less of noise, 5 dB more above it at the same range.
        assertThat(threshold()).isCloseTo(threshold + 5.0, within(1e-5));
        PublishedRange range =
                Catalog.beside(directory).entry("fitted").orElseThrow().ranges().get(0);
        assertThat(range.target())
                .isEqualTo("drone 'drone' of level-scene, run 1 of the sweep, world.backgroundNoise=25 dB");
        assertThat(range.worldOf(ModelSettings.packaged("hill.obj")).backgroundNoise())
                .isEqualTo(25.0);
        assertThat(calibrate("level", "300 m", "--run", "2").complaints()).containsExactly("--run 2: must be 0 to 1");
        assertThat(calibrate("rf", "300 m", "--run", "1").complaints())
                .containsExactly("--run 1: must be 0, because no setting is swept");
    }

    private double threshold() {
        return Double.parseDouble(Catalog.beside(directory)
                .entry("fitted")
                .orElseThrow()
                .sensor()
                .text("threshold")
                .orElseThrow()
                .replace(" dB", ""));
    }

    /** Defaults too: another version, or another scene, may have others. */
    @Test
    void allConditionsAreStatedAndReadBack() throws IOException {
        calibrate(
                "energy",
                "200 m",
                "--set",
                "world.light.sun=200 deg, 55 deg",
                "--set",
                "world.atmosphere.temperature=278.15");
        String text = Files.readString(directory.resolve("fitted.yaml"));

        assertThat(text)
                .contains(
                        "      backgroundNoise: 30 dB\n",
                        "      noiseShape: [0, -4, -8, -12, -16, -20, -24, -28]\n",
                        "        temperature: 278.15 K\n",
                        "        wind: {speed: 0 m/s, from: 0 deg, roughness: 0.03 m}\n",
                        "      rain: 0 mm/h\n",
                        "illuminance: 5000 lx");
        assertThat(text).doesNotContain("far.obj", "solid");
        ModelSettings hill = ModelSettings.packaged("hill.obj");
        WorldSettings expected = WorldSettings.of(hill)
                .withBackgroundNoise(NOISE)
                .withAtmosphere(Atmosphere.STANDARD.withTemperature(278.15))
                .withLight(Light.DAY.withSun(new Light.Sun(Math.toRadians(200), Math.toRadians(55))));
        assertThat(Catalog.beside(directory)
                        .entry("fitted")
                        .orElseThrow()
                        .ranges()
                        .get(0)
                        .worldOf(hill))
                .isEqualTo(expected);
    }

    @Test
    void onlyWhatCalibrateWroteIsReplaced() throws IOException {
        Path file = directory.resolve("fitted.yaml");
        Files.writeString(file, "title: mine\n");
        String refusal = "--out " + file
                + ": already exists, and 'calibrate' did not write it: choose another file, or delete it";
        assertThat(calibrate("rf", "100 m")).satisfies(outcome -> {
            assertThat(outcome.code()).isEqualTo(2);
            assertThat(outcome.complaints()).containsExactly(refusal);
        });
        assertThat(file).hasContent("title: mine\n");

        Files.delete(file);
        assertThat(calibrate("rf", "100 m").code()).isZero();
        String first = Files.readString(file);
        assertThat(calibrate("rf", "200 m").code()).isZero();
        assertThat(Files.readString(file)).isNotEqualTo(first);
        assertThat(Program.run("save", "camera-range", "--out", file.toString()).complaints())
                .containsExactly(refusal.replace("'calibrate'", "'save'"));
    }

    @Test
    void theEntryStatesTheRangeWithItsConditions() throws IOException {
        calibrate("energy", "200 m", "--set", "world.rain=3", "--set", "drones.drone.soundPowerLevel=90");
        CatalogEntry entry = Catalog.beside(directory).entry("fitted").orElseThrow();

        PublishedRange range = entry.ranges().get(0);
        assertThat(range.distance()).isEqualTo(200.0);
        assertThat(range.droneOn(new FlightPathSettings.Hover(new Position(0, 0, 0), 0.0))
                        .soundPowerLevel())
                .isEqualTo(90.0);
        assertThat(range.worldOf(ModelSettings.packaged("hill.obj")).rain()).isEqualTo(3.0);
        assertThat(entry.sensor().values()).doesNotContainKeys("position", "aim");
        assertThat(firstRange(250, "drones.drone.soundPowerLevel=90")).isBetween(200.0 - LOOK, 200.001);
    }

    /**
     * Another version's default loudness would give the entry another range; what the sensor does not hear misleads.
     */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "level  | glideReduction: 30 dB, soundLevel: 60 dB",
                "energy | directivity: omnidirectional, glideReduction: 30 dB, sound: c1-quadrotor, soundPowerLevel: 85 dB",
                "rf     | ''",
                "camera | ''"
            })
    void ofTheDronesSoundTheEntryStatesWhatTheSensorHears(String sensor, String stated) throws IOException {
        calibrate(sensor, "60 m", "--set", "drones.drone.soundLevel=60");

        assertThat(sounds()).isEqualTo(stated);
    }

    @Test
    void theEntryOfASoundOfItsOwnStatesTheSpectrum() throws IOException {
        Path scene = directory.resolve("energy-scene.yaml");
        String shape = "spectrum: [0, -1, -2, -3, -4, -5, -6, -7]";
        Files.writeString(scene, Files.readString(scene).replace("    speed:", "    " + shape + "\n    speed:"));
        calibrate("energy", "60 m");

        assertThat(sounds()).endsWith("soundPowerLevel: 85 dB, " + shape);
    }

    /** The lines of the fitted entry that are of the drone's sound, in the order of the alphabet. */
    private String sounds() throws IOException {
        return Files.readAllLines(directory.resolve("fitted.yaml")).stream()
                .map(String::strip)
                .filter(line ->
                        line.matches("(sound|soundLevel|soundPowerLevel|glideReduction|spectrum|directivity|tones):.*"))
                .sorted()
                .collect(Collectors.joining(", "));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "level | 5 km | --range 5 km: 5000 m cannot be reached by sensor 'level': with threshold from 100 dB to"
                        + " -100 dB it detects drone 'drone' from 1 m to 2500 m",
                "judge | 100 m | --range 100 m: sensor 'judge' of kind camera has no threshold to fit: 'calibrate' is for"
                        + " acoustic and rf sensors, and for cameras with detection: pixel-threshold",
                "radar | 100 m | --range 100 m: sensor 'radar' of kind radar has no threshold to fit: 'calibrate' is for"
                        + " acoustic and rf sensors, and for cameras with detection: pixel-threshold",
                "rf | 0.5 m | --range 0.5 m: must be from 1 m to 100000 m",
                "rf | many | --range many: 'many' is not a number in m or another unit of length"
            })
    void whatCannotBeFittedIsRefusedInOneLine(String sensor, String range, String message) {
        Outcome outcome = calibrate(sensor, range);

        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.complaints()).containsExactly(message);
        assertThat(directory.resolve("fitted.yaml")).doesNotExist();
    }

    /** A refusal states what can be reached: up to there the camera is fitted, a little farther it is refused. */
    @Test
    void theIntervalOfARefusalIsWhatTheCameraCanReach() throws IOException {
        Outcome refused = calibrate("camera", "5 km");
        assertThat(refused.code()).isEqualTo(2);
        Matcher interval = Pattern.compile(
                        "--range 5 km: 5000 m cannot be reached by sensor 'camera': with detection.pixels from 2073600 px to"
                                + " 1 px it detects drone 'drone' from 1 m to ([0-9.]+) m")
                .matcher(refused.complaints().get(0));
        assertThat(interval.matches()).as(refused.err()).isTrue();
        double farthest = Double.parseDouble(interval.group(1));

        assertThat(calibrate("camera", farthest + 0.01 + " m").code()).isEqualTo(2);
        assertThat(directory.resolve("fitted.yaml")).doesNotExist();
        Outcome fitted = calibrate("camera", farthest - 0.01 + " m");
        assertThat(fitted.code()).as(fitted.err()).isZero();
        assertThat(fitted.out()).contains("detection.pixels 1 px: " + interval.group(1) + " m (fitted)");
        assertThat(firstRange(farthest + 0.002)).isBetween(farthest - LOOK, farthest + 0.001);
        // With 10 degrees across 1920 pixels one is 30 cm wide at 3300 m, 5.5 cm at 600 m.
        assertThat(farthest).isBetween(500.0, 4000.0);
    }

    @Test
    void aSilentDroneIsDetectedAtNoRange() {
        Outcome outcome = calibrate("rf", "100 m", "--set", "drones.drone.radio.control=fibre");

        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.complaints())
                .containsExactly(
                        "--range 100 m: 100 m cannot be reached by sensor 'rf': whatever its threshold, it does"
                                + " not detect drone 'drone' at 1 m or farther");
    }

    @Test
    void theSceneFileItselfIsNotReplaced() throws IOException {
        String scene = directory.resolve("rf-scene.yaml").toString();
        String before = Files.readString(Path.of(scene));
        Outcome outcome =
                Program.run("calibrate", scene, "--sensor", "rf", "--drone", "drone", "--range", "9 m", "--out", scene);

        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.err()).contains("is the scene file itself; choose another file");
        assertThat(Files.readString(Path.of(scene))).isEqualTo(before);
    }

    @Test
    void anUnreachableProbabilityIsRefused() {
        assertThat(calibrate("rf", "100 m", "--probability", "0").complaints())
                .containsExactly("--probability 0: must be above 0 and at most 1");
    }
}
