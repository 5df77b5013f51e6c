package org.dronewatch.tracking;

import java.util.List;
import org.dronewatch.sensor.Measurement;

/**
 * One look of a sensor at a contact, with its measurements, if any. Positioners and alert rules receive these; the
 * truth cannot be reached from them, and a look at a false contact carries the same information as a look at a drone.
 * Contacts in one look are not in random order: code that chooses among them must not depend on their order or their
 * numbers.
 *
 * @param contact number of the contact
 * @param sensor name of the sensor
 * @param time time of reception at the sensor, seconds since the start of the run
 * @param measurements measurements of the contact: none, one or several
 */
public record ContactLook(int contact, String sensor, double time, List<Measurement> measurements) {
    /** Copies the list: later changes by the caller have no effect. */
    public ContactLook {
        measurements = List.copyOf(measurements);
    }

    /** Whether any of the measurements is a detection. */
    public boolean isDetected() {
        return measurements.stream().anyMatch(Measurement::isDetected);
    }
}
