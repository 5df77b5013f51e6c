package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The words of commands that the program prints, as a shell takes them. */
final class ShellWords {
    private static final Path SHELL = Path.of("/bin/sh");

    private ShellWords() {}

    /** The words of a printed command that ends its line, without the name of the program. */
    static List<String> printed(String output, String command) {
        Matcher line = Pattern.compile("(?m): dronewatch (" + command + " .*)$").matcher(output);
        assertThat(line.find()).as(output).isTrue();
        return of(line.group(1));
    }

    /** The words of a line; where there is no POSIX shell, it is only divided at blanks. */
    private static List<String> of(String line) {
        if (!Files.isExecutable(SHELL)) {
            return List.of(line.split(" "));
        }
        try {
            Process process = new ProcessBuilder(SHELL.toString(), "-c", "printf '%s\\n' " + line).start();
            String words = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            return words.lines().toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
