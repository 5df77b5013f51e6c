package org.dronewatch.report.html;

/**
 * The best value that a sensor measured of a drone in a run: closest to its threshold, or farthest above it.
 *
 * @param time s
 * @param range m
 * @param value measured value
 * @param threshold value required for a detection
 * @param unit of both
 */
record BestLook(double time, double range, double value, double threshold, String unit) {
    /** How far above the threshold. */
    double margin() {
        return value - threshold;
    }
}
