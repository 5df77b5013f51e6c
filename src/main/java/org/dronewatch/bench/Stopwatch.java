package org.dronewatch.bench;

import java.util.Arrays;
import java.util.List;
import java.util.function.LongSupplier;
import org.dronewatch.parallel.Workers;

/**
 * Measures how long work takes: the median of several runs, after a warm-up. Short work is repeated many times in a
 * run. Pieces of work that are to be compared run in turn, so that a spell in which the machine is slow affects all of
 * them, and so that the compiler of the virtual machine has seen all of them before any is measured.
 */
final class Stopwatch {
    private static final double NANO = 1e-9;
    private static final int RUNS = 9;
    private static final int RUNS_OF_LONG_WORK = 3;

    private final long warmUp;
    private final int mostRuns;
    private final LongSupplier clock;

    Stopwatch() {
        this(700_000_000L, RUNS, System::nanoTime);
    }

    /**
     * A stopwatch.
     *
     * @param warmUp how long each piece of work is repeated before it is measured, at least once, ns; a run lasts a
     *     twentieth of that
     * @param mostRuns maximum number of runs that are measured; at most three for work that takes longer than the
     *     warm-up
     * @param clock returns the current time, ns
     */
    Stopwatch(long warmUp, int mostRuns, LongSupplier clock) {
        this.warmUp = warmUp;
        this.clock = clock;
        this.mostRuns = mostRuns;
    }

    /** Median time of a piece of work, s. */
    double seconds(Runnable work) {
        return secondsInTurn(List.of(work))[0];
    }

    /** Median times of pieces of work that run in turn, s. */
    double[] secondsInTurn(List<Runnable> works) {
        long[] repeats = new long[works.size()];
        long longest = 0;
        for (int i = 0; i < repeats.length; i++) {
            long once = warmUp(works.get(i));
            repeats[i] = Math.max(1, warmUp / 20 / once);
            longest = Math.max(longest, once);
        }
        double[][] times =
                new double[works.size()][longest > warmUp ? Math.min(RUNS_OF_LONG_WORK, mostRuns) : mostRuns];
        for (int run = 0; run < times[0].length; run++) {
            for (int i = 0; i < repeats.length; i++) {
                Workers.checkInterrupted();
                long start = clock.getAsLong();
                for (long k = 0; k < repeats[i]; k++) {
                    works.get(i).run();
                }
                times[i][run] = NANO * (clock.getAsLong() - start) / repeats[i];
            }
        }
        return Arrays.stream(times).mapToDouble(Stopwatch::median).toArray();
    }

    /** Repeats work until it is warm, and returns the duration of the last repetition, ns. */
    private long warmUp(Runnable work) {
        long begun = clock.getAsLong();
        long once;
        do {
            Workers.checkInterrupted();
            long start = clock.getAsLong();
            work.run();
            once = Math.max(1, clock.getAsLong() - start);
        } while (clock.getAsLong() - begun < warmUp);
        return once;
    }

    private static double median(double[] times) {
        Arrays.sort(times);
        return times[times.length / 2];
    }
}
