package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A shell that reads what {@code completion} prints completes commands, options, values and scenes. */
class CompletionTest {
    private static final Path BASH = Path.of("/bin/bash");

    @TempDir
    private Path directory;

    /** What Bash offers for the last of some words. */
    private List<String> offered(String... words) throws IOException, InterruptedException {
        Path script = directory.resolve("completion");
        Files.writeString(script, Program.run("completion").out());
        Path asked = Files.writeString(
                directory.resolve("ask"),
                """
                source '%s'
                COMP_WORDS=(%s)
                COMP_CWORD=%d
                _complete_dronewatch
                printf '%%s\\n' "${COMPREPLY[@]}"
                """
                        .formatted(script, String.join(" ", words), words.length - 1));
        Path out = directory.resolve("out");
        Process bash = new ProcessBuilder(BASH.toString(), "--norc", asked.toString())
                // Outside of a completion that a user asks for, 'compopt' complains.
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .redirectOutput(out.toFile())
                .start();
        assertThat(bash.waitFor(60, TimeUnit.SECONDS)).isTrue();
        return Files.readAllLines(out, StandardCharsets.UTF_8).stream()
                .map(String::strip)
                .toList();
    }

    @Test
    void completesCommandsOptionsValuesAndScenes() throws IOException, InterruptedException {
        assumeTrue(Files.isExecutable(BASH));

        assertThat(offered("dronewatch", "co")).containsExactlyInAnyOrder("coverage", "compare", "completion", "costs");
        assertThat(offered("dronewatch", "run", "--thr")).containsExactly("--threads");
        assertThat(offered("dronewatch", "bench", "--query", "'oc'")).containsExactly("occluded");
        assertThat(offered("dronewatch", "run", "cam")).containsExactly("camera-range");
    }
}
