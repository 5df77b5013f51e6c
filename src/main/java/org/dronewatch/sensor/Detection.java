package org.dronewatch.sensor;

/**
 * An observation that reached its threshold.
 *
 * @param observation the observation
 */
public record Detection(Observation observation) {

    /**
     * Checks that the observation is a detection.
     *
     * @throws IllegalArgumentException when the value is below the threshold
     */
    public Detection {
        if (!observation.isDetected()) {
            throw new IllegalArgumentException("value " + observation.value() + " " + observation.unit()
                    + " of sensor '" + observation.sensor() + "' is below the threshold " + observation.threshold());
        }
    }

    /** Distance from the sensor to the drone's origin, m. */
    public double range() {
        return observation.range();
    }

    /** The time at which the sensor detected the drone, seconds since the start of the run. */
    public double time() {
        return observation.arrival();
    }
}
