package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.dronewatch.Thorough;
import org.dronewatch.app.Program.Child;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.report.RunReport;
import org.dronewatch.scenes.CameraRange;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Of two runs into one directory the second is refused; what a killed one left behind, the next one removes. */
class OneRunPerDirectoryTest {
    private static Path scene;

    @TempDir
    private Path directory;

    private Path results;

    @BeforeEach
    void place() {
        results = directory.resolve("results");
    }

    private Child startLongRun() throws IOException, InterruptedException {
        Child child = Program.startLongRun(directory);
        Path rows = directory.resolve(".partial-results/new/observations.csv");
        for (int i = 0; i < 600 && !(Files.exists(rows) && Files.size(rows) > 200); i++) {
            Thread.sleep(100);
        }
        assertThat(rows).exists();
        return child;
    }

    /** A scene whose run and report take little time. */
    @BeforeAll
    static void scene(@TempDir Path beside) throws IOException {
        Files.copy(Program.FUZZ.resolve("square.obj"), beside.resolve("square.obj"));
        scene = Files.writeString(
                beside.resolve("site.yaml"),
                """
                world: {models: [square.obj]}
                drones:
                  intruder: {model: packaged:quadrotor.obj, flight: {kind: hover, position: [0, 1250, 30]}}
                sensors:
                  eye: {kind: camera, position: [0, 1200, 6], width: 320, height: 240, aim: {lookAt: [0, 1250, 20]}}
                run: {duration: 1 s}
                """);
    }

    private static Outcome shortRun(Path target) {
        return Program.run("run", scene.toString(), "--out", target.toString());
    }

    private List<String> names() throws IOException {
        try (Stream<Path> files = Files.list(directory)) {
            return files.map(file -> file.getFileName().toString())
                    .filter(name -> !name.endsWith(".txt"))
                    .sorted()
                    .toList();
        }
    }

    @Thorough
    @Test
    void aDirectoryInUseIsRefusedAndTheRunThatHasItGoesOn() throws IOException, InterruptedException {
        try (Child child = startLongRun()) {
            for (int i = 0; i < 2; i++) {
                Outcome second = shortRun(results);
                assertThat(second.code()).isEqualTo(2);
                assertThat(second.complaints()).hasSize(1);
                assertThat(second.complaints().get(0)).contains(results.toString(), "in use by another run");
            }
            Path link = Files.createSymbolicLink(directory.resolve("link"), directory);
            assertThat(shortRun(link.resolve("results")).code()).isEqualTo(2);
            Files.delete(link);
            assertThat(shortRun(directory.resolve("others")).code()).isZero();
            assertThat(names()).containsExactly(".partial-results", "others");

            child.process().destroy();
            assertThat(child.await().code()).isEqualTo(143);
            assertThat(names()).containsExactly("others", "results");
        }
        assertThat(shortRun(results).code()).isZero();
        assertThat(names()).containsExactly("others", "results");
    }

    @Thorough
    @Test
    void whatAKilledRunLeftIsRemovedByTheNext() throws IOException, InterruptedException {
        try (Child child = startLongRun()) {
            child.process().destroyForcibly();
            assertThat(child.await().code()).isEqualTo(137);
        }
        assertThat(names()).containsExactly(".partial-results");
        Files.createDirectories(directory.resolve(".partial-results/old/plots"));
        assertThat(shortRun(directory.resolve("others")).code()).isZero();
        assertThat(names()).containsExactly(".partial-results", "others");

        assertThat(shortRun(results).code()).isZero();
        assertThat(names()).containsExactly("others", "results");
        assertThat(results.resolve("observations.csv")).doesNotExist();
    }

    @Test
    void alsoInOneProcess() throws IOException {
        try (RunReport first = new RunReport(new CameraRange(), results, false)) {
            assertThat(first).isNotNull();
            assertThat(shortRun(results).complaints())
                    .hasSize(1)
                    .first()
                    .asString()
                    .contains("in use");
            assertThat(shortRun(results).code()).isEqualTo(2);
        }
        assertThat(names()).isEmpty();
        assertThat(shortRun(results).code()).isZero();
    }

    @Test
    void aFileOfTheUsersInTheWayChangesNothing() throws IOException {
        assertThat(shortRun(results).code()).isZero();
        String before = Files.readString(results.resolve("summary.json"));
        Files.delete(results.resolve("result.json"));
        Files.createDirectory(results.resolve("result.json"));
        Files.writeString(results.resolve("result.json/mine.txt"), "mine");

        Outcome outcome = shortRun(results);
        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.complaints()).hasSize(1).first().asString().contains("result.json in it is a directory");
        assertThat(Files.readString(results.resolve("summary.json"))).isEqualTo(before);
        assertThat(results.resolve("result.json/mine.txt")).hasContent("mine");
        assertThat(names()).containsExactly("results");
    }
}
