package org.dronewatch.sensor.optics;

import org.dronewatch.geometry.Position;

/**
 * The axes of a camera in the world, unit vectors: its line of sight, and the directions to the right and up in its
 * image. Immutable.
 */
public final class CameraAxes {
    /** Beyond this fraction of the vertical the camera counts as looking straight up or down. */
    private static final double VERTICAL = 1.0 - 1e-12;

    /** A roll this near to a quarter turn counts as one, rad: then images are rotated without rounding. */
    private static final double QUARTER = 1e-12;

    final Position forward;
    final Position right;
    final Position up;
    private final double cos;
    private final double sin;

    /** The directions to the right and up if the horizon is level. */
    private final Position levelRight;

    private final Position levelUp;

    /**
     * The axes of a camera.
     *
     * @param direction line of sight of the camera, of any non-zero length
     * @param roll rotation about that direction from a level horizon, its right side down, rad
     */
    CameraAxes(Position direction, double roll) {
        double quarters = Math.rint(roll / (0.5 * Math.PI));
        boolean exact = Math.abs(roll - quarters * 0.5 * Math.PI) < QUARTER;
        cos = exact ? Math.rint(Math.cos(roll)) : Math.cos(roll);
        sin = exact ? Math.rint(Math.sin(roll)) : Math.sin(roll);
        forward = direction.unit();
        levelRight = forward.cross(top(forward)).unit();
        levelUp = levelRight.cross(forward);
        right = isLevel() ? levelRight : levelRight.times(cos).minus(levelUp.times(sin));
        up = isLevel() ? levelUp : levelUp.times(cos).plus(levelRight.times(sin));
    }

    private boolean isLevel() {
        return sin == 0.0 && cos == 1.0;
    }

    /**
     * The direction at the top of the image of a level camera: upwards, or north if the camera looks straight up or
     * down.
     */
    private static Position top(Position forward) {
        return Math.abs(forward.z()) < VERTICAL ? new Position(0, 0, 1) : new Position(0, 1, 0);
    }

    /** A vector whose part across the axis points to the top of the image. */
    Position top() {
        return isLevel() ? top(forward) : up;
    }

    /**
     * Writes the unit direction of a point of the image.
     *
     * @param across distance of the point to the right of the axis, divided by the focal length
     * @param above distance of the point above the axis, divided by the focal length
     */
    void direction(double across, double above, double[] target) {
        // Computed from the point that has this direction in the image of a level camera, so that a quarter turn gives
        // the same directions bit for bit.
        double x = across * cos + above * sin;
        double y = above * cos - across * sin;
        double scale = 1.0 / Math.sqrt(1.0 + x * x + y * y);
        target[0] = scale * (forward.x() + x * levelRight.x() + y * levelUp.x());
        target[1] = scale * (forward.y() + x * levelRight.y() + y * levelUp.y());
        target[2] = scale * (forward.z() + x * levelRight.z() + y * levelUp.z());
    }

    /**
     * The roll at which a vector points to the top of a camera's image.
     *
     * @param direction line of sight of the camera, of any non-zero length
     * @param up the vector, not along that direction
     * @return rad, -pi to pi
     * @throws IllegalArgumentException when the two vectors are parallel, or one of them is 0
     */
    public static double roll(Position direction, Position up) {
        CameraAxes level = new CameraAxes(direction, 0.0);
        double aside = up.dot(level.right);
        double above = up.dot(level.up);
        if (!(Math.hypot(aside, above) > QUARTER * up.length())) {
            throw new IllegalArgumentException("up " + up + " must not point along the axis of the camera");
        }
        return Math.atan2(aside, above);
    }
}
