package org.dronewatch.app.console;

import java.io.PrintWriter;
import java.io.Writer;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.IntConsumer;
import java.util.function.LongConsumer;
import me.tongfei.progressbar.ProgressBar;

/**
 * Shows the progress of a command's tasks, and its messages.
 *
 * @param amount how much of the progress and the messages is shown
 * @param err receives the progress and the messages
 */
public record TaskProgress(Amount amount, PrintWriter err) {
    /** Stands for an unknown number of steps. */
    static final long UNKNOWN = -1;

    /** How much is shown. */
    enum Amount {
        /** Warnings only. */
        NOTHING,
        /** Notes, and bars if there is a terminal; if there is none, a single line for each task that takes long. */
        ON_A_TERMINAL,
        /** Notes, and bars if there is a terminal; if there is none, regular lines. */
        EVERYWHERE
    }

    /** Whether only warnings are shown. */
    private boolean isQuiet() {
        return amount == Amount.NOTHING;
    }

    /** The receiver of notes and warnings for the user, one line each. */
    public Consumer<String> notes() {
        return Notes.to(err, isQuiet());
    }

    /**
     * Runs a task that reports how many steps it has done since the last time, from any thread.
     *
     * @param steps approximate number of steps
     */
    public <T> T during(String task, long steps, Function<IntConsumer, T> work) {
        return during(task, steps, work, () -> false);
    }

    /**
     * Runs a task that reports how many steps it has done since the last time, from any thread, and that may return the
     * results so far if it is interrupted.
     *
     * @param isCut whether the task was interrupted; queried at the end
     */
    public <T> T during(String task, long steps, Function<IntConsumer, T> work, BooleanSupplier isCut) {
        try (ProgressBar bar = bar(task, steps)) {
            if (bar != null) {
                return work.apply(total(bar::stepTo));
            }
            if (isQuiet()) {
                return work.apply(some -> {});
            }
            ProgressLines lines = amount == Amount.EVERYWHERE
                    ? new ProgressLines(task, steps, err, System::nanoTime)
                    : ProgressLines.once(task, steps, err, System::nanoTime);
            T result = work.apply(total(lines::reached));
            if (isCut.getAsBoolean()) {
                lines.stopped();
            } else {
                lines.ended();
            }
            return result;
        }
    }

    /** Runs a task of an unknown number of steps, which reports how many it has done since the last time. */
    public <T> T during(String task, Function<IntConsumer, T> work) {
        return during(task, UNKNOWN, work);
    }

    private static IntConsumer total(LongConsumer shown) {
        AtomicLong done = new AtomicLong();
        return some -> shown.accept(done.addAndGet(some));
    }

    /** A bar; null if none is shown. */
    private ProgressBar bar(String task, long steps) {
        return isQuiet() ? null : Progress.barOf(task, steps);
    }

    /**
     * The progress of the cases of a campaign, which is also shown without a terminal unless the command is quiet.
     *
     * @param all number of cases, those of earlier runs included
     */
    public CaseProgress cases(String name, int all) {
        PrintWriter target = isQuiet() ? new PrintWriter(Writer.nullWriter()) : err;
        return new CaseProgress(
                all,
                target,
                left -> isQuiet() ? null : Progress.barOf(name, all, bar -> left.get()),
                amount == Amount.EVERYWHERE,
                System::nanoTime);
    }
}
