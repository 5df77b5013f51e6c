package org.dronewatch.sensor;

/**
 * A measured value with its threshold.
 *
 * @param value the measured value, in the unit
 * @param threshold the least value that counts as a detection, in the unit
 * @param unit the unit of value and threshold, such as {@code dB}; empty for a ratio
 */
public record Reading(double value, double threshold, String unit) {

    /** Whether the value reaches the threshold. */
    public boolean isDetected() {
        return value >= threshold;
    }
}
