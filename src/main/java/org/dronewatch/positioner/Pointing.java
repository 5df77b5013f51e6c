package org.dronewatch.positioner;

import java.util.OptionalInt;

/**
 * Where a mount that turns points at one moment.
 *
 * @param direction of the sensor's axis
 * @param panRate how fast it turned to there, clockwise, rad/s
 * @param tiltRate how fast it tilted to there, upwards, rad/s
 * @param fov the sensor's field of view now, rad
 * @param contact number of the contact that it follows; empty while it searches
 */
public record Pointing(Direction direction, double panRate, double tiltRate, double fov, OptionalInt contact) {

    /** Where a mount that does not move points. */
    public static Pointing still(Direction direction, double fov, OptionalInt contact) {
        return new Pointing(direction, 0.0, 0.0, fov, contact);
    }
}
