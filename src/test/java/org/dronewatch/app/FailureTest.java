package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.dronewatch.Thorough;
import org.dronewatch.app.Program.Outcome;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Errors of Java are a line that says what to do, and leave nothing behind. */
@Execution(ExecutionMode.CONCURRENT)
class FailureTest {
    @TempDir
    private Path directory;

    private List<Path> left() throws IOException {
        try (Stream<Path> files = Files.walk(directory)) {
            return files.filter(file -> !file.equals(directory)
                            && !file.toString().endsWith("out.txt")
                            && !file.toString().endsWith("err.txt"))
                    .toList();
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "Asserting | assertion failed at org.dronewatch.app.FaultyScenes | range < 0\\u001b[2J",
                "Unlinked  | a class cannot be loaded | org/example/Missing: put all jars",
                "Greedy    | out of memory (Java heap space | -Xmx4g",
                "Endless   | stack overflow at org.dronewatch.app.FaultyScenes | -Xss16m",
                "Stillborn | a class cannot be loaded | no table",
                "Mistaken  | internal error: java.lang.UnsupportedOperationException: xxx | xxx at org.dronewatch.app.FaultyScenes",
            })
    void anErrorIsOneLineThatSaysWhatToDo(String scene, String beginning, String advice) throws IOException {
        String name = "org.dronewatch.app.FaultyScenes$" + scene;
        String out = directory.resolve("results").toString();
        for (String threads : List.of("1", "3")) {
            Outcome outcome = Program.run("run", name, "--out", out, "--threads", threads);
            assertThat(outcome.code()).isEqualTo(1);
            assertThat(outcome.complaints()).hasSize(1);
            assertThat(outcome.complaints().get(0))
                    .startsWith(beginning)
                    .contains(advice)
                    .endsWith("--verbose shows where")
                    .hasSizeLessThan(700);
            assertThat(left()).isEmpty();
        }
        Outcome verbose = Program.run("run", name, "--out", out, "--verbose");
        assertThat(verbose.complaints().get(0)).startsWith(beginning);
        assertThat(verbose.err())
                .contains("\n\tat org.dronewatch.app.FaultyScenes")
                .doesNotContain("\u001b");
        assertThat(Program.run("--verbose", "run", name, "--out", out).err()).contains("\n\tat ");
    }

    @Test
    void everyCommandKnowsVerbose() {
        for (String command : List.of(
                "list", "run", "view", "check", "save", "schema", "render", "coverage", "bench", "costs", "models")) {
            assertThat(Program.run(command, "--help").out()).as(command).contains("--verbose");
        }
    }

    /** A picture that takes nearly all of the 40 MB that Java has. */
    @Thorough
    @Test
    void aPictureThatDoesNotFitIntoMemoryIsOneLine() throws IOException, InterruptedException {
        String scene =
                Program.FUZZ.resolve("huge-picture.yaml").toAbsolutePath().toString();
        for (List<String> command : List.of(
                List.of("run", scene, "--out", "results"),
                List.of("render", scene, "--camera", "eye", "--out", "eye.png"))) {
            try (Program.Child child = Program.start(directory, List.of("-Xmx40m"), command.toArray(String[]::new))) {
                Outcome outcome = child.await();
                assertThat(outcome.code()).as(outcome.err()).isEqualTo(1);
                assertThat(outcome.complaints()).hasSize(1);
                assertThat(outcome.complaints().get(0))
                        .startsWith("out of memory (")
                        .containsPattern("Java may use \\d+")
                        .contains("-Xmx4g", "sensors.ID.width");
                assertThat(left()).isEmpty();
            }
        }
    }
}
