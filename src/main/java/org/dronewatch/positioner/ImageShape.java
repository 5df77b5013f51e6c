package org.dronewatch.positioner;

/**
 * The proportions of a camera's image: the tangent of half its horizontal field of view, and that of half its vertical
 * one, each divided by the tangent of half the field of view that the camera's settings state.
 *
 * @param width ratio for the horizontal field of view
 * @param height ratio for the vertical field of view
 */
public record ImageShape(double width, double height) {
    /** The shape of an image that is as wide as it is high. */
    static final ImageShape SQUARE = new ImageShape(1.0, 1.0);

    /** The horizontal field of view, rad, when the stated field of view is {@code fov}. */
    double across(double fov) {
        return 2.0 * Math.atan(width * Math.tan(0.5 * fov));
    }

    /** The vertical field of view, rad. */
    double upwards(double fov) {
        return 2.0 * Math.atan(height * Math.tan(0.5 * fov));
    }

    /** The stated field of view at which the smaller of the two equals an angle of less than pi, rad. */
    double fitting(double angle) {
        return 2.0 * Math.atan(Math.tan(0.5 * angle) / Math.min(width, height));
    }
}
