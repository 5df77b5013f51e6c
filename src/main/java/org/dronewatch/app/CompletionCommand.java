package org.dronewatch.app;

import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronewatch.report.provenance.ProgramVersion;
import picocli.AutoComplete;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** Prints the script that makes a shell complete the program's commands and options. */
@Command(
        name = "completion",
        mixinStandardHelpOptions = true,
        description = {
            "Prints a script that makes Bash and Zsh complete commands, options, their values and packaged scenes when"
                    + " you press the Tab key after 'dronewatch'.",
            "To load it in every new shell, add the first example below to your ~/.bashrc or",
            "~/.zshrc."
        },
        // In the footer, lines are not wrapped: in two lines a command could not be copied.
        footer = {
            "",
            "Examples:",
            "  source <(dronewatch completion)",
            "  dronewatch completion > ~/.dronewatch-completion"
        })
final class CompletionCommand implements Callable<Integer> {
    /** The words from which the value of an option is chosen. */
    private static final Pattern WORDS = Pattern.compile("_option_args=\\([^)]*\\)");

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        String script = AutoComplete.bash(ProgramVersion.PROGRAM, spec.root().commandLine());
        // Words as the help writes them; lines end as a shell wants them, on every system.
        String written = WORDS.matcher(script)
                .replaceAll(words -> Matcher.quoteReplacement(words.group().toLowerCase(Locale.ROOT)))
                .replace("\r\n", "\n");
        spec.commandLine().getOut().print(written);
        spec.commandLine().getOut().flush();
        return 0;
    }
}
