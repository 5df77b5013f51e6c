package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.dronewatch.app.Main;
import org.dronewatch.app.Program;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;
import picocli.CommandLine.ParameterException;

/** Every command that the pages show is one, and its scene with its overrides can be read. */
class DocCommandsTest {
    private static final Set<String> OF_SCENES = Set.of("run", "view", "check", "save", "render", "coverage");
    /** A reader's own file, of which the pages do not show all. */
    private static final String NOT_SHOWN = "site.yaml";

    @TempDir
    private Path directory;

    private static Set<List<String>> commands() throws IOException {
        return PageCommand.all().stream().map(PageCommand::words).collect(Collectors.toCollection(LinkedHashSet::new));
    }

    private static CommandLine.ParseResult parse(List<String> words) {
        return Program.commands().setCaseInsensitiveEnumValuesAllowed(true).parseArgs(words.toArray(String[]::new));
    }

    @Test
    void everyCommandIsOne() throws IOException {
        Set<List<String>> commands = commands();
        assertThat(commands).hasSizeGreaterThan(25);
        for (List<String> command : commands) {
            try {
                assertThat(parse(command)).isNotNull();
            } catch (ParameterException e) {
                throw new AssertionError(command + ": " + e.getMessage(), e);
            }
        }
    }

    @Test
    void aCommandThatIsNoneIsFound() {
        assertThatThrownBy(() -> parse(PageCommand.words("run camera-range --outt x")))
                .isInstanceOf(ParameterException.class);
        assertThatThrownBy(() -> parse(PageCommand.words("rum camera-range"))).isInstanceOf(ParameterException.class);
    }

    @Test
    void everySceneCanBeReadWithItsOverrides() throws IOException {
        String guide = Files.readString(Path.of("src/site/markdown/guide.md"));
        Path gate = directory.resolve("gate.yaml");
        Files.writeString(gate, GuideTest.firstExample(guide));
        Set<List<String>> checked = new LinkedHashSet<>();
        for (List<String> command : commands()) {
            // Those of a tutorial, or of the plant drawn by hand, follow one another: its own test runs them.
            boolean isOfTutorial =
                    command.stream().anyMatch(word -> word.matches("(harbour|plant)/.*|(vendors|house)[.-].*"));
            // Without a scene, the viewer shows those that there are.
            boolean hasScene = command.size() > 1;
            if (OF_SCENES.contains(command.get(0)) && hasScene && !command.contains(NOT_SHOWN) && !isOfTutorial) {
                checked.add(check(command, gate));
            }
        }
        assertThat(checked).hasSizeGreaterThan(10);
        for (List<String> check : checked) {
            StringWriter said = new StringWriter();
            PrintWriter writer = new PrintWriter(said);
            int code = Main.execute(writer, writer, check.toArray(String[]::new));
            assertThat(code).as("%s: %s", check, said).isZero();
        }
    }

    /** The command that checks the scene of another. */
    private static List<String> check(List<String> command, Path gate) {
        List<String> check = new ArrayList<>(List.of("check"));
        String scene = command.get(1);
        check.add(scene.equals("gate.yaml") ? gate.toString() : scene);
        for (int i = 2; i < command.size() - 1; i++) {
            if (command.get(i).equals("--set")) {
                check.add("--set");
                check.add(command.get(i + 1));
            }
        }
        return check;
    }
}
