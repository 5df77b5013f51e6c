package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.app.Program.Child;
import org.dronewatch.app.Program.Outcome;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Ctrl-C and a request to terminate, at any moment of any command: the signal's exit code, and nothing that is half.
 */
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "there a process can only be killed")
@Execution(ExecutionMode.CONCURRENT)
class SignalTest {
    private static final List<String> OPTIONS = List.of("-Xmx1g", "-XX:+UseSerialGC");
    private static final List<String> LOG = List.of("out.txt", "err.txt");

    @TempDir
    private Path directory;

    private static void signal(Child child, String name) throws IOException, InterruptedException {
        new ProcessBuilder("kill", "-" + name, Long.toString(child.process().pid()))
                .start()
                .waitFor();
    }

    private List<String> left() throws IOException {
        try (Stream<Path> files = Files.list(directory)) {
            return files.map(file -> file.getFileName().toString())
                    .filter(name -> !LOG.contains(name))
                    .toList();
        }
    }

    private void assertWhole(Outcome outcome, int code) throws IOException {
        assertThat(outcome.code()).as(outcome.err()).isEqualTo(code);
        assertThat(outcome.err())
                .doesNotContain("error")
                .doesNotContain("Exception")
                .doesNotContain("\tat ");
        assertThat(left()).as(outcome.err()).isSubsetOf("results");
        Path results = directory.resolve("results");
        if (Files.exists(results)) {
            assertThat(Files.readString(results.resolve("summary.json"))).endsWith("}\n");
            if (!outcome.out().contains("quadrotor")) {
                throw new AssertionError("results without a table: " + outcome);
            }
            for (String table : List.of("detections.csv", "observations.csv")) {
                String text = Files.readString(results.resolve(table));
                assertThat(text).endsWith("\n");
                int columns = table.startsWith("d") ? 11 : 13;
                assertThat(text.lines())
                        .allSatisfy(row -> assertThat(row.split(",", -1)).hasSize(columns));
            }
        }
    }

    /**
     * The seed gives the moments, from before the program has begun to after it has ended. In the build each signal has
     * its own stage.
     */
    @Thorough
    @ParameterizedTest
    @CsvSource({"INT, 130, 2, 0", "TERM, 143, 1, 1"})
    void aRunEndsWithTheCodeOfTheSignalAtAnyMoment(String signal, int code, long seed, int stage) throws Exception {
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < 4; i++) {
            long millis = random.nextLong(200 + 1200 * i, 1400 + 1200 * i);
            if (LongForm.IS_ON || i == stage) {
                interruptARun(millis, signal, code);
            }
        }
    }

    private void interruptARun(long millis, String signal, int code) throws Exception {
        try (Child child = Program.start(
                directory,
                OPTIONS,
                "run",
                "camera-range",
                "--observations",
                "--set",
                "sensors.camera.width=480",
                "--set",
                "sensors.camera.height=270",
                "--out",
                "results")) {
            boolean ended = child.process().waitFor(millis, TimeUnit.MILLISECONDS);
            signal(child, signal);
            Outcome outcome = child.await();
            boolean ranOut = ended || outcome.code() == 0;
            assertWhole(outcome, ranOut ? 0 : code);
        }
        deleteResults();
    }

    private void deleteResults() throws IOException {
        Path results = directory.resolve("results");
        if (Files.exists(results)) {
            try (Stream<Path> files = Files.walk(results)) {
                for (Path file :
                        files.sorted(java.util.Comparator.reverseOrder()).toList()) {
                    Files.delete(file);
                }
            }
        }
    }

    @Test
    void aLongLookEndsAtOnceAndTheRowsBeforeItStay() throws Exception {
        try (Child child = Program.start(
                directory,
                OPTIONS,
                "run",
                "closed-space",
                "--observations",
                "--threads",
                "1",
                "--set",
                "sensors.microphone.propagation=energy-model",
                "--set",
                "sensors.microphone.propagation.rays=1000000",
                "--set",
                "sensors.microphone.propagation.accuracy=0",
                "--out",
                "results")) {
            // The last model that is read.
            for (int i = 0; i < 600 && !Files.readString(child.err()).contains("quadrotor"); i++) {
                Thread.sleep(100);
            }
            Thread.sleep(LongForm.count(1500, 3000));
            long start = System.nanoTime();
            signal(child, "TERM");
            Outcome outcome = child.await();
            assertThat(TimeUnit.NANOSECONDS.toSeconds(System.nanoTime() - start))
                    .isLessThan(10);
            assertThat(outcome.code()).as(outcome.err()).isEqualTo(143);
            assertThat(outcome.err())
                    .doesNotContain("error")
                    .contains("interrupted: these are the results up to 0.0 s of ");
            assertThat(left()).containsExactly("results");
            assertThat(Files.readString(directory.resolve("results/summary.json")))
                    .contains("\"complete\" : false");
        }
    }

    /** Until it says what it has read, but not for longer than Java takes to start. */
    private static void awaitAnyWord(Child child) throws Exception {
        for (int i = 0; i < 70 && child.process().isAlive() && Files.size(child.err()) == 0; i++) {
            Thread.sleep(20);
        }
    }

    @Thorough
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "bench packaged:cathedral.obj --passes 1000",
                "costs --out costs",
                "coverage multi-sensor --cell 1 --out field",
                "render multi-sensor --view orbit --size 2048x2048 --out site.png",
                "check multi-sensor",
            })
    void otherCommandsEndPromptlyAndLeaveNothing(String command) throws Exception {
        // While Java starts, which is the same for all commands, and in the midst of the work.
        boolean isAlsoAtTheStart = LongForm.IS_ON || command.startsWith("bench");
        for (boolean isAtTheStart : isAlsoAtTheStart ? new boolean[] {true, false} : new boolean[] {false}) {
            try (Child child = Program.start(directory, OPTIONS, command.split(" "))) {
                if (!isAtTheStart) {
                    awaitAnyWord(child);
                }
                boolean ended =
                        child.process().waitFor(isAtTheStart ? 600 : LongForm.count(400, 2600), TimeUnit.MILLISECONDS);
                long start = System.nanoTime();
                signal(child, "TERM");
                Outcome outcome = child.await();
                if (!ended && outcome.code() != 0) {
                    assertThat(outcome.code()).as(outcome.err()).isEqualTo(143);
                    assertThat(TimeUnit.NANOSECONDS.toSeconds(System.nanoTime() - start))
                            .isLessThan(20);
                    assertThat(outcome.err()).doesNotContain("error").doesNotContain("Exception");
                    assertThat(left()).as(outcome.err()).noneMatch(name -> name.startsWith(".partial"));
                    Path field = directory.resolve("field/coverage.json");
                    if (Files.exists(field)) {
                        assertThat(Files.readString(field)).contains("\"complete\" : false");
                        assertThat(outcome.err())
                                .contains("interrupted: complete for ")
                                .contains(" heights");
                    }
                }
            }
        }
    }
}
