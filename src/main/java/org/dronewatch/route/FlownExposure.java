package org.dronewatch.route;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;

/**
 * How exposed a drone is on a route as it is flown: by every look that the sensors take, where it is taken, and not by
 * cells of a field.
 *
 * @param looks those that may detect the drone, in the order of time
 * @param bySensor the exposure to each sensor along the whole route, in the order of the scene
 */
public record FlownExposure(List<Step> looks, Map<String, Double> bySensor) {
    /**
     * What a look adds to the exposure.
     *
     * @param before time of the sensor's look before, at the earliest the start, s since the start
     * @param time of the look, s since the start
     * @param exposure that it adds, {@code -ln(1 - p)} for an independent look, above 0
     */
    public record Step(double before, double time, double exposure) {}

    /** Copies the list and the map. */
    public FlownExposure {
        looks = List.copyOf(looks);
        bySensor = Collections.unmodifiableMap(new LinkedHashMap<>(bySensor));
    }

    /** The exposure to all looks up to a time, inclusive, s. */
    public double until(double time) {
        return looks.stream()
                .filter(look -> look.time() <= time)
                .mapToDouble(Step::exposure)
                .sum();
    }

    /** The same if what a look adds were spread evenly over the time since the look before, for pictures. */
    double spreadUntil(double time) {
        double sum = 0.0;
        for (Step look : looks) {
            double lasts = look.time() - look.before();
            sum += look.time() <= time
                    ? look.exposure()
                    : Math.max(0.0, (time - look.before()) / lasts) * look.exposure();
        }
        return sum;
    }

    /** The probability that the drone is detected up to a time, inclusive, 0 to 1. */
    public double detection(double until) {
        return -Math.expm1(-until(until));
    }

    /** The median time of the first detection among the flights on which there is one, s; empty if there is none. */
    public OptionalDouble medianDetection() {
        double wanted = 0.5 * detection(Double.POSITIVE_INFINITY);
        double sum = 0.0;
        for (Step look : looks) {
            sum += look.exposure();
            if (-Math.expm1(-sum) >= wanted) {
                return OptionalDouble.of(look.time());
            }
        }
        return OptionalDouble.empty();
    }
}
