package org.dronewatch.sensor.optics;

import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Minor;
import org.dronewatch.setting.Quantity;

/**
 * The projection of a camera: the position of the optical axis in the image, and the near and far planes. An OpenGL
 * frustum with left, right, bottom and top edges at the distance {@code near} has the shifts
 * {@code (left + right) / 2 / (right - left)} and {@code (bottom + top) / 2 / (top - bottom)}, and a vertical field of
 * view of {@code 2 atan((top - bottom) / 2 / near)}.
 *
 * @param shiftRight shift of the image to the right, so that the image shows more of that side, as a fraction of its
 *     width, -5 to 5; the field of view is that of the image without a shift
 * @param shiftUp shift upwards, as a fraction of its height, -5 to 5
 * @param near distance of the near plane along the axis, within which nothing is seen, 0 or more and less than far, m
 * @param far distance of the far plane along the axis, beyond which nothing is seen, above near and at most
 *     1,000,000 m; the default, 1,000,000 m, means no limit
 */
public record Projection(
        @Minor @In(value = Quantity.RATIO, from = -5, to = 5) double shiftRight,
        @Minor @In(value = Quantity.RATIO, from = -5, to = 5) double shiftUp,
        @Minor @In(value = Quantity.LENGTH, from = 0, to = In.FARTHEST) double near,
        @Minor @In(value = Quantity.LENGTH, above = 0, to = UNLIMITED) double far) {
    /** A far plane at this distance or beyond means no limit, m. */
    private static final double UNLIMITED = 1e6;

    /** The axis at the centre of the image, and all distances visible. */
    @Defaults
    public static final Projection DEFAULT = new Projection(0.0, 0.0, 0.0, UNLIMITED);

    /** Checks the limits, and that the near plane is nearer than the far one. */
    public Projection {
        Limits.check(Projection.class, shiftRight, shiftUp, near, far);
        if (near >= far) {
            throw new IllegalArgumentException(
                    "near " + (float) near + " m must be less than far " + (float) far + " m");
        }
    }

    /**
     * The projection of a shifted lens, with all distances visible.
     *
     * @param right shift to the right, as a fraction of the width of the image
     * @param up shift upwards, as a fraction of its height
     */
    public static Projection shifted(double right, double up) {
        return new Projection(right, up, 0.0, UNLIMITED);
    }

    /** The distance of the far plane, m; infinity for none. */
    double limit() {
        return far < UNLIMITED ? far : Double.POSITIVE_INFINITY;
    }
}
