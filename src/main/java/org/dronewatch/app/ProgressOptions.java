package org.dronewatch.app;

import java.io.PrintWriter;
import org.dronewatch.parallel.LongTask;
import org.dronewatch.setting.InputException;
import picocli.CommandLine.Option;

/** The options of commands that may take minutes: how much they say while they work. */
final class ProgressOptions {
    @Option(
            names = "--quiet",
            description = "Prints results, warnings and errors only: no progress, and no notes on what is read.")
    private boolean quiet;

    @Option(names = "--progress", description = "Shows progress even without a terminal: as lines on standard error.")
    private boolean progress;

    /**
     * How the command shows its progress. Also ends the bars of loading if it is quiet.
     *
     * @param err receives progress and notes
     * @throws InputException when both options are given
     */
    TaskProgress on(PrintWriter err) {
        if (quiet && progress) {
            throw new InputException("--quiet: cannot be combined with --progress");
        }
        if (quiet) {
            LongTask.watch(null);
        }
        TaskProgress.Amount amount = quiet
                ? TaskProgress.Amount.NOTHING
                : progress ? TaskProgress.Amount.EVERYWHERE : TaskProgress.Amount.ON_A_TERMINAL;
        return new TaskProgress(amount, err);
    }
}
