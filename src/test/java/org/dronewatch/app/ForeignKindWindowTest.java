package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.dronewatch.viewer.UsedWindow;
import org.dronewatch.viewer.Viewer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * A window shows sensors of a kind that another jar has as it shows those of the library. It is opened in a process
 * with that jar, by the command, and used there as people use it.
 */
class ForeignKindWindowTest {
    /** Of the kind, in all pictures: the first that is not of a built-in kind. */
    private static final String COLOUR = "#008b8b";

    @TempDir
    private Path directory;

    private List<String> linesOf(String... arguments) throws IOException, InterruptedException {
        Path jar = ForeignProject.jar(directory.resolve("built"));
        List<String> options =
                List.of("-Xmx1g", "-Duser.home=" + directory.resolve("home"), "-Djava.awt.headless=false");
        try (Program.Child child = Program.startClass(UsedWindow.class, directory, List.of(jar), options, arguments)) {
            Program.Outcome outcome = child.await();
            assertThat(outcome.code()).as(outcome.err()).isZero();
            return outcome.out().lines().toList();
        }
    }

    @Test
    @Timeout(value = 4, unit = TimeUnit.MINUTES)
    void itIsShownSelectedAndSwapped() throws IOException, InterruptedException {
        assumeTrue(Viewer.obstacle().isEmpty(), "needs a display");
        ForeignProject.copyScene(directory);
        // The other scene has the kind in the position of its camera, and none of its own.
        Path other = directory.resolve("other.yaml");
        Files.writeString(
                other,
                Files.readString(directory.resolve("scene.yaml"))
                        .replaceAll(
                                "(?s)  camera:.*?\n\n",
                                "  camera: {kind: spotter, position: [15, 10, 2], reach: 90 m}\n\n")
                        .replaceAll("(?m)^  eyes:.*\n", ""));
        Path home = Files.createDirectories(directory.resolve("home/.dronewatch"));
        Files.writeString(home.resolve("recent-scenes.txt"), other + "\n");
        Path pictures = Files.createDirectories(Path.of("target", "viewer").toAbsolutePath());

        List<String> lines = linesOf(
                pictures.resolve("foreign-kind").toString(),
                "20",
                "eyes",
                "view",
                "scene.yaml",
                "--set",
                "sensors.eyes.position=-20,20,2",
                "--set",
                "sensors.eyes.reach=130 m");

        assertThat(lines)
                .as("the table: at 20 s it is 90 m - 20 m to the south, 20 m to the west and 18 m below")
                .anyMatch(line -> line.matches(
                        "row eyes \\| spotter \\| quadrotor \\| detects \\| 7[0-9].* \\| 1\\.[67].* \\| 1.*"));
        assertThat(lines)
                .contains(
                        "symbol of eyes: " + COLOUR,
                        "cut: spotter",
                        "rays: 'ear' traces no rays from 'quadrotor' at 20.00 s.",
                        "clicked: eyes",
                        "other: other - dronewatch",
                        "symbol of camera: " + COLOUR,
                        "other clicked: camera",
                        "exit 0");
        assertThat(lines)
                .anyMatch(line -> line.startsWith("time line of eyes: ") && line.contains("detects quadrotor"));
        assertThat(lines).anyMatch(line -> line.startsWith("other row camera | spotter | quadrotor | detects |"));
        assertThat(lines).noneMatch(line -> line.startsWith("notice "));
    }
}
