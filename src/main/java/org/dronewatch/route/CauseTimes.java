package org.dronewatch.route;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.sensor.Cause;

/**
 * For how long each cause keeps one sensor, or all sensors, from detecting a drone along a route.
 *
 * @param seconds time for each cause, s; for {@link Cause#DETECTED}, the time for which nothing prevents detection
 */
public record CauseTimes(Map<Cause, Double> seconds) {
    /** Copies the map. */
    public CauseTimes {
        seconds = Collections.unmodifiableMap(new LinkedHashMap<>(seconds));
    }

    /** The cause that applies for the longest time; empty if the drone is always detected. */
    public Optional<Cause> longest() {
        return seconds.entrySet().stream()
                .filter(one -> one.getKey() != Cause.DETECTED && one.getValue() > 0.0)
                .reduce((a, b) -> b.getValue() > a.getValue() ? b : a)
                .map(Map.Entry::getKey);
    }

    /** The fraction of the flight for which the drone is not detected, 0 to 1. */
    public double missed() {
        return seconds.keySet().stream()
                .filter(cause -> cause != Cause.DETECTED)
                .mapToDouble(this::share)
                .sum();
    }

    /** The fraction of the flight for which a cause applies, 0 to 1. */
    public double share(Cause cause) {
        double all = seconds.values().stream().mapToDouble(Double::doubleValue).sum();
        return all > 0.0 ? seconds.getOrDefault(cause, 0.0) / all : 0.0;
    }
}
