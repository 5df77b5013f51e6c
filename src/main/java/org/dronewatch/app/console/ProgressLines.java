package org.dronewatch.app.console;

import java.io.PrintWriter;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.function.LongSupplier;
import org.dronewatch.setting.PlainText;

/**
 * States how far a task has come where no bar can be drawn: in a line every five seconds and one at its end or, as a
 * sign of life, in a single line after half a minute. Thread-safe.
 */
final class ProgressLines {
    private static final double NANO = 1e-9;
    private static final double EVERY_SECONDS = 5.0;
    private static final double SIGN_OF_LIFE_SECONDS = 30.0;
    private static final int MINUTE = 60;
    private static final long PERCENT = 100;

    private final String task;
    private final long steps;
    private final PrintWriter err;
    private final LongSupplier clock;
    private final long start;
    private final double every;
    private final boolean isEndStated;
    private final TimeLeft left;
    private double next;

    /**
     * Begins a task whose progress is stated regularly.
     *
     * @param steps their approximate number; negative if it is not known
     * @param clock returns the current time, ns
     */
    ProgressLines(String task, long steps, PrintWriter err, LongSupplier clock) {
        this(task, steps, err, clock, EVERY_SECONDS, EVERY_SECONDS, true);
    }

    private ProgressLines(
            String task,
            long steps,
            PrintWriter err,
            LongSupplier clock,
            double first,
            double every,
            boolean isEndStated) {
        this.next = first;
        this.every = every;
        this.isEndStated = isEndStated;
        this.task = PlainText.value(task);
        this.steps = steps;
        this.left = new TimeLeft(steps);
        this.err = err;
        this.clock = clock;
        this.start = clock.getAsLong();
    }

    /** Begins a task that gives a single sign of life if it takes long; arguments as for the constructor. */
    static ProgressLines once(String task, long steps, PrintWriter err, LongSupplier clock) {
        return new ProgressLines(task, steps, err, clock, SIGN_OF_LIFE_SECONDS, Double.POSITIVE_INFINITY, false);
    }

    /** Takes the number of steps that are done so far. */
    synchronized void reached(long done) {
        double seconds = seconds();
        OptionalDouble rest = left.after(done, seconds);
        if (seconds >= next && done > 0 && steps < 0) {
            next = seconds + every;
            err.printf(Locale.ROOT, "%s: %d done after %s%n", task, done, duration(seconds));
        } else if (seconds >= next && done > 0 && done < steps) {
            next = seconds + every;
            err.printf(Locale.ROOT, "%s: %s%n", task, part(done, seconds, rest));
        }
    }

    /** How much is done, and how long the rest takes or, where that is unknown, how long it took so far. */
    private String part(long done, double seconds, OptionalDouble rest) {
        long percent = PERCENT * done / steps;
        return (percent == 0 ? "less than 1 %" : percent + " %")
                + (rest.isPresent() ? ", " + duration(rest.getAsDouble()) + " left" : " after " + duration(seconds));
    }

    /** Reports that the task is complete. */
    synchronized void ended() {
        if (isEndStated) {
            err.printf(Locale.ROOT, "%s: done after %s%n", task, duration(seconds()));
        }
    }

    /** Reports that the task was ended before it was complete. */
    synchronized void stopped() {
        if (isEndStated) {
            err.printf(Locale.ROOT, "%s: stopped after %s%n", task, duration(seconds()));
        }
    }

    private double seconds() {
        return NANO * (clock.getAsLong() - start);
    }

    /** A time, s, in words: in whole seconds, minutes or hours. */
    static String duration(double seconds) {
        if (seconds < MINUTE) {
            return Math.round(seconds) + " s";
        }
        long minutes = Math.round(seconds / MINUTE);
        return minutes < MINUTE ? minutes + " min" : minutes / MINUTE + " h " + minutes % MINUTE + " min";
    }
}
