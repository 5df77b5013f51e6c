package org.dronewatch.viewer.part;

import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.dronewatch.parallel.Workers;

/**
 * A thread that performs only the latest request. A new request replaces one that has not been started, and notifies
 * the running one that it is out of date.
 */
public final class Latest implements AutoCloseable {
    private static final long PATIENCE_SECONDS = 5;

    private final Thread thread;
    private final int threads;
    private final Consumer<Throwable> failed;
    private Consumer<BooleanSupplier> next;
    private long asked;
    private boolean busy;
    private boolean closed;

    /**
     * Starts the thread.
     *
     * @param threads number of threads that may help
     * @param failed receives what went wrong
     */
    public Latest(String name, int threads, Consumer<Throwable> failed) {
        this.threads = threads;
        this.failed = failed;
        this.thread = new Thread(this::work, name);
        thread.setDaemon(true);
        thread.start();
    }

    /** Requests work, which receives a condition that becomes true once the result is no longer needed. */
    public synchronized void ask(Consumer<BooleanSupplier> work) {
        next = work;
        asked++;
        notifyAll();
    }

    /** Whether there is nothing to do. */
    public synchronized boolean isIdle() {
        return next == null && !busy;
    }

    private void work() {
        try (Workers workers = new Workers(threads)) {
            while (true) {
                Consumer<BooleanSupplier> work;
                long number;
                synchronized (this) {
                    busy = false;
                    while (next == null && !closed) {
                        wait();
                    }
                    if (closed) {
                        return;
                    }
                    work = next;
                    number = asked;
                    next = null;
                    busy = true;
                }
                doOne(workers, work, number);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void doOne(Workers workers, Consumer<BooleanSupplier> work, long number) {
        try {
            workers.call(() -> {
                work.accept(() -> isOutdated(number));
                return null;
            });
        } catch (RuntimeException | OutOfMemoryError e) {
            failed.accept(e);
        }
    }

    private synchronized boolean isOutdated(long number) {
        return closed || asked != number;
    }

    /** Ends the thread and waits until it is gone, for at most 5 s. */
    @Override
    public void close() {
        synchronized (this) {
            closed = true;
            notifyAll();
        }
        // Reading a model or building a tree ends early then.
        thread.interrupt();
        try {
            thread.join(TimeUnit.SECONDS.toMillis(PATIENCE_SECONDS));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
