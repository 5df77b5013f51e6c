package org.dronewatch.sensor;

import java.util.Optional;
import org.dronewatch.positioner.Sighting;

/**
 * What a sensor reports of one look, without the truth: it does not say which drone was measured, or whether it was a drone at
 * all.
 *
 * @param sensor name of the sensor
 * @param kind its kind
 * @param look number of the look, from 0
 * @param time when the sensor knew, seconds since the start of the run
 * @param value the measured value, in the unit
 * @param threshold what the value must reach for a detection as a detection
 * @param unit unit of value and threshold
 * @param sighting where the sensor believes the source to be, errors and all; empty for a sensor that reports no direction
 */
public record Measurement(
        String sensor,
        String kind,
        long look,
        double time,
        double value,
        double threshold,
        String unit,
        Optional<Sighting> sighting) {

    /** Whether the value reaches the threshold. A weaker measurement still serves the mount of its own sensor. */
    public boolean isDetected() {
        return value >= threshold;
    }
}
