package org.dronewatch.positioner;

import org.dronewatch.geometry.Position;

/**
 * A direction from a sensor's position.
 *
 * @param azimuth azimuth, clockwise from north, rad
 * @param elevation elevation above the horizon, rad
 */
public record Direction(double azimuth, double elevation) {

    /** The direction of a vector of any length but 0. */
    public static Direction of(Position vector) {
        return new Direction(
                Math.atan2(vector.x(), vector.y()), Math.atan2(vector.z(), Math.hypot(vector.x(), vector.y())));
    }

    /** The unit vector in this direction. */
    public Position unit() {
        double level = Math.cos(elevation);
        return new Position(level * Math.sin(azimuth), level * Math.cos(azimuth), Math.sin(elevation));
    }

    /** This direction turned clockwise as seen from above, and upwards, by the given angles, rad. */
    public Direction turned(double clockwise, double upwards) {
        return new Direction(azimuth + clockwise, elevation + upwards);
    }

    /** The smaller of the two rotations from one azimuth to another, clockwise if positive, rad. */
    static double turn(double from, double to) {
        return Math.IEEEremainder(to - from, 2.0 * Math.PI);
    }
}
