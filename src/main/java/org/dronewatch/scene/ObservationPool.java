package org.dronewatch.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicInteger;

/** Lets several sensors look at the same time. Results come in the order of the tasks, whoever finishes first. */
final class ObservationPool implements AutoCloseable {
    private static final AtomicInteger THREADS = new AtomicInteger();

    private final ExecutorService helpers;

    /**
     * A pool of so many threads, of which the caller's is one.
     *
     * @param threads 1 or more
     */
    ObservationPool(int threads) {
        this.helpers = threads == 1
                ? null
                : Executors.newFixedThreadPool(threads, task -> {
                    Thread thread = new Thread(task, "dronewatch-sensor-" + THREADS.incrementAndGet());
                    thread.setDaemon(true);
                    return thread;
                });
    }

    /** Does all tasks; a failure of any surfaces here. */
    <T> List<T> all(List<Callable<T>> tasks) {
        List<T> results = new ArrayList<>(tasks.size());
        try {
            if (helpers == null || tasks.size() < 2) {
                for (Callable<T> task : tasks) {
                    results.add(task.call());
                }
            } else {
                for (Future<T> future : helpers.invokeAll(tasks)) {
                    results.add(future.get());
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted while sensors were looking", e);
        } catch (ExecutionException e) {
            throw unchecked(e.getCause());
        } catch (Exception e) {
            throw unchecked(e);
        }
        return results;
    }

    private static RuntimeException unchecked(Throwable problem) {
        return problem instanceof RuntimeException known ? known : new IllegalStateException(problem);
    }

    @Override
    public void close() {
        if (helpers != null) {
            helpers.shutdownNow();
        }
    }
}
