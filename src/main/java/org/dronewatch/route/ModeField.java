package org.dronewatch.route;

import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.route.search.RouteMode;

/**
 * A mode in which a drone may fly, and how it is detected while it does.
 *
 * @param mode the mode
 * @param field field of single looks, on all {@linkplain org.dronewatch.analysis.cell.Course#all courses} under power,
 *     or on those of a {@linkplain org.dronewatch.analysis.cell.Course#gliding glide}
 */
public record ModeField(RouteMode mode, DetectionField field) {
    /** Flight under power at cruise speed. */
    public static ModeField powered(DetectionField field, DroneSettings drone) {
        return new ModeField(RouteMode.powered(drone.flightLimits(), drone.speed()), field);
    }

    /**
     * A glide.
     *
     * @throws IllegalArgumentException if the drone cannot glide
     */
    public static ModeField gliding(DetectionField field, DroneSettings drone) {
        return new ModeField(RouteMode.glide(drone.flightLimits()), field);
    }
}
