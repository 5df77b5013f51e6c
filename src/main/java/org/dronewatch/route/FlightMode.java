package org.dronewatch.route;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.sensor.SensorSettings;

/**
 * A mode in which a drone may fly on a route.
 *
 * @param kind kind of mode
 * @param speed speed along the path, m/s
 */
public record FlightMode(Kind kind, double speed) {
    /**
     * Kinds of modes. The drone may change between modes under power at any time, and once to a glide, but not back.
     */
    public enum Kind {
        /** With its motors running, at cruise speed. */
        POWERED,
        /** With its motors running, more slowly, at a speed that a radar rejects. */
        SLOW,
        /** With its motors off, quiet and cold: it can only descend. */
        GLIDE
    }

    /**
     * All modes in which a drone can fly, in the order of their kinds; slow flight is included only if the drone can
     * hover and a sensor rejects some radial speeds below the drone's cruise speed.
     *
     * @param sensors the sensors that the drone has to pass
     */
    public static List<FlightMode> of(DroneSettings drone, Collection<SensorSettings<?>> sensors) {
        List<FlightMode> modes = new ArrayList<>();
        modes.add(new FlightMode(Kind.POWERED, drone.speed()));
        SlowFlight.speeds(drone, sensors).forEach(speed -> modes.add(new FlightMode(Kind.SLOW, speed)));
        if (drone.flightLimits().glideRatio() > 0.0) {
            modes.add(new FlightMode(Kind.GLIDE, drone.flightLimits().glideSpeed()));
        }
        return List.copyOf(modes);
    }

    /**
     * The courses on which a drone may fly in this mode.
     *
     * @param sensors settings of the sensors, by name
     * @throws IllegalArgumentException if the drone cannot fly in this mode
     */
    public List<Course> courses(Map<String, SensorSettings<?>> sensors, Drone drone) {
        return switch (kind) {
            case POWERED -> Course.all(sensors, drone);
            case SLOW -> Course.at(speed, sensors, drone);
            case GLIDE -> Course.gliding(sensors, drone);
        };
    }

    /**
     * This mode with the detection field for a drone that flies in it.
     *
     * @param field field of single looks on the courses of this mode
     * @throws IllegalArgumentException if the drone cannot fly in this mode
     */
    public ModeField with(DetectionField field, DroneSettings drone) {
        return switch (kind) {
            case POWERED -> ModeField.powered(field, drone);
            case SLOW -> ModeField.slow(field, drone, speed);
            case GLIDE -> ModeField.gliding(field, drone);
        };
    }
}
