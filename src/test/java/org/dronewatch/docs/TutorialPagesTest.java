package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.Set;
import java.util.regex.Pattern;
import org.dronewatch.app.Main;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * A reader who does what a tutorial says, step by step, sees what it shows. All files of a tutorial begin with its
 * name. A block of text is what the command before it prints: warnings that no earlier command printed, then the
 * result. A few minutes' work: run only with {@code -Ddronewatch.docs=all}; {@code =write} writes these blocks.
 */
@EnabledIfSystemProperty(named = "dronewatch.docs", matches = "all|write")
class TutorialPagesTest {
    private static final Pattern WORD = Pattern.compile("(?:[^\\s\"']|\"[^\"]*\"|'[^']*')+");

    @TempDir
    private Path directory;

    @ParameterizedTest
    @CsvSource({
        "tutorial-gate, gate, 7",
        "tutorial, harbour, 7",
        "tutorial-vendors, vendors, 6",
        "tutorial-route, house, 5"
    })
    void aTutorialShowsWhatHappens(String page, String name, int commands) throws IOException {
        TutorialPage tutorial = new TutorialPage(page);
        Typist typist = new Typist(name);
        String read = tutorial.read(directory, typist);
        if ("write".equals(System.getProperty("dronewatch.docs"))) {
            Files.writeString(tutorial.file(), read);
        }
        assertThat(typist.commands).isEqualTo(commands);
        assertThat(Files.readString(tutorial.file())).isEqualTo(read);
        assertThat(typist.warnings).as("are shown").allMatch(read::contains);
    }

    /** Types commands where the tutorial's files are. */
    private final class Typist implements TutorialPage.Reader {
        private final String name;
        private final Set<String> warnings = new LinkedHashSet<>();
        private int commands;
        private String printed = "";

        Typist(String name) {
            this.name = name;
        }

        @Override
        public String printed(String shown) {
            return printed.stripTrailing();
        }

        @Override
        public void type(String command) {
            commands++;
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
            StringBuilder both = new StringBuilder();
            plain(err)
                    .lines()
                    .filter(line -> line.startsWith("warning: ") && warnings.add(line))
                    .forEach(line -> both.append(line).append('\n'));
            printed = both.append(plain(out)).toString();
        }

        private String plain(StringWriter text) {
            return text.toString().replace("\r\n", "\n").replace(directory + "/", "");
        }
    }
}
