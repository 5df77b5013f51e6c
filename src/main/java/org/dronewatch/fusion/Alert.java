package org.dronewatch.fusion;

import java.util.List;

/**
 * An alert for a contact.
 *
 * @param contact number of the contact
 * @param time when, seconds since the start of the run
 * @param sensors names of the sensors on which it rests, in the order in which they detected it
 */
public record Alert(int contact, double time, List<String> sensors) {
    /** Copies the list: later changes by the caller have no effect. */
    public Alert {
        sensors = List.copyOf(sensors);
    }
}
