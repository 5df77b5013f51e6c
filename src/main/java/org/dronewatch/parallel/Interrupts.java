package org.dronewatch.parallel;

import java.io.InterruptedIOException;
import java.nio.channels.ClosedByInterruptException;
import java.util.concurrent.CancellationException;
import java.util.function.Supplier;
import org.dronewatch.setting.InputException;

/** Converts every interrupt to the same exception, however the interrupted code reported it. */
public final class Interrupts {
    private Interrupts() {}

    /**
     * Runs a task that may be ended by an interrupt of this thread.
     *
     * @throws CancellationException when this thread is interrupted, before or during the task; its interrupt status is
     *     kept
     */
    public static <T> T surfacing(Supplier<T> work) {
        Workers.checkInterrupted();
        try {
            return work.get();
        } catch (RuntimeException e) {
            if (!comesFromInterrupt(e)) {
                throw e;
            }
            Thread.currentThread().interrupt();
            throw e instanceof CancellationException known ? known : cancellation(e);
        }
    }

    private static CancellationException cancellation(RuntimeException cause) {
        CancellationException cancellation = new CancellationException("interrupted");
        cancellation.initCause(cause);
        return cancellation;
    }

    private static boolean comesFromInterrupt(RuntimeException problem) {
        return isIn(problem) || Thread.currentThread().isInterrupted() && !(problem instanceof InputException);
    }

    /**
     * Whether an exception was caused by an interrupt: code that waits, or reads a file, throws various exceptions, and
     * may clear the interrupt status.
     */
    public static boolean isIn(Throwable problem) {
        for (Throwable cause = problem; cause != null; cause = cause.getCause()) {
            if (cause instanceof InterruptedException
                    || cause instanceof ClosedByInterruptException
                    || cause instanceof InterruptedIOException) {
                return true;
            }
        }
        return false;
    }
}
