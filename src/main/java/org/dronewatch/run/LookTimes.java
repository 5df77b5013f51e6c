package org.dronewatch.run;

import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.LongAdder;

/** How long the sensors of each kind looked, summed over all threads. Shared by all threads. */
public final class LookTimes {
    private static final double NANO = 1e-9;

    private final Map<String, LongAdder> nanos = new ConcurrentHashMap<>();

    /** Adds a look of a sensor. */
    void add(String kind, long nanoseconds) {
        nanos.computeIfAbsent(kind, name -> new LongAdder()).add(nanoseconds);
    }

    /** Seconds by kind. */
    public Map<String, Double> seconds() {
        Map<String, Double> seconds = new TreeMap<>();
        nanos.forEach((kind, sum) -> seconds.put(kind, NANO * sum.sum()));
        return seconds;
    }
}
