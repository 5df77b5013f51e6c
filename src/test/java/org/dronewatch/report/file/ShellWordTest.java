package org.dronewatch.report.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ShellWordTest {
    private static final Path SHELL = Path.of("/bin/sh");

    @Test
    void aPathIsRelativeToTheCurrentDirectoryIfItIsBelowIt() {
        Path here = Path.of("").toAbsolutePath();

        assertThat(ShellWord.of(Path.of("buy", "layout.yaml"))).isEqualTo("buy" + File.separator + "layout.yaml");
        assertThat(ShellWord.of(here.resolve("buy/./layout.yaml"))).isEqualTo("buy" + File.separator + "layout.yaml");
        assertThat(ShellWord.of(here)).isEqualTo(".");
        assertThat(ShellWord.of(here.resolveSibling("layout.yaml")))
                .isEqualTo(here.resolveSibling("layout.yaml").toString());
        assertThat(ShellWord.of(Path.of("my layout", "layout.yaml")))
                .isEqualTo("\"my layout" + File.separator + "layout.yaml\"");
        assertThat(ShellWord.of(Path.of("-x", "layout.yaml")))
                .isEqualTo("." + File.separator + "-x" + File.separator + "layout.yaml");
    }

    /** The shell gives back each word as it is. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "plain",
                "two words",
                "a;b",
                "$HOME",
                "it's",
                "`date`",
                "a\"b",
                "a\\b",
                "=x",
                "$5 isn't \"much\"",
                "*"
            })
    void aShellTakesItForOneWord(String word) throws IOException {
        assumeTrue(Files.isExecutable(SHELL), "needs a POSIX shell");
        Process process = new ProcessBuilder(SHELL.toString(), "-c", "printf '%s|' " + ShellWord.of(word)).start();

        assertThat(new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8))
                .isEqualTo(word + "|");
    }

    /** In zsh, {@code =ls} is the path of a command, unless it is quoted. */
    @Test
    void aWordThatBeginsWithAnEqualsSignIsQuoted() {
        assertThat(ShellWord.of("=ls")).isEqualTo("\"=ls\"");
        assertThat(ShellWord.of("a=b")).isEqualTo("a=b");
    }
}
