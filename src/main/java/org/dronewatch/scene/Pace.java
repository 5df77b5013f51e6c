package org.dronewatch.scene;

import java.util.concurrent.TimeUnit;

/** How simulated time keeps to the time on the wall. */
@FunctionalInterface
public interface Pace {

    /** No waiting. */
    Pace AS_FAST_AS_POSSIBLE = time -> {};

    /**
     * Waits until it is time.
     *
     * @param time simulated seconds since the start of the run
     */
    void await(double time);

    /**
     * Simulated time runs so many times as fast as the clock on the wall, from the first call on; a simulation that is
     * slower than that is late and does not wait.
     *
     * @param factor 1 for real time; above 0
     */
    static Pace realTime(double factor) {
        if (!(factor > 0.0 && factor < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("speed factor " + factor + " must be above 0 and finite");
        }
        return new Pace() {
            private long start;
            private double last = Double.POSITIVE_INFINITY;

            @Override
            public void await(double time) {
                // A new run begins at 0 again.
                if (time < last) {
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
