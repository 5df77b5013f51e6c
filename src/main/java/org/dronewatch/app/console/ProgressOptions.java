package org.dronewatch.app.console;

import java.io.PrintWriter;
import org.dronewatch.setting.InputException;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** The option of commands that may take minutes: how much they report while they work. */
public final class ProgressOptions {
    @Option(names = "--progress", description = "Shows progress even without a terminal: as lines on standard error.")
    private boolean progress;

    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    /**
     * How the command shows its progress.
     *
     * @param err receives progress and notes
     * @throws InputException when both {@code --progress} and {@code --quiet} are given
     */
    public TaskProgress on(PrintWriter err) {
        boolean quiet = Notes.areOff(command);
        if (quiet && progress) {
            throw new InputException("--quiet: cannot be combined with --progress");
        }
        TaskProgress.Amount amount = quiet
                ? TaskProgress.Amount.NOTHING
                : progress ? TaskProgress.Amount.EVERYWHERE : TaskProgress.Amount.ON_A_TERMINAL;
        return new TaskProgress(amount, err);
    }
}
