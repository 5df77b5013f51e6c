package org.dronewatch.tracking;

import java.util.List;
import org.dronewatch.sensor.Measurement;

/**
 * One look of a sensor at a contact, with its measurements, if any. Positioners, alerts and fusion receive these; the
 * truth cannot be reached from them.
 *
 * @param contact number of the contact
 * @param sensor name of the sensor
 * @param time time of reception at the sensor, seconds since the start of the run
 * @param probability how likely the look was to detect the contact, 0 to 1; 0 or 1 (whether it detected it) for a
 *     sensor that does not estimate a probability
 * @param measurements of the contact: none, one or several
 * @param isLoose whether the contact belongs to this sensor alone, since it is not associated with the contacts of
 *     other sensors: what another sensor measures of the same object is a different contact
 */
public record ContactLook(
        int contact, String sensor, double time, double probability, List<Measurement> measurements, boolean isLoose) {
    /** Copies the list: later changes by the caller have no effect. */
    public ContactLook {
        measurements = List.copyOf(measurements);
    }

    /** Whether any of the measurements is a detection. */
    public boolean isDetected() {
        return measurements.stream().anyMatch(Measurement::isDetected);
    }
}
