package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.Thorough;
import org.dronewatch.app.Program.Outcome;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Recorded flights at the command line: what is shorter than the run is said once. */
class ReplayedScenesTest {
    @TempDir
    private Path directory;

    private Path scene(String name, String approaching, String hovering) throws IOException {
        return Files.writeString(
                directory.resolve(name),
                """
                world: {models: [packaged:house.obj]}
                drones:
                  visitor: {model: packaged:quadrotor.obj, flight: %s, speed: 8 m/s}
                  watcher: {model: packaged:quadrotor.obj, flight: %s}
                sensors:
                  camera: {kind: camera, position: [0, 0, 20], rate: 1 Hz}
                run: {duration: 3 s}
                """
                        .formatted(approaching, hovering));
    }

    private Path replay() throws IOException {
        Path flown = scene(
                "flown.yaml",
                "{kind: approach, from: [0, 100, 20], to: [0, 0, 20]}",
                "{kind: hover, position: [0, 30, 20]}");
        Outcome outcome = Program.run(
                "run", flown.toString(), "--out", directory.resolve("flown").toString());
        assertThat(outcome.code()).as(outcome.err()).isZero();
        String recorded = "{kind: recorded, file: flown/flights.csv}";
        return scene("replayed.yaml", recorded, recorded);
    }

    private List<String> warnings(String command, String duration) throws IOException {
        List<String> words =
                new ArrayList<>(List.of(command, replay().toString(), "--set", "run.duration=" + duration));
        if (command.equals("run")) {
            words.addAll(List.of("--out", directory.resolve("replayed").toString()));
        }
        Outcome outcome = Program.run(words.toArray(String[]::new));
        assertThat(outcome.code()).as(outcome.err()).isZero();
        return outcome.err().lines().filter(line -> line.contains("recorded")).toList();
    }

    @Thorough
    @Test
    void aRunBeyondTheEndOfARecordingWarnsOnceForEachDrone() throws IOException {
        for (String command : List.of("check", "run")) {
            assertThat(warnings(command, "3.5 s"))
                    .as(command)
                    .containsExactly(
                            "warning: drone 'visitor': its recorded flight ends at 3.0 s, the run at 3.5 s: for the rest"
                                    + " of the run the drone flies straight on at 8.0 m/s",
                            "warning: drone 'watcher': its recorded flight ends at 3.0 s, the run at 3.5 s: for the rest"
                                    + " of the run the drone hovers");
        }
        assertThat(Files.readAllLines(directory.resolve("replayed/flights.csv")))
                .as("it flies on as it did")
                .anyMatch(row -> row.startsWith("0,visitor,3.5,0.0,72.0,20.0,0.0,-8.0,0.0,"));
    }

    @Thorough
    @Test
    void aRunThatEndsWithTheRecordingDoesNotWarn() throws IOException {
        assertThat(warnings("check", "3 s")).isEmpty();
        assertThat(warnings("run", "2 s")).isEmpty();
    }
}
