package org.dronewatch.app.console;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Estimates how much longer a task will take. The first steps say little: they include preparations, and steps of one
 * kind, such as those of one sensor, follow one another. So nothing is estimated before a quarter of the work is done
 * or, after two minutes, a twentieth, and then from the speed in the second half of the time so far. If no step ended
 * in that half, the last estimate still holds. For one thread at a time.
 */
final class TimeLeft {
    /** The fraction of the steps that has to be done. */
    private static final double LEAST_DONE = 0.25;

    /** After this time, less has to be done: a long task would otherwise give no estimate for too long, s. */
    private static final double LONG_SECONDS = 120.0;

    /** The fraction of the steps that has to be done then. */
    private static final double LEAST_DONE_OF_LONG = 0.05;

    /** The time between two moments that are remembered, s. */
    private static final double EVERY_SECONDS = 1.0;

    private static final double NANO = 1e-9;

    private final long steps;

    /** The last moment of the first half of the time, and those after it. */
    private Moment from = new Moment(0.0, 0);

    private final Deque<Moment> later = new ArrayDeque<>();

    /** When the task would end by the last estimate, s; not a number before the first one. */
    private double end = Double.NaN;

    private record Moment(double seconds, long done) {}

    /**
     * The task begins.
     *
     * @param steps their approximate number
     */
    TimeLeft(long steps) {
        this.steps = steps;
    }

    /**
     * The time that the task still takes once a number of steps is done in all, s; empty where it cannot be estimated
     * yet. To be called often, in order of time.
     *
     * @param seconds since the task began, s
     */
    OptionalDouble after(long done, double seconds) {
        Moment last = later.isEmpty() ? from : later.getLast();
        if (seconds >= last.seconds() + EVERY_SECONDS) {
            later.add(new Moment(seconds, done));
        }
        while (!later.isEmpty() && later.getFirst().seconds() <= 0.5 * seconds) {
            from = later.removeFirst();
        }
        double least = seconds < LONG_SECONDS ? LEAST_DONE : LEAST_DONE_OF_LONG;
        if (done < least * steps || done >= steps) {
            return OptionalDouble.empty();
        }
        if (done > from.done()) {
            end = seconds + (seconds - from.seconds()) * (steps - done) / (done - from.done());
        }
        return end > seconds ? OptionalDouble.of(end - seconds) : OptionalDouble.empty();
    }

    /** The same for a bar. */
    Optional<Duration> after(long done, Duration time) {
        OptionalDouble left = after(done, NANO * time.toNanos());
        return left.isPresent() ? Optional.of(Duration.ofSeconds(Math.round(left.getAsDouble()))) : Optional.empty();
    }
}
