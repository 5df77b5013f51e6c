package org.dronewatch.report.html.run;

/**
 * The best value that a sensor measured of a drone in a run: closest to its threshold, or farthest above it.
 *
 * @param time time of the look, s
 * @param range range of the drone, m
 * @param value measured value
 * @param threshold value required for a detection; infinite where an observer had not found the drone yet, but could
 *     have
 * @param unit unit of value and threshold
 */
record BestLook(double time, double range, double value, double threshold, String unit) {
    /** How far the value is above the threshold; 0 if only time was lacking. */
    double margin() {
        return isUnfound() ? 0.0 : value - threshold;
    }

    /** Whether an observer could have found the drone, but had not yet. */
    boolean isUnfound() {
        return threshold == Double.POSITIVE_INFINITY;
    }
}
