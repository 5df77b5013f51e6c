package org.dronewatch.viewer.part;

import java.lang.reflect.InvocationTargetException;
import java.util.concurrent.atomic.AtomicReference;
import javax.swing.SwingUtilities;

/** Work that another thread hands over to the event thread. */
public final class EventWork {
    private EventWork() {}

    /**
     * Runs something on the event thread, and waits until it is done; an interrupt ends the waiting.
     *
     * @throws RuntimeException what the work throws
     */
    public static void await(Runnable work) {
        AtomicReference<RuntimeException> failure = new AtomicReference<>();
        try {
            SwingUtilities.invokeAndWait(() -> {
                try {
                    work.run();
                } catch (RuntimeException e) {
                    failure.set(e);
                }
            });
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } catch (InvocationTargetException e) {
            throw new IllegalStateException(e.getCause());
        }
        if (failure.get() != null) {
            throw failure.get();
        }
    }
}
