package org.dronewatch.app.console;

import java.io.PrintWriter;
import java.util.function.Consumer;
import picocli.CommandLine.Model.CommandSpec;

/**
 * The destination of a command's notes, one line each: standard error; with {@code --quiet}, only warnings are printed.
 */
public final class Notes {
    private static final String WARNING = "warning: ";

    private Notes() {}

    /** The notes of a command. */
    public static Consumer<String> of(CommandSpec command) {
        return to(command.commandLine().getErr(), areOff(command));
    }

    /** Notes that go to a writer. */
    static Consumer<String> to(PrintWriter err, boolean quiet) {
        return line -> {
            if (!quiet || line.startsWith(WARNING)) {
                err.println(line);
            }
        };
    }

    /** Whether the user wants results, warnings and errors only. */
    public static boolean areOff(CommandSpec command) {
        return command.root().userObject() instanceof QuietSwitch given && given.isQuiet();
    }
}
