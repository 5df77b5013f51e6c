package org.dronewatch.app.console;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.dronewatch.app.Program;
import org.dronewatch.app.Program.Child;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** A run in a separate process that is asked to end in its middle. */
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "there a process can only be killed")
class InterruptionTest {
    @TempDir
    private Path directory;

    @Test
    void aRunThatIsInterruptedWritesWhatItHas() throws IOException, InterruptedException {
        Path results = directory.resolve("results");
        try (Child run = Program.startLongRun(directory)) {
            awaitRows(3);
            run.process().destroy();
            assertThat(run.process().waitFor(30, TimeUnit.SECONDS)).isTrue();
        }

        assertThat(Files.readString(directory.resolve("err.txt")))
                .contains("results in")
                .doesNotContain("error");
        assertThat(Files.readString(results.resolve("summary.json"))).contains("\"complete\" : false");
        List<String> rows = Files.readAllLines(results.resolve("observations.csv"));
        assertThat(rows).hasSizeGreaterThan(3);
        assertThat(rows).allSatisfy(row -> assertThat(row.split(",", -1)).hasSize(13));
        try (Stream<Path> left = Files.list(directory)) {
            assertThat(left.map(file -> file.getFileName().toString()))
                    .containsExactlyInAnyOrder("results", "out.txt", "err.txt");
        }
    }

    /** Waits until the run has written so many rows into its unfinished table. */
    private void awaitRows(int count) throws IOException, InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(60);
        while (System.nanoTime() < end) {
            try (Stream<Path> files = Files.walk(directory)) {
                for (Path file :
                        files.filter(f -> f.endsWith("observations.csv")).toList()) {
                    if (Files.readAllLines(file).size() > count) {
                        return;
                    }
                }
            }
            Thread.sleep(50);
        }
        throw new AssertionError("the run wrote nothing within a minute");
    }
}
