package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.dronewatch.app.Program.Outcome;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Each command of the tutorial, in order, as a reader types it; only the directory that is made lies elsewhere, and
 * runs are short.
 */
class TutorialTest {
    private static final Path PAGE = Path.of("src/site/markdown/tutorial.md");

    @TempDir
    private Path directory;

    @Test
    void theTutorialWorks() throws IOException {
        List<String> commands = Files.readAllLines(PAGE).stream()
                .filter(line -> line.startsWith("    dronewatch "))
                .map(line -> line.strip().substring("dronewatch ".length()))
                .toList();
        assertThat(commands).hasSize(7);
        for (String command : commands) {
            // As typed, but for less time and fewer cells.
            String shorter = command.replace("--cells 40", "--cells 6")
                    .replace("--time 30", "--time 1")
                    .replaceFirst("^(run .*)$", "$1 --set run.duration=4s");
            String[] words = shorter.replace("\"", "")
                    .replaceAll(
                            "(?<= )harbour(?=[ /])",
                            directory.resolve("harbour").toString())
                    .split(" ");
            Outcome outcome = Program.run(words);
            assertThat(outcome.code()).as("%s%n%s", command, outcome.err()).isZero();
            assertThat(outcome.err().lines().filter(line -> line.startsWith("warning")))
                    .as(command)
                    .allMatch(line -> line.contains("no height in the map")
                            || line.contains("its heights may include roofs")
                            || line.contains("lie below the highest ground under them"));
        }
        assertThat(directory.resolve("harbour/results/report.html")).exists();
        assertThat(Files.readString(directory.resolve("harbour/results/result.json")))
                .contains("\"first_detected_s\"");
    }
}
