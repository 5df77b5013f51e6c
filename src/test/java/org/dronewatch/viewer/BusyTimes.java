package org.dronewatch.viewer;

import java.awt.AWTEvent;
import java.awt.EventQueue;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;

/** How long the event thread computes for each event: its processor time, which other programs do not affect. */
final class BusyTimes extends EventQueue {
    private static final double NANO = 1e-9;
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private volatile double longest;
    private volatile int count;

    @Override
    protected void dispatchEvent(AWTEvent event) {
        long start = THREADS.getCurrentThreadCpuTime();
        super.dispatchEvent(event);
        longest = Math.max(longest, NANO * (THREADS.getCurrentThreadCpuTime() - start));
        count++;
    }

    /** The longest time, s. */
    double longest() {
        return longest;
    }

    /** The number of events. */
    int count() {
        return count;
    }

    /** Leaves the events to the queue before. */
    void end() {
        pop();
    }
}
