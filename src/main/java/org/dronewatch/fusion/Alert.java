package org.dronewatch.fusion;

import java.util.List;

/**
 * A site is alerted to a contact.
 *
 * @param contact number of the contact
 * @param time when, seconds since the start of the run
 * @param sensors names of those on which it rests, the first to detect it first
 */
public record Alert(int contact, double time, List<String> sensors) {
    /** Keeps its own list. */
    public Alert {
        sensors = List.copyOf(sensors);
    }
}
