package org.dronewatch.run.time;

import java.util.concurrent.TimeUnit;

/** The relation of simulated time to wall-clock time. */
@FunctionalInterface
public interface Pace {

    /** The smallest multiple of real time. */
    double SLOWEST = 0.001;

    /** The largest multiple of real time. */
    double FASTEST = 1e6;

    /** A pace without any waiting. */
    Pace AS_FAST_AS_POSSIBLE = time -> {};

    /**
     * Waits until a simulated time is due.
     *
     * @param time simulated seconds since the start of the run
     */
    void await(double time);

    /**
     * Simulated time runs at this multiple of wall-clock time, counted from the first call of {@link #await} in a run;
     * a simulation that is slower than that does not wait.
     *
     * @param factor simulated time divided by wall-clock time: 1 for real time; 0.001 to 1,000,000
     */
    static Pace realTime(double factor) {
        if (!(factor >= SLOWEST && factor <= FASTEST)) {
            throw new IllegalArgumentException("factor " + factor + " must be " + SLOWEST + " to " + FASTEST);
        }
        return new Pace() {
            private long start;
            private double last = Double.POSITIVE_INFINITY;

            @Override
            public void await(double time) {
                // A new run begins at 0 again, also after one that ended there.
                if (time <= last) {
                    start = System.nanoTime() - (long) (time / factor * 1e9);
                }
                last = time;
                long left = start + (long) (time / factor * 1e9) - System.nanoTime();
                if (left > 0) {
                    sleep(left);
                }
            }

            private void sleep(long nanos) {
                try {
                    TimeUnit.NANOSECONDS.sleep(nanos);
                } catch (InterruptedException e) {
                    Thread.currentThread().interrupt();
                }
            }
        };
    }
}
