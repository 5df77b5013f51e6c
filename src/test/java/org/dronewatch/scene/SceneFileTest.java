package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.mesh.io.UpAxis;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scenes.PackagedScene;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.acoustic.energy.EnergyModel;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.camera.PixelThreshold;
import org.dronewatch.setting.InputException;
import org.dronewatch.sound.BandFractions;
import org.dronewatch.sound.BandLevels;
import org.dronewatch.sound.surface.AbsorptionAtAngle;
import org.dronewatch.sound.surface.OwnSurface;
import org.dronewatch.sound.surface.SurfaceMaterial.Wall;
import org.dronewatch.world.SurfaceSettings;
import org.dronewatch.world.WorldSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A scene that a person writes as a file is the one that a class would describe, and every mistake has its place. */
class SceneFileTest {
    private static final String SITE = "world: {models: [packaged:hill.obj]}\n";

    @TempDir
    private Path directory;

    private SceneSettings read(String text) throws IOException {
        Path file = directory.resolve("site.yaml");
        Files.writeString(file, text);
        return new SceneFile(file).describe();
    }

    private String refused(String text) throws IOException {
        Path file = directory.resolve("site.yaml");
        Files.writeString(file, text);
        SceneFile scene = new SceneFile(file);
        try {
            scene.describe();
        } catch (InputException e) {
            return e.getMessage().replace(file.toString(), "site.yaml");
        }
        throw new AssertionError("accepted: " + text);
    }

    @ParameterizedTest
    @ValueSource(strings = {"closed-space", "camera-range", "acoustic-range", "multi-sensor"})
    void thePackagedExperimentsAreTheSameFromFileAndClass(String name) {
        SceneFile fromFile = new SceneFile(Path.of("scenes", name + ".yaml"));
        Scene fromClass = PackagedScene.find(name).orElseThrow().factory().get();

        assertThat(fromFile.name()).isEqualTo(fromClass.name());
        assertThat(new SceneRunner(fromFile).settingsOfRuns())
                .usingRecursiveComparison()
                .withComparatorForType((a, b) -> Math.abs(a - b) <= 1e-12 * Math.abs(b) ? 0 : 1, Double.class)
                .ignoringFields("sweep")
                .isEqualTo(new SceneRunner(fromClass).settingsOfRuns());
    }

    /** Sight from the very plane of the ground is hidden by the ground; sound is heard from just above it. */
    @Test
    void whoSeesFromTheVeryGroundIsWarnedOf() throws IOException {
        Files.writeString(directory.resolve("flat.obj"), "v -500 -500 0\nv 500 -500 0\nv 0 500 0\nf 1 2 3\n");
        Files.writeString(
                directory.resolve("site.yaml"),
                """
                world:
                  models: [{file: flat.obj, upAxis: z}]
                  surfaces: {materials: {default: grass_turf}}
                drones:
                  drone:
                    model: packaged:quadrotor.obj
                    flight: {kind: hover, position: [30, 0, 20]}
                sensors:
                  camera: {kind: camera, position: [0, 0, 0], aim: {kind: target, lookAt: [30, 0, 20]}}
                  microphone: {kind: acoustic, position: [0, 0, 0], propagation: {kind: energy-model}}
                run: {duration: 0.3 s}
                """);
        List<String> notes = new ArrayList<>();
        List<Observation> heard = new ArrayList<>();
        new SceneRunner(new SceneFile(directory.resolve("site.yaml")))
                .notes(notes::add)
                .onFrame(frame -> heard.addAll(frame.observations()))
                .run();

        assertThat(notes)
                .filteredOn(note -> note.startsWith("warning"))
                .containsExactly("warning: sensor 'camera' at (0.000, 0.000, 0.000) m lies on a surface, which"
                        + " may hide everything from it: move the sensor a millimetre away");
        assertThat(heard)
                .filteredOn(observation -> observation.sensor().equals("microphone"))
                .isNotEmpty()
                .allMatch(observation -> observation.value() > 30.0);
    }

    @Test
    void surfacesMayBeWrittenInTheScene() throws IOException {
        SceneSettings scene = read(
                """
                world:
                  models: [packaged:hill.obj]
                  surfaces:
                    materials: {grass: foam, rock: panel}
                    own:
                      panel: {absorption: 30 %, scattering: [0, 0, 0, 0, 0.5, 0.5, 1, 1], transmissionLoss: 20 dB, wall: solid}
                      foam: {absorptionByAngle: [{angle: 0, absorption: 0.9}, {angle: 60 deg, absorption: 0.5}]}
                """);

        SurfaceSettings surfaces = SurfaceSettings.DEFAULT
                .withOwn(
                        "panel",
                        OwnSurface.absorbing(0.3)
                                .withScattering(BandFractions.of(0, 0, 0, 0, 0.5, 0.5, 1, 1))
                                .withTransmissionLoss(BandLevels.flat(20), Wall.SOLID))
                .withOwn(
                        "foam",
                        OwnSurface.DEFAULT.withAbsorptionByAngle(List.of(
                                new AbsorptionAtAngle(0, BandFractions.flat(0.9)),
                                new AbsorptionAtAngle(Math.toRadians(60), BandFractions.flat(0.5)))))
                .with("grass", "foam")
                .with("rock", "panel");
        assertThat(scene.world().surfaces()).isEqualTo(surfaces);
        assertThat(surfaces.of("rock").transmitted(3)).isEqualTo(0.01);
        assertThat(surfaces.leftOver(List.of("grass", "rock", "other"))).containsExactly("other");
        assertThat(surfaces.unused(List.of("rock"))).containsExactly("foam");
    }

    @Test
    void whoNamesASurfaceThatIsNotThereIsToldWhere() {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(
                        () -> read(
                                """
                        world:
                          models: [packaged:hill.obj]
                          surfaces:
                            materials: {grass: foma}
                            own: {foam: {absorption: 0.9}}
                        """))
                .withMessageContaining(":4:24: world.surfaces: materials.grass: unknown material 'foma'")
                .withMessageEndingWith("the scene defines foam");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "{panel: {absorptionByAngle: []}} | :4:38: world.surfaces.own.panel.absorptionByAngle: absorption by"
                        + " angle needs at least one angle",
                "{'': {absorption: 0.5}} | world.surfaces: own: a surface needs a name, not ''"
            })
    void aSurfaceNeedsANameAndATableAtLeastOneAngle(String own, String told) throws IOException {
        assertThat(refused("world:\n  models: [packaged:hill.obj]\n  surfaces:\n    own: " + own + "\n"))
                .contains(told)
                .hasLineCount(1);
    }

    @Test
    void whatIsLeftOutIsAsInJava() throws IOException {
        SceneSettings scene = read(
                """
                world:
                  models: [packaged:hill.obj]
                drones:
                  one:
                    model: packaged:quadrotor.obj
                    flight: {kind: hover, position: [1, 2, 3]}
                sensors:
                  eye: {kind: camera, position: [0, 0, 10]}
                  ear: {kind: acoustic, position: [0, 0, 11]}
                """);

        Position place = new Position(1, 2, 3);
        DroneSettings drone = DroneSettings.of(ModelSettings.packaged("quadrotor.obj"), Hover.at(place));
        assertThat(scene.world()).isEqualTo(WorldSettings.of(ModelSettings.packaged("hill.obj")));
        assertThat(scene.drones()).containsEntry("one", drone);
        assertThat(scene.sensors())
                .containsEntry("eye", CameraSettings.at(new Position(0, 0, 10)))
                .containsEntry("ear", AcousticSettings.at(new Position(0, 0, 11)));
        assertThat(scene.run()).isEqualTo(RunSettings.DEFAULT);
        assertThat(scene.sweep()).isEmpty();
    }

    @Test
    void everyFieldMayBeSaidWithItsUnit() throws IOException {
        Files.createDirectories(directory.resolve("models"));
        Files.writeString(directory.resolve("models/site.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        SceneSettings scene = read(
                """
                world:
                  models:
                    - {file: models/site.obj, upAxis: z, scale: 0.001, position: [1 km, 0, 5], heading: 90 deg}
                  backgroundNoise: 41.5 dB
                  noiseShape: [0, -3, -6, -9, -12, -15, -18, -21]
                  atmosphere: {temperature: -5 degC, humidity: 40 %, pressure: 950 hPa}
                drones: {}
                sensors:
                  eye:
                    kind: camera
                    position: 0, 0, 10
                    aim: {azimuth: 180 deg, elevation: -0.1}
                    fovAxis: horizontal
                    detection: {pixels: 20}
                  ear:
                    kind: acoustic
                    position: {x: 1, y: 2, z: 3}
                    propagation: {roulette: 0.25, diffraction: iso9613}
                run: {duration: 2 min, seed: 7}
                """);

        ModelSettings model = scene.world().models().get(0);
        assertThat(model.upAxis()).isEqualTo(UpAxis.Z);
        assertThat(model.position()).isEqualTo(new Position(1000, 0, 5));
        assertThat(model.heading()).isEqualTo(Math.toRadians(90));
        assertThat(scene.world().atmosphere().temperature()).isEqualTo(268.15);
        assertThat(scene.world().atmosphere().pressure()).isEqualTo(95_000);
        CameraSettings eye = (CameraSettings) scene.sensors().get("eye");
        assertThat(eye.aim()).isEqualTo(new Aim.Direction(Math.PI, -0.1));
        assertThat(eye.detection()).isEqualTo(new PixelThreshold(20));
        AcousticSettings ear = (AcousticSettings) scene.sensors().get("ear");
        assertThat(ear.position()).isEqualTo(new Position(1, 2, 3));
        assertThat(((EnergyModel) ear.propagation()).roulette()).isEqualTo(0.25);
        assertThat(scene.run()).isEqualTo(new RunSettings(120, 7));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "wordl: {}                                      | 2:1: unknown setting 'wordl'; did you mean 'world'?",
                "run: {duration: 0}                             | 2:17: run.duration: duration 0 s must be above 0",
                "run: {duration: 1 kg}                          | 2:17: run.duration: '1 kg': 'kg' is not a unit of duration",
                "run: {duration: }                              | 2:16: run.duration: is empty",
                "run: {seed: 1.5}                               | 2:13: run.seed: '1.5' is not a whole number",
                "run: [1, 2]                                    | 2:6: run: must not be a list",
                "run: {duration: 1, duration: 2}                | 2:20: 'duration' is given twice",
                "run: *nothing                                  | 2:6: alias '*nothing' must come after the end of",
                "run: !!java.net.URL [x]                        | 2:6: tag 'tag:yaml.org,2002:java.net.URL' is"
                        + " not allowed",
                "drones: {a: {speed: 5}}                        | 2:13: drones.a: needs 'model'",
                "drones: {a: {model: ../x.obj, flight: {}}}     | 2:21: drones.a.model.file: file '../x.obj' must be a relative path",
                "drones: {a: {model: /x.obj, flight: {}}}       | 2:21: drones.a.model.file: file '/x.obj' must be a relative path",
                "drones: {a: {model: x.obj, flight: {}}}        | 2:21: drones.a.model.file: file 'x.obj' does"
                        + " not exist",
                "drones: {a: {model: packaged:hill.obj, flight: {kind: hoover}}} | did you mean 'hover'?",
                "drones: {a: {model: packaged:hill.obj, flight: {kind: zigzagging}}} | track); a kind from another jar needs that jar",
                "sensors: {a: {kind: microphone}}               | unknown kind 'microphone'; did you mean 'acoustic'?",
                "sensors: {a: {kind: radio}}                    | unknown kind 'radio'; did you mean 'rf'?",
                "drones: {a: {model: packaged:hill.obj, flight: {kind: inbound, nearst: 5}}} | did you mean 'standoff'?",
                "drones: {a: {model: packaged:hill.obj, flight: {}}}             | needs a 'kind': one of"
                        + " hover, approach",
                "sensors: {a: {kind: camera}}                   | 2:14: sensors.a: needs 'position'",
                "sensors: {a: {position: [1, 2, 3]}}            | 2:14: sensors.a: needs a 'kind'",
                "sensors: {a: {kind: camera, use: blighter-a400}} | sensors.a.kind: is 'camera', but"
                        + " 'blighter-a400' is of kind",
                "sensors: {a: {kind: radar, position: [1, 2, 3], budget: {power: 4 W}}} | sensors.a.budget:"
                        + " needs 'gain'",
                "sensors: {a b: {kind: camera, position: [1, 2, 3]}} | id 'a b' must be 1 to 64 letters",
                "sensors: {a: {kind: camera, position: [1, 2]}} | 2:39: sensors.a.position: '1, 2' has 2 numbers",
                "sensors: {a: {kind: camera, position: [1, [2], 3]}} | 2:43: sensors.a.position: must be a number",
                "drones: {a: {model: packaged:hill.obj, tones: {rotorSpeed: 1000000 rpm}}} | drones.a.tones.rotorSpeed:"
                        + " rotorSpeed 1000000 rpm must be above 0 and at most 60000 rpm",
                "drones: {a: {model: packaged:hill.obj, tones: {rotorSpeed: 0 Hz}}} | rotorSpeed 0 Hz must be above 0"
                        + " and at most 1000",
                "sweep: {parameter: run.seed, values: 3}        | 2:38: sweep.values: must be a list",
            })
    void aMistakeIsToldWithItsPlace(String line, String told) throws IOException {
        assertThat(refused(SITE + line + "\n")).contains(told).contains("site.yaml");
    }

    @Test
    void allMistakesAreToldAtOnceInTheOrderOfTheFile() throws IOException {
        String told = refused(
                """
                world:
                  models: [packaged:hill.obj]
                  backgroundNoise: 500
                drones:
                  one: {flight: {kind: hover, position: [1]}, speed: -1}
                sensors:
                  eye: {kind: camera, position: [1, 2, 3], width: 0, height: many}
                """);

        assertThat(told.lines().map(line -> line.split(" ")[0]))
                .containsExactly(
                        "site.yaml:3:20:",
                        "site.yaml:5:8:",
                        "site.yaml:5:41:",
                        "site.yaml:5:54:",
                        "site.yaml:7:51:",
                        "site.yaml:7:62:");
    }

    @Test
    void aSweepIsAListOrARange() throws IOException {
        SceneSettings list = read(SITE + "sweep: {parameter: world.backgroundNoise, values: [20 dB, 30]}");
        assertThat(noises(list)).containsExactly(20.0, 30.0);
        SceneSettings range = read(SITE + "sweep: {parameter: world.backgroundNoise, from: 30 dB, to: 20, count: 3}");
        assertThat(noises(range)).containsExactly(30.0, 25.0, 20.0);
    }

    private Iterable<Double> noises(SceneSettings written) {
        assertThat(written.sweep()).isPresent();
        return new SceneRunner(new SceneFile(directory.resolve("site.yaml")))
                .settingsOfRuns().stream()
                        .map(run -> run.world().backgroundNoise())
                        .toList();
    }

    @Test
    void whatIsNoFileIsRefused() {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> new SceneFile(directory.resolve("none.yaml")).describe())
                .withMessageContaining("no such file");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> new SceneFile(directory).describe())
                .withMessageContaining("is a directory");
    }
}
