package org.dronewatch.fuzz;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.Optional;

/** What must hold of any command, whatever it is given. */
final class Judge {
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    private Judge() {}

    /**
     * Runs a command and examines its output.
     *
     * @throws Failure when the exit code is neither 0 nor 2, or a message is not as it should be
     */
    static CommandRun run(Path directory, String... arguments) {
        CommandRun run = CommandRun.of(arguments);
        check(run, directory);
        return run;
    }

    /** Examines the output of a command. */
    static void check(CommandRun run, Path directory) {
        Optional<String> fault = Messages.fault(run, directory);
        if (fault.isPresent()) {
            throw new Failure("exit code 0 or 2, and short plain lines", fault.get());
        }
    }

    /**
     * Does something and measures the time and memory that it takes.
     *
     * @param bytes size of its input
     * @throws Failure when it takes more of the processor or of memory than is in proportion to the input
     */
    static void inProportion(long bytes, Runnable work) {
        double mostSeconds = 1.5 + 5e-7 * bytes;
        long mostBytes = (48L << 20) + 600 * bytes;
        long allocated = THREADS.getCurrentThreadAllocatedBytes();
        long cpu = THREADS.getCurrentThreadCpuTime();
        work.run();
        double seconds = 1e-9 * (THREADS.getCurrentThreadCpuTime() - cpu);
        allocated = THREADS.getCurrentThreadAllocatedBytes() - allocated;
        if (seconds > mostSeconds) {
            throw new Failure("time in proportion to the input", String.format("%.1f s for %d bytes", seconds, bytes));
        }
        if (allocated > mostBytes) {
            throw new Failure(
                    "memory in proportion to the input",
                    String.format("%d MB allocated for %d bytes", allocated >> 20, bytes));
        }
    }
}
