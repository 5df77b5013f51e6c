package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.dronewatch.Thorough;
import org.dronewatch.app.Program.Outcome;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Former names of settings in every place where people write one: they work, with one warning a name. */
class RenamedSettingsTest {
    private static final String SCENE =
            """
            world:
              models: [packaged:hill.obj]
              surfaces:
                otherwise: brick_rough
            drones:
              visitor:
                model: packaged:quadrotor.obj
                flight: {kind: pop-up, position: [0, 60, 150], hidden: 1 s, height: 10 m}
            sensors:
              ear:
                kind: acoustic
                position: [0, 0, 146]
                rate: 1 Hz
                propagation: {kind: energy-model, rays: 20, mirrorOrder: 1}
              far-ear:
                kind: acoustic
                position: [5, 0, 146]
                rate: 1 Hz
                propagation: {kind: energy-model, rays: 20, mirrorOrder: 2}
            run: {duration: 2 s}
            sweep: {parameter: sensors.ear.propagation.mirrorOrder, values: [1, 2]}
            """;

    @TempDir
    private Path directory;

    private Path scene;

    @BeforeEach
    void write() throws IOException {
        scene = Files.writeString(directory.resolve("site.yaml"), SCENE);
    }

    private static String present(String text) {
        return text.replace("otherwise", "defaultSurface")
                .replace("hidden", "hoverTime")
                .replace("mirrorOrder", "imageSourceOrder");
    }

    private static List<String> warnings(Outcome outcome) {
        return outcome.err()
                .lines()
                .filter(line -> line.startsWith("warning: ") && line.contains("is now called"))
                .toList();
    }

    private String text(String file) throws IOException {
        return Files.readString(directory.resolve(file));
    }

    @Thorough
    @Test
    void aRunByFormerNamesWarnsOnceForEachAndGivesTheResultsOfThePresentOnes() throws IOException {
        Outcome former = Program.run("run", scene.toString(), "--observations", "--out", directory + "/former");
        assertThat(former.code()).as(former.err()).isZero();
        assertThat(warnings(former))
                .containsExactlyInAnyOrder(
                        "warning: " + scene + ":4:5: setting 'otherwise' is now called 'defaultSurface'",
                        "warning: " + scene + ":8:52: setting 'hidden' is now called 'hoverTime'",
                        "warning: " + scene
                                + ":14:49: setting 'mirrorOrder' is now called 'imageSourceOrder'"
                                + " (the former name is also used in 2 other places)");

        Files.writeString(scene, present(SCENE));
        Outcome now = Program.run("run", scene.toString(), "--observations", "--out", directory + "/now");
        assertThat(now.code()).as(now.err()).isZero();
        assertThat(warnings(now)).isEmpty();
        for (String file : List.of("observations.csv", "detections.csv", "result.json")) {
            assertThat(text("former/" + file)).as(file).isEqualTo(text("now/" + file));
        }
        assertThat(former.out()).isEqualTo(now.out()).contains("sensors.ear.propagation.imageSourceOrder=2");
    }

    @Test
    void anOptionMayUseAFormerName() throws IOException {
        Files.writeString(scene, present(SCENE));
        Outcome former = Program.run("check", scene.toString(), "--set", "world.surfaces.otherwise=solid");
        assertThat(former.code()).as(former.err()).isZero();
        assertThat(warnings(former))
                .containsExactly("warning: --set world.surfaces.otherwise: setting 'otherwise' is now called"
                        + " 'defaultSurface'");

        Outcome wrong = Program.run("check", scene.toString(), "--set", "world.surfaces.otherwise=brick_ruogh");
        assertThat(wrong.code()).isEqualTo(2);
        assertThat(wrong.err())
                .startsWith("--set world.surfaces.otherwise=brick_ruogh: ")
                .contains("brick_rough");
    }

    @Test
    void anOptionEndsTheSweepOfTheSameSettingByWhicheverName() {
        for (String name : List.of("mirrorOrder", "imageSourceOrder")) {
            Outcome outcome = Program.run("check", scene.toString(), "--set", "sensors.ear.propagation." + name + "=3");
            assertThat(outcome.out()).contains("2 sensors, 1 run of");
        }
    }

    @Test
    void twoOptionsForOneSettingByTwoNamesAreAMistake() {
        Outcome outcome = Program.run(
                "check",
                scene.toString(),
                "--set",
                "world.surfaces.otherwise=solid",
                "--set",
                "world.surfaces.defaultSurface=solid");
        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.complaints())
                .containsExactly("--set world.surfaces.defaultSurface: it is already given as --set"
                        + " world.surfaces.otherwise: both are names of the same setting, now called"
                        + " 'world.surfaces.defaultSurface'");
    }

    @Test
    void twoNamesInAFileAreAMistakeWithBothPlaces() throws IOException {
        Files.writeString(
                scene,
                SCENE.replace(
                        "    otherwise: brick_rough\n", "    otherwise: brick_rough\n    defaultSurface: solid\n"));
        Outcome outcome = Program.run("check", scene.toString());
        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.complaints())
                .containsExactly(scene + ":5:5: world.surfaces: 'defaultSurface' is also written under a former name;"
                        + " it is already given at " + scene + ":4:5");
    }

    @Test
    void aSavedSceneHasThePresentNames() throws IOException {
        Path saved = directory.resolve("saved.yaml");
        Outcome outcome = Program.run("save", scene.toString(), "--out", saved.toString());
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(warnings(outcome)).hasSize(3);
        assertThat(Files.readString(saved))
                .contains("defaultSurface: brick_rough")
                .contains("hoverTime: 1")
                .contains("parameter: sensors.ear.propagation.imageSourceOrder")
                .doesNotContain("otherwise", "hidden", "mirrorOrder");
        assertThat(warnings(Program.run("check", saved.toString()))).isEmpty();
    }

    @Test
    void aFileOfASensorMayUseAFormerName() throws IOException {
        Path entry = Files.writeString(
                directory.resolve("my-camera.yaml"),
                """
                title: mine
                source: none
                basis: assumed
                coverage: narrow
                ranges: []
                sensor:
                  kind: thermal
                  noise: 40 mK
                  leastSignal: 3
                """);
        Files.writeString(
                scene,
                """
                world: {models: [packaged:hill.obj]}
                sensors:
                  east: {use: my-camera, position: [0, 0, 146], netd: 60 mK}
                  west: {use: my-camera, position: [9, 0, 146]}
                  north: {kind: thermal, position: [9, 9, 146]}
                """);
        Path saved = directory.resolve("saved.yaml");
        String[] save = {"save", scene.toString(), "--set", "sensors.north=my-camera", "--out", saved.toString()};
        Outcome outcome = Program.run(save);
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(warnings(outcome))
                .containsExactlyInAnyOrder(
                        "warning: " + entry + ":8:3: setting 'noise' is now called 'netd'",
                        "warning: " + entry + ":9:3: setting 'leastSignal' is now called 'minSnr'");
        assertThat(Files.readString(saved).lines().filter(line -> line.matches(" *(netd|minSnr): .*")))
                .containsExactly(
                        "    netd: 0.06 K",
                        "    minSnr: 3",
                        "    netd: 0.04 K",
                        "    minSnr: 3",
                        "    netd: 0.04 K",
                        "    minSnr: 3");
    }
}
