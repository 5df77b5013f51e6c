package org.dronewatch.parallel;

import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;

/**
 * A step of loading that may take seconds, reported to a watcher of the calling thread: a command with a terminal shows
 * a progress bar. If nobody watches, one line announces the task. Thread-safe: several workers may advance it.
 */
public final class LongTask implements AutoCloseable {
    /** The maximum number of times that a task of known length is reported. */
    private static final long REPORTS = 500;

    /** The number of steps after which a task of unknown length is reported. */
    private static final long SOME = 1 << 12;

    /** Steps are counted in parts, so that threads may add fractions in any order. */
    private static final long PARTS = 1 << 20;

    private static final ThreadLocal<Watcher> WATCHER = new ThreadLocal<>();

    private final Watcher watcher;
    private final long every;
    /** The work done, in parts of steps. */
    private final AtomicLong done = new AtomicLong();

    /** Shows the progress of tasks; called by the thread that began the task, and by its workers. */
    public interface Watcher {
        /**
         * Called when a task begins.
         *
         * @param what what the task does, in words
         * @param steps number of steps; negative if that is not known
         */
        void started(String what, long steps);

        /** Called with the number of steps done so far. */
        void advanced(long steps);

        /** Called when the task has ended or failed. */
        void ended();
    }

    private LongTask(Watcher watcher, long every) {
        this.watcher = watcher;
        this.every = every;
    }

    /** Sets the watcher of the tasks that the calling thread begins from now on; null for none. */
    public static void watch(Watcher watcher) {
        if (watcher == null) {
            WATCHER.remove();
        } else {
            WATCHER.set(watcher);
        }
    }

    /** A task that is reported to nobody. */
    public static LongTask silent() {
        return new LongTask(null, Long.MAX_VALUE);
    }

    /**
     * Begins a task.
     *
     * @param what what the task does, such as {@code terrain: reading 4,000,000 posts}
     * @param steps number of steps; negative if that is not known
     * @param isLong whether the task will take more than a second or so; other tasks are silent
     * @param announce receives one line if nobody watches
     */
    public static LongTask begin(String what, long steps, boolean isLong, Consumer<String> announce) {
        if (!isLong) {
            return silent();
        }
        Watcher watcher = WATCHER.get();
        if (watcher == null) {
            announce.accept(what + " ...");
            return silent();
        }
        watcher.started(what, steps);
        return new LongTask(watcher, steps < 0 ? SOME : Math.max(1, steps / REPORTS));
    }

    /** Records that a number of steps, not necessarily whole, have been done. */
    public void advance(double steps) {
        if (watcher != null) {
            long parts = (long) (steps * PARTS);
            long now = done.addAndGet(parts);
            if (now / PARTS / every != (now - parts) / PARTS / every) {
                watcher.advanced(now / PARTS);
            }
        }
    }

    /** Records that the task is done or has failed. */
    @Override
    public void close() {
        if (watcher != null) {
            watcher.ended();
        }
    }
}
