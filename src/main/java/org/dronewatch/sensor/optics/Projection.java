package org.dronewatch.sensor.optics;

import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * Where the optical axis of a camera meets its image: in the middle unless the lens is shifted. A frustum of OpenGL with
 * its left, right, bottom and top edges at a distance {@code near} has the shifts {@code (left + right) / 2 / (right -
 * left)} and {@code (bottom + top) / 2 / (top - bottom)}, and a vertical field of view of {@code 2 atan((top - bottom) / 2 /
 * near)}.
 *
 * @param shiftRight how far the image is shifted to the right, so that it shows more of that side, as a fraction of its
 *     width, -5 to 5; the field of view is that of the image without a shift
 * @param shiftUp how far it is shifted upwards, as a fraction of its height, -5 to 5
 */
public record Projection(
        @In(value = Quantity.RATIO, from = -5, to = 5) double shiftRight,
        @In(value = Quantity.RATIO, from = -5, to = 5) double shiftUp) {
    /** The axis meets the middle of the image. */
    @Defaults
    public static final Projection DEFAULT = new Projection(0.0, 0.0);

    /** Checks the limits. */
    public Projection {
        Limits.check(Projection.class, shiftRight, shiftUp);
    }
}
