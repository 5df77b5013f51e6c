package org.dronewatch.parallel;

import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntConsumer;
import java.util.function.ObjIntConsumer;
import java.util.function.Supplier;

/**
 * A pool of threads that work for one caller. Code within {@link #call} may distribute loops over them with
 * {@link #forEach}, at any depth and without a reference to the pool, for instance to build a kd-tree, render an image
 * or evaluate the sensors of a site. Outside {@link #call}, the same loops run on the thread that calls them.
 *
 * <p>The thread that starts a loop works on it itself and waits only for parts in progress on other threads, so nested
 * loops cannot deadlock.
 *
 * <p>An interrupt of the caller's thread ends its loops, at any depth and on all threads, with a
 * {@link CancellationException}. The caller's thread stays interrupted.
 */
public final class Workers implements AutoCloseable {
    /** Maximum number of threads that can be requested. */
    public static final int MAX_THREADS = 1024;

    private static final ThreadLocal<Workers> HERE = new ThreadLocal<>();
    private static final AtomicInteger NAMES = new AtomicInteger();

    private final int threads;
    private final ExecutorService helpers;
    private final Set<Thread> helping = ConcurrentHashMap.newKeySet();
    private volatile Thread caller;

    /** While the caller waits, its own interrupt is cleared and recorded here. */
    private volatile boolean callerInterrupted;

    /**
     * A pool of a given number of threads, including the caller's.
     *
     * @throws IllegalArgumentException when below 1 or above {@link #MAX_THREADS}
     */
    public Workers(int threads) {
        if (threads < 1 || threads > MAX_THREADS) {
            throw new IllegalArgumentException("threads " + threads + " must be 1 to " + MAX_THREADS);
        }
        this.threads = threads;
        this.helpers = threads == 1 ? null : Executors.newFixedThreadPool(threads - 1, this::helper);
    }

    private Thread helper(Runnable task) {
        Thread thread = new Thread(
                () -> {
                    HERE.set(this);
                    helping.add(Thread.currentThread());
                    try {
                        task.run();
                    } finally {
                        helping.remove(Thread.currentThread());
                    }
                },
                "dronewatch-worker-" + NAMES.incrementAndGet());
        thread.setDaemon(true);
        return thread;
    }

    /**
     * Runs a task on the caller's thread, assisted by these threads, and returns its result.
     *
     * @throws RuntimeException as thrown by the task, unchanged, as are errors; a checked exception becomes the cause
     *     of an {@link IllegalStateException}
     */
    public <T> T call(Callable<T> work) {
        Workers outer = HERE.get();
        Thread before = caller;
        HERE.set(this);
        caller = Thread.currentThread();
        try {
            return work.call();
        } catch (RuntimeException e) {
            throw e;
        } catch (Exception e) {
            throw new IllegalStateException(e);
        } finally {
            caller = before;
            restore(outer);
        }
    }

    private static void restore(Workers outer) {
        if (outer == null) {
            HERE.remove();
        } else {
            HERE.set(outer);
        }
    }

    /** The number of threads that the calling code may use. */
    public static int available() {
        Workers here = HERE.get();
        return here == null ? 1 : here.threads;
    }

    /**
     * Throws an exception if the result of the calling code is no longer needed.
     *
     * @throws CancellationException when this thread, or the thread for which it works, is interrupted; its interrupt
     *     status is kept
     */
    public static void checkInterrupted() {
        Workers here = HERE.get();
        if (Thread.currentThread().isInterrupted() || here != null && here.isCallerInterrupted()) {
            throw new CancellationException("interrupted");
        }
    }

    private boolean isCallerInterrupted() {
        Thread waiting = caller;
        return callerInterrupted || waiting != null && waiting.isInterrupted();
    }

    /** Wakes helpers that sleep or wait, and ends their loops. */
    private void passInterruptOn() {
        callerInterrupted |= Thread.currentThread() == caller;
        helping.forEach(Thread::interrupt);
    }

    private void restoreInterrupt() {
        Thread.currentThread().interrupt();
        if (Thread.currentThread() == caller) {
            callerInterrupted = false;
        }
    }

    /**
     * Runs an action for each number from 0 to {@code count} - 1, in any order, on the available threads; returns when
     * all calls are done.
     *
     * @param count number of calls
     * @param action the action; no call may depend on the others
     * @throws CancellationException when the caller's thread is interrupted
     * @throws RuntimeException the first failure, unchanged, as are errors; calls that have not begun are then omitted
     */
    public static void forEach(int count, IntConsumer action) {
        forEach(count, () -> action, IntConsumer::accept);
    }

    /**
     * Runs an action for each number from 0 to {@code count} - 1, as {@link #forEach(int, IntConsumer)}, but with
     * separate scratch memory for each thread.
     *
     * @param count number of calls
     * @param scratch creates the memory of one thread
     * @param action the action; no call may depend on the others
     * @throws CancellationException when the caller's thread is interrupted
     * @throws RuntimeException the first failure, unchanged, as are errors; calls that have not begun are then omitted
     */
    public static <S> void forEach(int count, Supplier<S> scratch, ObjIntConsumer<S> action) {
        Workers here = HERE.get();
        int others = here == null ? 0 : Math.min(here.threads, count) - 1;
        Loop<S> loop = new Loop<>(here, count, scratch, action);
        loop.callHelpers(others);
        loop.work();
        loop.await();
    }

    /** Runs two tasks, in parallel if a thread is available. */
    public static void both(Runnable one, Runnable other) {
        forEach(2, which -> {
            if (which == 0) {
                one.run();
            } else {
                other.run();
            }
        });
    }

    @Override
    public void close() {
        if (helpers != null) {
            helpers.shutdownNow();
        }
    }

    /** One loop: its numbers are given out one by one to the threads that ask for them. */
    private static final class Loop<S> {
        private final Workers workers;
        private final int count;
        private final Supplier<S> scratch;
        private final ObjIntConsumer<S> action;
        private final AtomicInteger next = new AtomicInteger();
        private int finished;
        private Throwable failure;

        Loop(Workers workers, int count, Supplier<S> scratch, ObjIntConsumer<S> action) {
            this.workers = workers;
            this.count = count;
            this.scratch = scratch;
            this.action = action;
        }

        /**
         * If a thread cannot be started, the loop fails, but must not leave behind the threads that already work on it.
         */
        void callHelpers(int number) {
            try {
                for (int i = 0; i < number; i++) {
                    workers.helpers.execute(this::work);
                }
            } catch (RuntimeException | Error e) {
                abandon(e);
            }
        }

        void work() {
            int done = 0;
            try {
                int number = next.getAndIncrement();
                if (number < count) {
                    done++;
                    checkInterrupted();
                    S own = scratch.get();
                    action.accept(own, number);
                    for (number = next.getAndIncrement(); number < count; number = next.getAndIncrement()) {
                        done++;
                        checkInterrupted();
                        action.accept(own, number);
                    }
                }
            } catch (Throwable e) {
                // This also catches what the compiler does not expect here: whoever waits must not wait forever.
                abandon(e);
                if (Interrupts.isIn(e)) {
                    // The others are to be woken, too.
                    Thread.currentThread().interrupt();
                }
            } finally {
                finish(done, null);
            }
        }

        /** Numbers that have not been handed out are dropped. */
        private void abandon(Throwable problem) {
            int given = next.getAndSet(count);
            finish(Math.max(0, count - given), problem);
        }

        private synchronized void finish(int numbers, Throwable problem) {
            finished += numbers;
            failure = failure == null ? problem : failure;
            notifyAll();
        }

        synchronized void await() {
            boolean interrupted = false;
            while (finished < count) {
                try {
                    wait();
                } catch (InterruptedException e) {
                    interrupted = true;
                    workers.passInterruptOn();
                }
            }
            if (interrupted) {
                workers.restoreInterrupt();
            }
            if (failure instanceof Error error) {
                throw error;
            }
            if (failure instanceof RuntimeException known) {
                throw known;
            }
            if (failure != null) {
                throw new IllegalStateException(failure);
            }
        }
    }
}
