package org.dronewatch.viewer.run;

import org.dronewatch.viewer.part.Texts;

/**
 * A sensor's last measurement of a drone up to some time.
 *
 * @param time time of the measurement, seconds since the start of the run
 * @param value measured value
 * @param threshold threshold that the value must reach
 * @param unit unit of value and threshold
 * @param range distance to the drone, m
 */
public record PairReading(double time, double value, double threshold, String unit, double range) {
    /** Whether the value reaches the threshold. */
    public boolean isEnough() {
        return value >= threshold;
    }

    /** Value against threshold. */
    public String text() {
        return Texts.measured(value, unit) + " (needs " + Texts.value(threshold) + ")";
    }
}
