package org.dronewatch.fusion;

import java.util.List;

/**
 * A site is alerted to a drone.
 *
 * @param drone name of the drone
 * @param time when, seconds since the start of the run
 * @param sensors names of those on which it rests, the first to detect the drone first
 */
public record Alert(String drone, double time, List<String> sensors) {
    /** Keeps its own list. */
    public Alert {
        sensors = List.copyOf(sensors);
    }
}
