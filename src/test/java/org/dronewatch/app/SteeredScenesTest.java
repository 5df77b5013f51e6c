package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.dronewatch.app.Program.Outcome;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Steered drones at the command line: what nobody steers, or steers wrongly, is one line and exit code 2. */
class SteeredScenesTest {
    @TempDir
    private Path directory;

    private Path scene() throws IOException {
        Path file = directory.resolve("steered.yaml");
        return Files.writeString(
                file,
                """
                world: {models: [packaged:house.obj]}
                drones:
                  guard: {model: packaged:quadrotor.obj, flight: {kind: steered, start: [0, 30, 20]}}
                sensors:
                  camera: {kind: camera, position: [0, 0, 20]}
                """);
    }

    @ParameterizedTest
    @ValueSource(strings = {"check", "run", "render"})
    void aSteeredDroneWithoutAPilotIsRefused(String command) throws IOException {
        Path out = directory.resolve(command.equals("run") ? "results" : "picture.png");
        String scene = scene().toString();
        Outcome outcome =
                switch (command) {
                    case "check" -> Program.run("check", scene);
                    case "run" -> Program.run("run", scene, "--out", out.toString());
                    default ->
                        Program.run("render", scene, "--camera", "camera", "--time", "1", "--out", out.toString());
                };
        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.out()).isEmpty();
        assertThat(outcome.err())
                .isEqualTo(
                        scene + ":3:50: drones.guard.flight: is steered, but no pilot steers 'guard': set a pilot with"
                                + " SceneRunner.pilot(...), override pilot() in a Java scene, steer from a DSOL model"
                                + " that holds the scene, or use another kind of flight" + System.lineSeparator());
        assertThat(out).doesNotExist();
    }

    /** The file is complete, but nothing in it could steer the drone. */
    @Test
    void saveNotesThatAFileHasNoPilot() throws IOException {
        Path saved = directory.resolve("saved.yaml");
        Outcome outcome = Program.run("save", scene().toString(), "--out", saved.toString());
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.err())
                .contains(
                        "drones.guard.flight: is steered by a program, which a scene file cannot contain: use another kind"
                                + " of flight before you run the file");
        assertThat(saved).content().contains("steered");
    }

    @Test
    void checkKnowsThePilotOfAJavaScene() {
        Outcome outcome = Program.run("check", FaultyScenes.WrongPilot.class.getName());
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.out()).startsWith("wrong-pilot is valid: 1 model, 1 drone");
    }

    @Test
    void whatAPilotDoesWrongIsOneLine() {
        Outcome outcome = Program.run(
                "run",
                FaultyScenes.WrongPilot.class.getName(),
                "--out",
                directory.resolve("results").toString());
        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.complaints())
                .containsExactly(
                        "warning: the pilot schedules 1 action, at 25.0 s, after the end of the run at"
                                + " 5.0 s: it has no effect",
                        "drone 'drone' at 2.0 s: where a steered drone will be at 9.0 s is not known at 2.0 s");
        assertThat(directory.resolve("results")).doesNotExist();
    }

    @Test
    void whatAPilotThrowsIsOneLineToo() {
        Path results = directory.resolve("results");
        Outcome outcome = Program.run("run", FaultyScenes.FailingPilot.class.getName(), "--out", results.toString());
        assertThat(outcome.code()).isEqualTo(2);
        String lost = FaultyScenes.class.getName() + "$Lost";
        assertThat(outcome.complaints())
                .singleElement()
                .asString()
                .startsWith(
                        "pilot " + lost + " at 3.03 s: java.lang.IllegalStateException: lost its way, at " + lost + ".")
                .matches(".*\\(FaultyScenes\\.java:\\d+\\)");
        assertThat(results).doesNotExist();
    }
}
