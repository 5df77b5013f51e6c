package org.dronewatch.fuzz;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;

/** Judges cases on a separate thread and watches the clock meanwhile. */
final class Watchdog {
    /** The longest time by the clock, for a machine that is busy with other work. */
    private static final Duration LONGEST_WAIT = Duration.ofSeconds(60);

    /** A process that does next to nothing for this time waits for something that never comes. */
    private static final Duration IDLE = Duration.ofSeconds(5);

    private static final Duration NEXT_TO_NOTHING = Duration.ofMillis(150);

    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
    private static final OperatingSystemMXBean PROCESS =
            (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();

    private final FuzzTarget target;

    /**
     * A watchdog over one target.
     *
     * @param target judges the cases
     */
    Watchdog(FuzzTarget target) {
        this.target = target;
    }

    /**
     * Judges a case.
     *
     * @return what went wrong, or empty
     * @throws Hang when it does not end; the thread may still be busy with it
     */
    Optional<Throwable> judge(FuzzCase input, Path directory) throws Hang {
        Throwable[] problem = new Throwable[1];
        // A thread for each case: whatever it leaves behind is gone with it.
        Thread thread = new Thread(
                () -> {
                    try {
                        target.judge(input, directory);
                    } catch (Throwable e) {
                        problem[0] = e;
                    }
                },
                "case");
        thread.setDaemon(true);
        thread.start();
        long start = System.nanoTime();
        long busy = start;
        long used = PROCESS.getProcessCpuTime();
        try {
            for (int pause = 1; thread.isAlive(); pause = Math.min(2 * pause, 200)) {
                thread.join(pause);
                long now = System.nanoTime();
                long cpu = THREADS.getThreadCpuTime(thread.getId());
                if (PROCESS.getProcessCpuTime() - used > NEXT_TO_NOTHING.toNanos()) {
                    used = PROCESS.getProcessCpuTime();
                    busy = now;
                }
                if (cpu > target.longest().toNanos()
                        || now - busy > IDLE.toNanos()
                        || now - start > LONGEST_WAIT.toNanos()) {
                    throw new Hang(input, thread.getStackTrace(), Duration.ofNanos(cpu), Duration.ofNanos(now - start));
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        return Optional.ofNullable(problem[0]);
    }

    /** A case that does not end. */
    static final class Hang extends Exception {
        private static final long serialVersionUID = 1L;

        Hang(FuzzCase input, StackTraceElement[] where, Duration cpu, Duration wall) {
            super(String.format(
                    "not done after %.1f s (%.1f s of the processor) with %d bytes: %s",
                    wall.toMillis() / 1e3, cpu.toMillis() / 1e3, input.bytes(), Failure.places(where)));
            setStackTrace(where);
        }

        /** The same for cases that hang in the same place. */
        String shape() {
            StackTraceElement[] trace = getStackTrace();
            String places = Failure.places(trace);
            return "hangs in "
                    + places.substring(places.lastIndexOf('<') + 1)
                            .replaceAll("\\$\\$Lambda[^.]*", "")
                            .strip();
        }
    }
}
