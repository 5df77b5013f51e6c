package org.dronewatch.report.html;

/**
 * The best that a sensor measured of a drone in a run: what came nearest to its threshold, or farthest above it.
 *
 * @param time s
 * @param range m
 * @param value what it measured
 * @param threshold what it had to reach
 * @param unit of both
 */
record BestLook(double time, double range, double value, double threshold, String unit) {
    /** How far above the threshold. */
    double margin() {
        return value - threshold;
    }
}
