package org.dronewatch.app;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.ListResourceBundle;
import java.util.Map;
import java.util.ResourceBundle;
import java.util.stream.Collectors;
import org.dronewatch.app.console.ExitCode;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.UsageMessageSpec;

/** What the help of each command says besides its options: the exit codes, and examples that can be typed as shown. */
final class CommandHelp {
    private static final String FAILED = "internal error, or out of memory";

    /** What code 1 means where it may also be a result. */
    private static final Map<String, String> VERDICTS = Map.of(
            "again", "the results differ, " + FAILED,
            "campaign", "an expectation is not met, no case could be run, " + FAILED,
            "merge", "an expectation is not met, no case could be run, " + FAILED,
            "compare", "no case could be run, " + FAILED);

    /** The texts of the options that every command has: like all others, they say what an option does. */
    private static final ResourceBundle COMMON = new ListResourceBundle() {
        @Override
        protected Object[][] getContents() {
            return new Object[][] {
                {"mixinStandardHelpOptions.help", "Prints this help."},
                {
                    "mixinStandardHelpOptions.version",
                    "Prints the program's version, the Java that runs it, and whether vector instructions are used."
                }
            };
        }
    };

    private CommandHelp() {}

    /** Completes the help of the program and of all its commands. */
    static void complete(CommandLine program) {
        complete(program.getCommandSpec());
        program.getSubcommands().values().forEach(command -> complete(command.getCommandSpec()));
    }

    private static void complete(CommandSpec command) {
        command.resourceBundle(COMMON);
        // Examples are not wrapped: in two lines a command could not be copied.
        command.commandLine().getHelpSectionMap().put(UsageMessageSpec.SECTION_KEY_FOOTER, help -> Arrays.stream(
                        command.usageMessage().footer())
                .map(line -> line + System.lineSeparator())
                .collect(Collectors.joining()));
        listExitCodes(command);
    }

    private static void listExitCodes(CommandSpec command) {
        boolean opensWindows =
                command.parent() == null || command.name().equals("view") || command.findOption("--view") != null;
        Map<String, String> codes = new LinkedHashMap<>();
        codes.put("  0", "done");
        codes.put("  " + ExitCode.FAILED, VERDICTS.getOrDefault(command.name(), FAILED));
        codes.put("  " + ExitCode.BAD_INPUT, "invalid usage or input: a line on standard error for each mistake");
        // 'render --view' draws a picture without a window.
        if (opensWindows && !command.name().equals("render")) {
            codes.put("  " + ExitCode.NO_DISPLAY, "no display for a window");
        }
        codes.put("130", "interrupted by Ctrl-C");
        codes.put("143", "terminated by SIGTERM");
        command.usageMessage().exitCodeListHeading("%nExit codes:%n").exitCodeList(codes);
    }
}
