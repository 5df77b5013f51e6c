package org.dronewatch.app.console;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * Turns Ctrl-C, a request to terminate, and the end of a time limit into an orderly end. The thread of the command is
 * interrupted, so that it ends whatever it is doing, cleans up or writes what it has. Only then does the process end;
 * after a signal, it ends with the signal's exit code.
 */
public final class Interruption implements AutoCloseable {
    private static final long PATIENCE_SECONDS = 60;

    private final Thread command = Thread.currentThread();
    private final CountDownLatch ended = new CountDownLatch(1);
    private final Thread hook = new Thread(this::stop, "interruption");
    private boolean finishing;
    private volatile boolean happened;
    private volatile boolean outOfTime;

    /** Watches over what the calling thread does from now on, until this object is closed. */
    public Interruption() {
        try {
            Runtime.getRuntime().addShutdownHook(hook);
        } catch (IllegalStateException e) {
            // The process is already shutting down and does not wait.
            happened = true;
        }
    }

    /**
     * Whether the process is already ending. After a signal, Java then exits with the signal's exit code, which the
     * command must not replace with its own.
     */
    public static boolean isUnderWay() {
        Thread none = new Thread(() -> {});
        try {
            Runtime.getRuntime().addShutdownHook(none);
            Runtime.getRuntime().removeShutdownHook(none);
            return false;
        } catch (IllegalStateException e) {
            return true;
        }
    }

    /** Whether the command is to stop: the user has asked for it, or its time is up. */
    public boolean happened() {
        return happened;
    }

    /** Whether the command is stopped by the end of the time limit, not by an earlier request of the user. */
    public boolean isOutOfTime() {
        return outOfTime;
    }

    /**
     * Limits the time of the command: once that time is over, the command's thread is interrupted, unless
     * {@link #letFinish} has been called by then.
     *
     * @param seconds time from now, s
     */
    public void limit(double seconds) {
        long nanos = (long) (TimeUnit.SECONDS.toNanos(1) * seconds);
        Thread timer = new Thread(
                () -> {
                    try {
                        if (!ended.await(nanos, TimeUnit.NANOSECONDS)) {
                            timeIsOver();
                        }
                    } catch (InterruptedException e) {
                        Thread.currentThread().interrupt();
                    }
                },
                "time limit");
        timer.setDaemon(true);
        timer.start();
    }

    /** What happens when the time limit is reached; tests call this without waiting. */
    synchronized void timeIsOver() {
        if (!finishing && !happened) {
            outOfTime = true;
            interruptCommand();
        }
    }

    /** Lets the command finish: from now on it only writes what it has, and its thread is not interrupted again. */
    public synchronized void letFinish() {
        finishing = true;
        if (happened) {
            // The interrupt has done its work, and must not stop the writing.
            Thread.interrupted();
        }
    }

    /** What happens on a signal; tests call this without one. */
    synchronized void interruptCommand() {
        happened = true;
        if (!finishing) {
            command.interrupt();
        }
    }

    private void stop() {
        interruptCommand();
        try {
            if (!ended.await(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
                System.err.println("stopped after waiting " + PATIENCE_SECONDS + " s for an orderly shutdown");
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public void close() {
        letFinish();
        ended.countDown();
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException e) {
            // The process is already shutting down: the hook is what waits for us.
            happened = true;
        }
    }
}
