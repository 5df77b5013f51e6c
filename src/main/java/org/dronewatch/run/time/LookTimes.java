package org.dronewatch.run.time;

import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.LongAdder;

/** The computing time of the looks of each kind of sensor, summed over all threads. Thread-safe. */
public final class LookTimes {
    private static final double NANO = 1e-9;

    private final Map<String, LongAdder> nanos = new ConcurrentHashMap<>();

    /** Adds a look of a sensor. */
    void add(String kind, long nanoseconds) {
        nanos.computeIfAbsent(kind, name -> new LongAdder()).add(nanoseconds);
    }

    /** Seconds by kind of sensor. */
    public Map<String, Double> seconds() {
        Map<String, Double> seconds = new TreeMap<>();
        nanos.forEach((kind, sum) -> seconds.put(kind, NANO * sum.sum()));
        return seconds;
    }
}
