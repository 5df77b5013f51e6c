package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.dronewatch.Thorough;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A saved scene gives the same files. */
class SaveCommandTest {
    private static final List<String> SETTINGS =
            List.of("--set", "run.duration=3", "--set", "drones.quadrotor.flight.from.y=30 m");

    @TempDir
    private Path directory;

    private String command(int code, Stream<String> words) {
        String[] all = words.toArray(String[]::new);
        Program.Outcome outcome = Program.run(all);
        assertThat(outcome.code()).as("%s: %s", List.of(all), outcome.err()).isEqualTo(code);
        return outcome.err();
    }

    private String path(String name) {
        return directory.resolve(name).toString();
    }

    private void run(String scene, List<String> settings, String out) {
        Stream<String> run = Stream.of("run", scene, "--observations", "--out", path(out));
        command(0, Stream.concat(run, settings.stream()));
    }

    private String text(String file) throws IOException {
        return Files.readString(directory.resolve(file));
    }

    @Thorough
    @Test
    void aSavedSceneGivesTheSameBytes() throws IOException {
        run("camera-range", SETTINGS, "packaged");
        command(
                0,
                Stream.concat(
                        Stream.of("save", "camera-range", "--out", path("camera-range.yaml")), SETTINGS.stream()));
        run(path("camera-range.yaml"), List.of(), "saved");

        for (String file : List.of("observations.csv", "detections.csv", "result.json")) {
            assertThat(text("saved/" + file)).as(file).isEqualTo(text("packaged/" + file));
        }
    }

    @Test
    void theSceneFileItselfIsNotReplaced() throws IOException {
        command(0, Stream.of("save", "camera-range", "--out", path("scene.yaml")));
        String before = text("scene.yaml");
        Files.createSymbolicLink(directory.resolve("link.yaml"), directory.resolve("scene.yaml"));

        for (String scene : List.of("scene.yaml", "link.yaml")) {
            for (String out : List.of("scene.yaml", "link.yaml")) {
                assertThat(command(2, Stream.of("save", path(scene), "--set", "run.seed=9", "--out", path(out))))
                        .isEqualToIgnoringNewLines(
                                "--out " + path(out) + ": is the scene file itself; choose another file");
            }
        }
        assertThat(text("scene.yaml")).isEqualTo(before);
    }

    @Test
    void onlyASavedSceneIsReplaced() throws IOException {
        Files.writeString(directory.resolve("mine.yaml"), "# my scene\nworld: {models: [packaged:hill.obj]}\n");
        Files.createSymbolicLink(directory.resolve("link.yaml"), Path.of("mine.yaml"));
        for (String out : List.of("mine.yaml", "link.yaml")) {
            assertThat(command(2, Stream.of("save", "camera-range", "--out", path(out))))
                    .isEqualToIgnoringNewLines("--out " + path(out)
                            + ": already exists, and 'save' did not write it: choose another file, or delete it");
        }
        assertThat(text("mine.yaml")).startsWith("# my scene\n");

        command(0, Stream.of("save", "camera-range", "--out", path("saved.yaml")));
        command(0, Stream.of("save", "acoustic-range", "--out", path("saved.yaml")));
        assertThat(text("saved.yaml")).startsWith("# acoustic-range, as saved by dronewatch: ");
    }

    /** Two names of one file are one target. */
    @Test
    void ofALinkTheSavedFileIsReplacedAndTheLinkStays() throws IOException {
        command(0, Stream.of("save", "camera-range", "--out", path("saved.yaml")));
        Path link = Files.createSymbolicLink(directory.resolve("link.yaml"), Path.of("saved.yaml"));
        command(0, Stream.of("save", "acoustic-range", "--out", link.toString()));

        assertThat(link).isSymbolicLink();
        assertThat(text("saved.yaml")).startsWith("# acoustic-range, as saved by dronewatch: ");

        Path lost = Files.createSymbolicLink(directory.resolve("lost.yaml"), Path.of("nowhere.yaml"));
        assertThat(command(2, Stream.of("save", "camera-range", "--out", lost.toString())))
                .isEqualToIgnoringNewLines("--out " + lost
                        + ": is a link to a file that does not exist: choose another file, or delete the" + " link");
        assertThat(directory.resolve("nowhere.yaml")).doesNotExist();
    }

    @Test
    void aRunThatTheSweepDoesNotHaveIsRefused() {
        assertThat(command(2, Stream.of("save", "camera-range", "--run", "5", "--out", path("a.yaml"))))
                .contains("--run 5: must be 0 to 4");
        assertThat(command(2, Stream.of("save", "multi-sensor", "--run", "1", "--out", path("a.yaml"))))
                .contains("--run 1: must be 0, because no setting is swept");
    }

    @Thorough
    @Test
    void oneRunOfASweepGivesItsRows() throws IOException {
        run("camera-range", SETTINGS, "sweep");
        command(
                0,
                Stream.concat(
                        Stream.of("save", "camera-range", "--run", "2", "--out", path("third.yml")),
                        SETTINGS.stream()));
        run(path("third.yml"), List.of(), "third");

        for (String file : List.of("observations.csv", "detections.csv")) {
            List<String> rows = text("sweep/" + file)
                    .lines()
                    .filter(row -> row.startsWith("2,"))
                    .map(row -> row.replaceFirst("^2", "0"))
                    .toList();
            assertThat(text("third/" + file).lines().skip(1))
                    .as(file)
                    .isNotEmpty()
                    .isEqualTo(rows);
        }
    }

    @Test
    void theSeedIsSaved() throws IOException {
        command(0, Stream.of("save", "acoustic-range", "--seed", "77", "--out", path("a.yaml")));

        assertThat(text("a.yaml")).contains("\n  seed: 77\n");
    }

    @Test
    void whatCannotBeWrittenIsRefusedInOneLineAndNothingIsWritten() throws IOException {
        assertRefused("must end in .yaml or .yml", "save", "camera-range", "--out", path("scene.txt"));
        assertRefused("--run 5: must be 0 to 4", "save", "camera-range", "--run", "5", "--out", path("s.yaml"));
        assertRefused(
                "which is not one of the kinds camera, acoustic, radar, rf, thermal, cannot be written to a file",
                "save",
                "org.dronewatch.app.FaultyScenes$Asserting",
                "--out",
                path("s.yaml"));
        assertRefused("there is no directory", "save", "camera-range", "--out", path("none/s.yaml"));
    }

    private void assertRefused(String part, String... words) throws IOException {
        String err = command(2, Stream.of(words));
        assertThat(err.strip()).contains(part).doesNotContain("\n");
        try (Stream<Path> left = Files.list(directory)) {
            assertThat(left).isEmpty();
        }
    }
}
