package org.dronewatch.sensor;

import java.util.Optional;
import org.dronewatch.positioner.Sighting;

/**
 * A measurement that a sensor reports from one look, without the truth: it does not identify the drone, and it may be
 * false.
 *
 * @param look the look in which it was made
 * @param reading the measured value, and its threshold
 * @param sighting the estimated position or direction of its source, with errors; empty for a sensor that reports no
 *     direction
 */
public record Measurement(LookId look, Reading reading, Optional<Sighting> sighting) {

    /** Name of the sensor. */
    public String sensor() {
        return look.sensor();
    }

    /** The time at which the sensor obtained this measurement, seconds since the start of the run. */
    public double time() {
        return look.time();
    }

    /** Whether the value reaches the threshold. A weaker measurement still serves the positioner of its own sensor. */
    public boolean isDetected() {
        return reading.isDetected();
    }
}
