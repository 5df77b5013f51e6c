package org.dronewatch.sensor;

/**
 * What a sensor measured, and what that must reach.
 *
 * @param value the measured value, in the unit
 * @param threshold at and above which it is a detection, in the unit
 * @param unit of both, such as {@code dB}; empty for a ratio
 */
public record Reading(double value, double threshold, String unit) {

    /** Whether the value reaches the threshold. */
    public boolean isDetected() {
        return value >= threshold;
    }
}
