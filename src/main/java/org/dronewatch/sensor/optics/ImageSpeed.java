package org.dronewatch.sensor.optics;

import java.util.Optional;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.Pointing;

/** The speed at which drones cross a camera's image, and the resolution lost by motion blur. */
public final class ImageSpeed {
    private ImageSpeed() {}

    /**
     * The angular rate of the line of sight to a drone relative to a camera, which a positioner may itself be turning,
     * rad/s.
     *
     * @param camera position of the camera, m
     * @param pointing pointing and rates of its positioner; empty for a fixed mount
     */
    public static double turning(Position camera, Drone drone, Optional<Pointing> pointing) {
        return turning(camera, drone.origin(), Position.of(drone.velocity()), pointing);
    }

    /**
     * The angular rate of the line of sight to a drone at a position, m, with a velocity, m/s; result and other
     * parameters as for {@link #turning(Position, Drone, Optional)}.
     */
    public static double turning(Position camera, Position drone, Position velocity, Optional<Pointing> pointing) {
        double range = drone.distance(camera);
        Direction to = Direction.of(drone.minus(camera));
        double sin = Math.sin(to.azimuth());
        double cos = Math.cos(to.azimuth());
        double level = range * Math.cos(to.elevation());
        double pan = (velocity.x() * cos - velocity.y() * sin) / Math.max(level, Double.MIN_NORMAL);
        double outwards = velocity.x() * sin + velocity.y() * cos;
        double tilt = (velocity.z() * Math.cos(to.elevation()) - outwards * Math.sin(to.elevation()))
                / Math.max(range, Double.MIN_NORMAL);
        double panLeft = pan - pointing.map(Pointing::panRate).orElse(0.0);
        double tiltLeft = tilt - pointing.map(Pointing::tiltRate).orElse(0.0);
        return Math.hypot(panLeft * Math.cos(to.elevation()), tiltLeft);
    }

    /**
     * The fraction of the line pairs resolvable across a target (across the square root of its area) that remains if
     * motion blurs one of the two dimensions of the image: {@code (1 + b^2)^(-1/4)}.
     *
     * @param blur b, 0 or more, pixels
     */
    public static double resolutionLeft(double blur) {
        return 1.0 / Math.sqrt(Math.sqrt(1.0 + blur * blur));
    }
}
