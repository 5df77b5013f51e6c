package org.dronewatch.report.html.run;

/**
 * The best value that a sensor measured of a drone in a run: closest to its threshold, or farthest above it.
 *
 * @param time s
 * @param range m
 * @param value measured value
 * @param threshold value required for a detection; infinite where an observer had not found the drone yet, but could
 *     have
 * @param unit of both
 */
record BestLook(double time, double range, double value, double threshold, String unit) {
    /** How far above the threshold; 0 where only time was lacking. */
    double margin() {
        return isUnfound() ? 0.0 : value - threshold;
    }

    /** Whether an observer could have found the drone, but had not yet. */
    boolean isUnfound() {
        return threshold == Double.POSITIVE_INFINITY;
    }
}
