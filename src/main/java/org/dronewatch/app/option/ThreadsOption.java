package org.dronewatch.app.option;

import java.util.concurrent.Callable;
import org.dronewatch.parallel.Workers;
import org.dronewatch.setting.InputException;
import picocli.CommandLine.Option;

/** The option of commands that use several threads. */
public final class ThreadsOption {
    @Option(
            names = "--threads",
            paramLabel = "N",
            description = "Threads to use, 1 to " + Workers.MAX_THREADS + "; all cores by default.")
    private int threads = Runtime.getRuntime().availableProcessors();

    /** The number of threads, checked against its limits. */
    public int number() {
        if (threads < 1 || threads > Workers.MAX_THREADS) {
            throw new InputException("--threads " + threads + ": must be 1 to " + Workers.MAX_THREADS);
        }
        return threads;
    }

    /** Runs a task on this number of threads. */
    public <T> T call(Callable<T> work) {
        try (Workers workers = new Workers(number())) {
            return workers.call(work);
        }
    }
}
