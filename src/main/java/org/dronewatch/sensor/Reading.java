package org.dronewatch.sensor;

/**
 * A measured value with its threshold.
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
