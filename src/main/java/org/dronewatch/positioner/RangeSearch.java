package org.dronewatch.positioner;

import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * The search for a drone along the line of a cue that has a direction but no range. The positioner looks along that
 * line from near to far, stop by stop, but it begins where the drone's size in the cueing sensor's image suggests that
 * the drone is.
 *
 * @param minRange minimum distance from both the cueing sensor and the positioner at which the line is searched, 1 to
 *     10,000 m
 * @param minSize square root of the visible area of the smallest drone, 0.01 to 100 m
 * @param maxSize square root of the visible area of the largest drone, at least minSize and at most 100 m
 * @param dwell how long the positioner stays at each stop, 0 to 60 s; at least one and a half intervals between its
 *     camera's looks
 */
public record RangeSearch(
        @In(value = Quantity.LENGTH, from = 1, to = 10_000) double minRange,
        @In(value = Quantity.LENGTH, from = 0.01, to = 100) double minSize,
        @In(value = Quantity.LENGTH, from = 0.01, to = 100) double maxSize,
        @In(value = Quantity.DURATION, from = 0, to = 60) double dwell) {
    /** A search from 50 m outwards for drones of 0.1 to 0.6 m, with 0.2 s at each stop; these values are assumed. */
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

    /** The range, m, at which the smallest drone subtends an angle enlarged by its error, rad. */
    double nearest(double angle, double error) {
        return minSize / (angle + error);
    }

    /**
     * The range, m, at which the largest drone subtends an angle reduced by its error, rad; infinite if the error is
     * not smaller than the angle.
     */
    double farthest(double angle, double error) {
        return angle > error ? maxSize / (angle - error) : Double.POSITIVE_INFINITY;
    }
}
