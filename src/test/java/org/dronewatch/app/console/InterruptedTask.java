package org.dronewatch.app.console;

import java.util.concurrent.atomic.AtomicInteger;

/**
 * An interruption at a given moment of a task: moments are the lines that the task prints, which include one at the end
 * of each of its parts, and whatever else calls {@link #moment}.
 */
public final class InterruptedTask implements AutoCloseable {
    private final int when;
    private final boolean isByTime;
    private final AtomicInteger moments = new AtomicInteger();
    private final Interruption interruption = new Interruption();

    /**
     * A task of the calling thread.
     *
     * @param when the number of the moment at which it is interrupted, from 1; 0 for never
     */
    public InterruptedTask(int when) {
        this(when, false);
    }

    private InterruptedTask(int when, boolean isByTime) {
        this.when = when;
        this.isByTime = isByTime;
    }

    /** A task whose time is over at a moment; arguments as above. */
    public static InterruptedTask outOfTime(int when) {
        return new InterruptedTask(when, true);
    }

    /** One more moment. */
    public void moment() {
        if (moments.incrementAndGet() != when) {
            return;
        }
        if (isByTime) {
            interruption.timeIsOver();
        } else {
            interruption.interruptCommand();
        }
    }

    /** The number of moments so far. */
    public int moments() {
        return moments.get();
    }

    /** The interruption. */
    public Interruption interruption() {
        return interruption;
    }

    /** Each line is a moment. */
    public TaskProgress shown() {
        return HeardProgress.of(line -> moment(), this::moment);
    }

    /** Ends the task; the thread of the caller is not interrupted then. */
    @Override
    public void close() {
        interruption.close();
        Thread.interrupted();
    }
}
