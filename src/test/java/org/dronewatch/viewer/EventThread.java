package org.dronewatch.viewer;

import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import java.util.function.BooleanSupplier;
import javax.swing.SwingUtilities;

/** What tests do on the event thread, and what they wait for there. */
public final class EventThread {
    private static final long PATIENCE_NANOS = 60_000_000_000L;
    private static final long PAUSE_MILLIS = 20;

    private EventThread() {}

    /** Does something on the event thread, and waits until it is done. */
    public static <T> T onEventThread(Callable<T> work) throws Exception {
        FutureTask<T> task = new FutureTask<>(work);
        SwingUtilities.invokeAndWait(task);
        return task.get();
    }

    /**
     * Waits until a condition holds on the event thread.
     *
     * @throws AssertionError after a minute
     */
    static void await(String what, BooleanSupplier condition) throws Exception {
        long end = System.nanoTime() + PATIENCE_NANOS;
        while (!onEventThread(condition::getAsBoolean)) {
            if (System.nanoTime() > end) {
                throw new AssertionError("waited for a minute: " + what);
            }
            Thread.sleep(PAUSE_MILLIS);
        }
    }
}
