package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;

/** Runs command lines in a directory of the test. */
abstract class CommandLines {
    @TempDir
    Path directory;

    /** Runs a command line in which DIR stands for the test's directory. */
    Program.Outcome commandIn(String line) {
        return Program.run(Stream.of(line.split("\\s+"))
                .filter(word -> !word.isEmpty())
                .map(word -> word.replace("DIR", directory.toString()))
                .toArray(String[]::new));
    }

    Map<String, String> files() throws IOException {
        Map<String, String> files = new TreeMap<>();
        try (Stream<Path> all = Files.walk(directory)) {
            for (Path file : all.filter(Files::isRegularFile).toList()) {
                files.put(
                        directory.relativize(file).toString().replace('\\', '/'),
                        new String(Files.readAllBytes(file), java.nio.charset.StandardCharsets.ISO_8859_1));
            }
        }
        return files;
    }

    void assertRefused(String line, String... parts) throws IOException {
        Map<String, String> before = files();
        Program.Outcome outcome = commandIn(line);
        assertThat(outcome.code()).as(outcome.err()).isEqualTo(2);
        assertThat(outcome.out()).isEmpty();
        assertThat(outcome.err().strip())
                .isNotEmpty()
                .doesNotContain("Exception")
                .doesNotContain("\tat ");
        String last = outcome.err().strip().lines().reduce((a, b) -> b).orElseThrow();
        assertThat(last).contains(parts);
        // What was read well is noted before the mistake; the mistake itself takes one line.
        assertThat(outcome.err().strip().lines().filter(text -> !text.startsWith("read ")))
                .hasSize(1);
        assertThat(files()).isEqualTo(before);
    }
}
