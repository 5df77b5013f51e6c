package org.dronewatch.app.console;

import java.io.PrintWriter;
import java.util.Locale;
import java.util.function.LongSupplier;
import org.dronewatch.setting.PlainText;

/**
 * States how far a task has come where no bar can be drawn: in a line every five seconds and one at its end.
 * Thread-safe.
 */
final class ProgressLines {
    private static final double NANO = 1e-9;
    private static final double EVERY_SECONDS = 5.0;
    private static final int MINUTE = 60;
    private static final long PERCENT = 100;

    private final String task;
    private final long steps;
    private final PrintWriter err;
    private final LongSupplier clock;
    private final long start;
    private double next = EVERY_SECONDS;

    /**
     * The task begins.
     *
     * @param steps their approximate number; negative if it is not known
     * @param clock gives the time, ns
     */
    ProgressLines(String task, long steps, PrintWriter err, LongSupplier clock) {
        this.task = PlainText.value(task);
        this.steps = steps;
        this.err = err;
        this.clock = clock;
        this.start = clock.getAsLong();
    }

    /** A number of steps is done in all. */
    synchronized void reached(long done) {
        double seconds = seconds();
        if (seconds >= next && done > 0 && steps < 0) {
            next = seconds + EVERY_SECONDS;
            err.printf(Locale.ROOT, "%s: %d after %s%n", task, done, duration(seconds));
        } else if (seconds >= next && done > 0 && done < steps) {
            next = seconds + EVERY_SECONDS;
            String left = duration(seconds * (steps - done) / done);
            err.printf(Locale.ROOT, "%s: %d %%, %s left%n", task, PERCENT * done / steps, left);
        }
    }

    /** The task is complete. */
    synchronized void ended() {
        err.printf(Locale.ROOT, "%s: done after %s%n", task, duration(seconds()));
    }

    private double seconds() {
        return NANO * (clock.getAsLong() - start);
    }

    /** A time in whole seconds, minutes or hours, s. */
    static String duration(double seconds) {
        if (seconds < MINUTE) {
            return Math.round(seconds) + " s";
        }
        long minutes = Math.round(seconds / MINUTE);
        return minutes < MINUTE ? minutes + " min" : minutes / MINUTE + " h " + minutes % MINUTE + " min";
    }
}
