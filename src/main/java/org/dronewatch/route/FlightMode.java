package org.dronewatch.route;

import java.util.List;
import java.util.Map;
import org.dronewatch.analysis.field.Course;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.sensor.SensorSettings;

/** A mode in which a drone may fly on a route. The modes are in the order in which it may change. */
public enum FlightMode {
    /** With its motors running, at cruise speed. */
    POWERED,
    /** With its motors off: it only sinks, quiet and cold. */
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
     * This mode with the field by which the drone is detected in it.
     *
     * @param field of single looks on its courses
     * @throws IllegalArgumentException if the drone cannot fly in this mode
     */
    public ModeField with(DetectionField field, DroneSettings drone) {
        return this == POWERED ? ModeField.powered(field, drone) : ModeField.gliding(field, drone);
    }
}
