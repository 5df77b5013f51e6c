package org.dronewatch.placement;

import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;

/**
 * Decides when the searches that share this object end before they are complete: once the time that they may take
 * together is up, or the user asks them to stop. A search that has no layout by then may go on for a few seconds more.
 * Thread-safe.
 */
public final class SearchEnd {
    /** How long a search without any layout may go on after it should have ended, s. */
    public static final double GRACE = 5.0;

    /**
     * How long, after the time limit of a search, further work that depends on its result may go on, s: the coverage of
     * the layout, flights along the routes past it, and simulated attacks on it.
     */
    public static final double FOLLOW_UP = 10.0;

    private static final double NANOS = 1e-9;

    private final double seconds;
    private final BooleanSupplier isStopped;
    private final LongSupplier clock;
    private final AtomicReference<Long> begun = new AtomicReference<>();
    private final AtomicReference<Long> noticed = new AtomicReference<>();

    /**
     * An end.
     *
     * @param seconds time that the searches may take together, s, above 0; infinite for no limit
     * @param isStopped queried repeatedly; whether the user has asked for the end
     */
    SearchEnd(double seconds, BooleanSupplier isStopped) {
        this(seconds, isStopped, System::nanoTime);
    }

    /**
     * An end timed by another clock.
     *
     * @param clock gives the time since some fixed moment, ns
     */
    SearchEnd(double seconds, BooleanSupplier isStopped, LongSupplier clock) {
        if (!(seconds > 0.0)) {
            throw new IllegalArgumentException("time limit " + seconds + " s: must be above 0");
        }
        this.seconds = seconds;
        this.isStopped = isStopped;
        this.clock = clock;
    }

    /** The time that the searches may take together, s; infinite for no limit. */
    public double seconds() {
        return seconds;
    }

    /** Begins a search: the time runs from the first call. */
    public void begin() {
        begun.compareAndSet(null, clock.getAsLong());
    }

    /** Whether the user has asked the searches to stop. */
    public boolean isStopped() {
        return isStopped.getAsBoolean();
    }

    /** Whether the time is up. */
    public boolean isTimeOver() {
        return since(begun) > seconds;
    }

    /** Whether searches that have a layout are to end, because the time is up or the user has asked them to stop. */
    public boolean isDue() {
        boolean isDue = isStopped() || isTimeOver();
        if (isDue && noticed.get() == null) {
            noticed.compareAndSet(null, clock.getAsLong());
        }
        return isDue;
    }

    /**
     * Whether searches are to end even without a layout: {@link #GRACE} seconds after one of them has noticed that it
     * is to end.
     */
    public boolean isGraceOver() {
        return isDue() && since(noticed) > GRACE;
    }

    /** Seconds since a moment; 0 if it has not come. */
    private double since(AtomicReference<Long> moment) {
        Long nanos = moment.get();
        return nanos == null ? 0.0 : NANOS * (clock.getAsLong() - nanos);
    }
}
