package org.dronewatch.sensor;

/**
 * A measured value with its threshold.
 *
 * @param value the measured value, in {@code unit}
 * @param threshold the least value that counts as a detection, in {@code unit}
 * @param unit the unit of the value and the threshold, such as {@code dB}; empty for a ratio
 */
public record Reading(double value, double threshold, String unit) {

    /** Whether the value reaches the threshold. */
    public boolean isDetected() {
        return value >= threshold;
    }
}
