package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A tutorial, read step by step. A block of YAML belongs to the file that the text named last: the first such block is
 * the file, and a later one stands for the line with which it begins.
 *
 * @param name of the page, without {@code .md}
 */
record TutorialPage(String name) {
    private static final Pattern STEP = Pattern.compile("(?m)^ {4}dronewatch (.+)$|^```yaml\n([\\s\\S]*?)^```$"
            + "|^```text\n([\\s\\S]*?)^```$|`([\\w./-]+\\.yaml)`");

    /** What is done on the way. */
    interface Reader {
        /** A command, without the name of the program. */
        void type(String command);

        /** What is to be shown as printed by the last command, without the last line break. */
        String printed(String shown);
    }

    Path file() {
        return Path.of("src", "site", "markdown", name + ".md");
    }

    /** The page as the reader finds it, who writes its files into a directory. */
    String read(Path directory, Reader reader) throws IOException {
        StringBuilder read = new StringBuilder();
        Path named = directory.resolve("unnamed");
        Matcher steps = STEP.matcher(Files.readString(file()));
        while (steps.find()) {
            MatchResult step = steps.toMatchResult();
            String block = step.group();
            if (step.group(1) != null) {
                reader.type(step.group(1));
            } else if (step.group(2) != null) {
                write(named, step.group(2));
            } else if (step.group(3) != null) {
                block = "```text\n" + reader.printed(step.group(3)) + "\n```";
            } else {
                named = directory.resolve(step.group(4));
            }
            steps.appendReplacement(read, Matcher.quoteReplacement(block));
        }
        return steps.appendTail(read).toString();
    }

    /** Writes the files as they are in the end, and runs nothing. */
    void writeFiles(Path directory) throws IOException {
        read(directory, new Reader() {
            @Override
            public void type(String command) {
                // The files do not depend on it.
            }

            @Override
            public String printed(String shown) {
                return shown;
            }
        });
    }

    /** The first time the whole file; then in place of the line with which the block begins. */
    private static void write(Path file, String yaml) throws IOException {
        if (!Files.exists(file)) {
            Files.writeString(file, yaml);
            return;
        }
        String before = Files.readString(file);
        String line = yaml.substring(0, yaml.indexOf('\n') + 1);
        assertThat(before).containsOnlyOnce("\n" + line);
        Files.writeString(file, before.replace("\n" + line, "\n" + yaml));
    }
}
