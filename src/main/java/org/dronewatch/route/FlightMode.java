package org.dronewatch.route;

import java.util.List;
import java.util.Map;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.sensor.SensorSettings;

/**
 * A mode in which a drone may fly on a route. The drone may change modes only in the order in which they are listed.
 */
public enum FlightMode {
    /** With its motors running, at cruise speed. */
    POWERED,
    /** With its motors off, quiet and cold: it can only descend. */
    GLIDE;

    /** All modes in which a drone can fly. */
    public static List<FlightMode> of(DroneSettings drone) {
        return drone.flightLimits().glideRatio() > 0.0 ? List.of(POWERED, GLIDE) : List.of(POWERED);
    }

    /**
     * The courses on which a drone may fly in this mode.
     *
     * @param sensors by name
     * @throws IllegalArgumentException if the drone cannot fly in this mode
     */
    public List<Course> courses(Map<String, SensorSettings<?>> sensors, Drone drone) {
        return this == POWERED ? Course.all(sensors, drone) : Course.gliding(sensors, drone);
    }

    /**
     * This mode with the detection field for a drone that flies in it.
     *
     * @param field field of single looks on the courses of this mode
     * @throws IllegalArgumentException if the drone cannot fly in this mode
     */
    public ModeField with(DetectionField field, DroneSettings drone) {
        return this == POWERED ? ModeField.powered(field, drone) : ModeField.gliding(field, drone);
    }
}
