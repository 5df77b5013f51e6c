package org.dronewatch.route;

import java.util.List;
import org.dronewatch.scenario.SceneSettings;

/**
 * One sensor by itself, and how the sensor detects a drone in each mode of flight.
 *
 * @param settings settings of a scene in which this sensor is the only enabled one
 * @param modes the modes, at least one; in the same order and over the same grid for all sensors that are compared
 */
public record SensorFields(SceneSettings settings, List<ModeField> modes) {
    /**
     * Copies the list.
     *
     * @throws IllegalArgumentException unless there is at least one mode, and each has a field of one sensor
     */
    public SensorFields {
        modes = List.copyOf(modes);
        if (modes.isEmpty()
                || modes.stream().anyMatch(mode -> mode.field().sensors().size() != 1)) {
            throw new IllegalArgumentException(
                    modes.size() + " modes: there must be at least one, each with one sensor");
        }
    }

    /** The name of the sensor. */
    public String name() {
        return modes.get(0).field().sensors().get(0);
    }
}
