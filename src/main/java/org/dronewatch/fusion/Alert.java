package org.dronewatch.fusion;

import java.util.List;

/**
 * An alert for a contact.
 *
 * @param contact number of the contact
 * @param time time of the alert, seconds since the start of the run
 * @param sensors names of the sensors that raised it, in the order of their detections
 */
public record Alert(int contact, double time, List<String> sensors) {
    /** Copies the list: later changes by the caller have no effect. */
    public Alert {
        sensors = List.copyOf(sensors);
    }
}
