package org.dronewatch.route;

import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.route.search.RouteMode;

/**
 * A mode in which a drone may fly, and how the drone is detected in that mode.
 *
 * @param mode the mode
 * @param field field of single looks, on the {@linkplain FlightMode#courses courses} of the mode
 */
public record ModeField(RouteMode mode, DetectionField field) {
    /** Flight under power at cruise speed. */
    public static ModeField powered(DetectionField field, DroneSettings drone) {
        return new ModeField(RouteMode.powered(drone.flightLimits(), drone.speed()), field);
    }

    /** Flight under power at a speed other than the cruise speed, m/s. */
    public static ModeField slow(DetectionField field, DroneSettings drone, double speed) {
        return new ModeField(RouteMode.slow(drone.flightLimits(), speed), field);
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
