package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronewatch.app.Main;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * A reader who does what a tutorial says, step by step, sees what it shows. The files of a tutorial are named after it;
 * its first block of YAML is one of them, and a later block stands for the line with which it begins. A block of text
 * is what the command before it prints. Ten seconds' work: run only with {@code -Ddronewatch.docs=all}; {@code =write}
 * writes these blocks.
 */
@EnabledIfSystemProperty(named = "dronewatch.docs", matches = "all|write")
class TutorialPagesTest {
    private static final Pattern STEP =
            Pattern.compile("(?m)^ {4}dronewatch (.+)$|^```yaml\n([\\s\\S]*?)^```$|^```text\n([\\s\\S]*?)^```$");
    private static final Pattern WORD = Pattern.compile("(?:[^\\s\"']|\"[^\"]*\"|'[^']*')+");

    @TempDir
    private Path directory;

    @ParameterizedTest
    @CsvSource({"tutorial-gate, gate, 7"})
    void aTutorialShowsWhatHappens(String page, String name, int commands) throws IOException {
        Path file = Path.of("src", "site", "markdown", page + ".md");
        String text = Files.readString(file);
        Path scene = directory.resolve(name + ".yaml");
        StringBuilder written = new StringBuilder();
        List<String> typed = new ArrayList<>();
        String printed = "";
        Matcher step = STEP.matcher(text);
        while (step.find()) {
            String block = step.group();
            if (step.group(1) != null) {
                typed.add(step.group(1));
                printed = printed(step.group(1), name);
            } else if (step.group(2) != null) {
                write(scene, step.group(2));
            } else {
                block = "```text\n" + printed.stripTrailing() + "\n```";
            }
            step.appendReplacement(written, Matcher.quoteReplacement(block));
        }
        step.appendTail(written);
        if ("write".equals(System.getProperty("dronewatch.docs"))) {
            Files.writeString(file, written.toString());
        }
        assertThat(typed).hasSize(commands);
        assertThat(Files.readString(file)).isEqualTo(written.toString());
    }

    /** What a command prints that is typed where the tutorial's files are. */
    private String printed(String command, String name) {
        String[] words = WORD.matcher(command)
                .results()
                .map(word -> word.group().replaceAll("[\"']", ""))
                .map(word -> word.matches(name + "([./-].*)?")
                        ? directory.resolve(word).toString()
                        : word)
                .toArray(String[]::new);
        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        assertThat(Main.execute(new PrintWriter(out, true), new PrintWriter(err, true), words))
                .as("%s: %s", command, err)
                .isZero();
        assertThat(err.toString().lines()).as(command).noneMatch(line -> line.startsWith("warning: "));
        return out.toString().replace("\r\n", "\n").replace(directory + "/", "");
    }

    /** The first time the whole file; then in place of the line with which the block begins. */
    private static void write(Path scene, String yaml) throws IOException {
        if (!Files.exists(scene)) {
            Files.writeString(scene, yaml);
            return;
        }
        String before = Files.readString(scene);
        String line = yaml.substring(0, yaml.indexOf('\n') + 1);
        assertThat(before).containsOnlyOnce("\n" + line);
        Files.writeString(scene, before.replace("\n" + line, "\n" + yaml));
    }
}
