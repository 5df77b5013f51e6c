package org.dronewatch.positioner;

import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * How a positioner finds a drone of which another sensor, standing elsewhere, knows the direction but not the range: it
 * looks along that line from near to far, stop by stop, first where the drone's size in the other sensor's image puts
 * it.
 *
 * @param minRange the line is searched from this distance to either sensor on, 1 m to 10 km, m
 * @param minSize root of the area that the smallest drone shows, 0.01 to 100 m, m
 * @param maxSize root of the area that the largest drone shows; not below that of the smallest, 0.01 to 100 m, m
 * @param dwell how long the positioner stays at each stop, 0 to 60 s; one and a half of its camera's looks at least
 */
public record RangeSearch(
        @In(value = Quantity.LENGTH, from = 1, to = 10_000) double minRange,
        @In(value = Quantity.LENGTH, from = 0.01, to = 100) double minSize,
        @In(value = Quantity.LENGTH, from = 0.01, to = 100) double maxSize,
        @In(value = Quantity.DURATION, from = 0, to = 60) double dwell) {
    /** From 50 m on, for drones of 0.1 to 0.6 m, which are assumed; 0.2 s at each stop. */
    @Defaults
    public static final RangeSearch DEFAULT = new RangeSearch(50.0, 0.1, 0.6, 0.2);

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public RangeSearch {
        Limits.check(RangeSearch.class, minRange, minSize, maxSize, dwell);
        if (minSize > maxSize) {
            throw new IllegalArgumentException("minSize " + minSize + " m must be at most maxSize " + maxSize + " m");
        }
    }

    /** The range of the smallest drone that subtends an angle, larger by its error, rad; m. */
    double nearest(double angle, double error) {
        return minSize / (angle + error);
    }

    /**
     * The range of the largest drone that subtends an angle, smaller by its error, rad; infinite where nothing is left,
     * m.
     */
    double farthest(double angle, double error) {
        return angle > error ? maxSize / (angle - error) : Double.POSITIVE_INFINITY;
    }
}
