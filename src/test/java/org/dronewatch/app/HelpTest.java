package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine;
import picocli.CommandLine.Model.OptionSpec;

/** What every command's help has: an example that can be typed, the exit codes, and the options that all share. */
class HelpTest {
    private static final Pattern WORD = Pattern.compile("(?:[^\\s\"']|\"[^\"]*\"|'[^']*')+");
    private static final String PAGE = "src/site/markdown/commands.md";

    static Set<String> commands() {
        return Program.commands().getSubcommands().keySet();
    }

    private static List<String> words(String line) {
        return WORD.matcher(line)
                .results()
                .map(word -> word.group().replaceAll("[\"']", ""))
                .toList();
    }

    @ParameterizedTest
    @MethodSource("commands")
    void everyExampleCanBeTyped(String command) {
        Program.Outcome help = Program.run(command, "--help");
        assertThat(help.code()).isZero();
        List<String> examples = help.out()
                .substring(help.out().indexOf("\nExample"))
                .lines()
                .filter(line -> line.startsWith("  dronewatch "))
                .toList();
        assertThat(examples).isNotEmpty().allMatch(line -> line.startsWith("  dronewatch " + command));
        for (String example : examples) {
            // Words after '>' are the shell's.
            List<String> words = words(example.strip().replaceFirst(" > .*", ""));
            CommandLine program = Program.commands().setCaseInsensitiveEnumValuesAllowed(true);
            assertThat(program.parseArgs(words.subList(1, words.size()).toArray(String[]::new)))
                    .as(example)
                    .isNotNull();
        }
    }

    /** Lines of the usage are broken between arguments, never inside one such as {@code --centre=EAST,NORTH}. */
    @ParameterizedTest
    @MethodSource("commands")
    void noArgumentOfAUsageIsBroken(String command) {
        CommandLine wide = Program.commands().getSubcommands().get(command);
        wide.getCommandSpec().usageMessage().width(10_000);

        assertThat(usage(Program.run(command, "--help").out())).isEqualTo(usage(wide.getUsageMessage()));
    }

    /** The words from "Usage:" to the line before the description. */
    private static List<String> usage(String help) {
        List<String> lines = help.lines().toList();
        long indented = lines.stream()
                .skip(1)
                .takeWhile(line -> line.startsWith("     "))
                .count();
        return List.of(
                String.join(" ", lines.subList(0, 1 + (int) indented)).trim().split("\\s+"));
    }

    /** In two lines, the command could not be copied: a shell refuses {@code <} and {@code (} apart. */
    @Test
    void theLineForStartupFilesIsWhole() {
        assertThat(Program.run("completion", "--help").out().lines()).contains("  source <(dronewatch completion)");
    }

    /** All options say what they do in the third person; the library's texts of these two are commands. */
    @ParameterizedTest
    @MethodSource("commands")
    void theCommonOptionsSayWhatTheyDo(String command) {
        assertThat(Program.run(command, "--help").out())
                .containsPattern("-h, --help +Prints this help\\.")
                .containsPattern("-V, --version +Prints the program's version, ");
    }

    @ParameterizedTest
    @MethodSource("commands")
    void everyCommandListsItsExitCodesAndTheCommonOptions(String command) {
        // Long lines are wrapped.
        String help = Program.run(command, "--help").out().replaceAll("\\R {8,}", " ");

        assertThat(help)
                .containsSubsequence("Usage: dronewatch " + command, "-q, --quiet", "-v, --verbose", "Exit codes:")
                .containsPattern("\n +0 +done\n")
                .containsPattern("\n +1 +.*internal error")
                .containsPattern("\n +2 +invalid usage or input")
                .containsPattern("\n +130 +")
                .containsPattern("\n +143 +");
        boolean opensWindows =
                Set.of("view", "run", "route", "campaign", "compare").contains(command);
        assertThat(Pattern.compile("\n +3 +no display").matcher(help).find()).isEqualTo(opensWindows);
    }

    /** Of the exit codes, 1 is also a verdict for some commands; the help says for which. */
    @Test
    void aVerdictHasAnExitCode() {
        assertThat(Program.run("again", "--help").out()).containsPattern("\n +1 +the results differ,");
        assertThat(Program.run("campaign", "--help").out()).containsPattern("\n +1 +an expectation is not met");
    }

    @Test
    void theVersionNamesJavaAndVectors() {
        List<String> lines = Program.run("--version").out().lines().toList();

        assertThat(lines).hasSize(3);
        assertThat(lines.get(0)).matches("dronewatch \\d+\\.\\d+\\.\\d+.*");
        assertThat(lines.get(1)).startsWith("Java " + System.getProperty("java.runtime.version") + " (");
        // Tests run with the module, on processors of either kind.
        assertThat(lines.get(2))
                .matches("vector instructions: (256 bits, 8 lanes of float or 4 of double; the processor has \\d+ bits"
                        + "|not used; they need 256 bits, and the processor has \\d+)");
    }

    @ParameterizedTest
    @MethodSource("commands")
    void theCommandHelpPrintsTheHelpOfACommand(String command) {
        assertThat(Program.run("help", command)).isEqualTo(Program.run(command, "--help"));
    }

    @Test
    void theCommandHelpAloneListsTheCommands() {
        assertThat(Program.run("help")).isEqualTo(Program.run("--help"));
    }

    /** Only as the first word is it the command: elsewhere it may be the name of a scene. */
    @Test
    void helpAfterACommandIsAScene() {
        Program.Outcome run = Program.run("run", "help");
        assertThat(run.code()).isEqualTo(2);
        assertThat(run.err()).startsWith("unknown scene 'help'");
    }

    /** The page has a row for each command, and for each form of some. */
    @Test
    void thePageListsAllCommands() throws IOException {
        try (Stream<String> lines = Files.lines(Path.of(PAGE))) {
            assertThat(lines.dropWhile(line -> !line.startsWith("| command |"))
                            .skip(2)
                            .takeWhile(line -> line.startsWith("|"))
                            .map(line -> line.replaceFirst("^\\| `([a-z]+).*", "$1")))
                    .containsOnlyOnceElementsOf(Set.of("run", "completion"))
                    .containsOnly(commands().toArray(String[]::new));
        }
    }

    /** No option of a command has the short name of one that all share. */
    @Test
    void shortNamesMeanTheSameEverywhere() {
        Set<String> common = Set.of("-q", "-v", "-h", "-V");
        for (CommandLine command : Program.commands().getSubcommands().values()) {
            for (OptionSpec option : command.getCommandSpec().options()) {
                for (String name : option.names()) {
                    assertThat(name.startsWith("--") || common.contains(name))
                            .as(name)
                            .isTrue();
                }
            }
        }
    }
}
