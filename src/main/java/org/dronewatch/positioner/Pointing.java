package org.dronewatch.positioner;

import java.util.OptionalInt;

/**
 * The pointing of a positioner at one time: direction, rates and field of view.
 *
 * @param direction direction of the sensor's axis
 * @param panRate mean pan rate since the previous pointing, clockwise, rad/s
 * @param tiltRate mean tilt rate since the previous pointing, upwards, rad/s
 * @param fov the sensor's field of view at that time, measured as in its settings (for cameras, along the axis {@code
 *     fovAxis} of the image), rad
 * @param contact number of the contact that the positioner follows; empty while it searches
 */
public record Pointing(Direction direction, double panRate, double tiltRate, double fov, OptionalInt contact) {

    /**
     * The pointing of a positioner that does not move.
     *
     * @param fov field of view, rad
     * @param contact number of the contact that the positioner follows; empty while it searches
     */
    public static Pointing still(Direction direction, double fov, OptionalInt contact) {
        return new Pointing(direction, 0.0, 0.0, fov, contact);
    }
}
