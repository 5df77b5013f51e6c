package org.dronewatch.flight;

import org.dronewatch.geometry.Position;

/**
 * The orientation of a drone in the world, whose x points east, y north and z up. A model's nose points along its y
 * axis, and its right side along x. The angles are applied in the order of the components: first the yaw about the
 * vertical, then the pitch about the drone's own right axis, then the roll about its nose. The matrix from the model to
 * the world, with the right-handed rotations of vecmath, is {@code rotZ(-yaw) rotX(pitch) rotY(roll)}. With all angles
 * zero, the drone is level with its nose to the north.
 *
 * @param yaw heading of the nose, clockwise from north as seen from above, rad, any finite angle
 * @param pitch angle of the nose above the horizontal, rad, any finite angle
 * @param roll angle of the right side below the horizontal in level flight, rad, any finite angle
 */
public record Attitude(double yaw, double pitch, double roll) {
    /** Level, with the nose to the north. */
    public static final Attitude NORTH = new Attitude(0.0, 0.0, 0.0);

    /**
     * Checks that the angles are finite.
     *
     * @throws IllegalArgumentException when one of them is not
     */
    public Attitude {
        checkFinite("yaw", yaw);
        checkFinite("pitch", pitch);
        checkFinite("roll", roll);
    }

    private static void checkFinite(String name, double angle) {
        if (!Double.isFinite(angle)) {
            throw new IllegalArgumentException(name + " " + angle + " must be a finite angle in rad");
        }
    }

    /** Level, with the nose at a compass heading, rad. */
    public static Attitude level(double yaw) {
        return new Attitude(yaw, 0.0, 0.0);
    }

    /** Whether pitch and roll are zero. */
    public boolean isLevel() {
        return pitch == 0.0 && roll == 0.0;
    }

    /**
     * Transforms a displacement from the drone's frame (to its right, along its nose, upwards) to the world; its length
     * is unchanged.
     */
    public Position toWorld(Position displacement) {
        double x = displacement.x() * Math.cos(roll) + displacement.z() * Math.sin(roll);
        double z = displacement.z() * Math.cos(roll) - displacement.x() * Math.sin(roll);
        double y = displacement.y() * Math.cos(pitch) - z * Math.sin(pitch);
        double up = displacement.y() * Math.sin(pitch) + z * Math.cos(pitch);
        return new Position(x * Math.cos(yaw) + y * Math.sin(yaw), y * Math.cos(yaw) - x * Math.sin(yaw), up);
    }

    /**
     * Transforms a displacement from the world to the drone's frame (to its right, along its nose, upwards): the
     * inverse of {@link #toWorld}.
     */
    public Position toDrone(Position displacement) {
        double right = displacement.x() * Math.cos(yaw) - displacement.y() * Math.sin(yaw);
        double ahead = displacement.x() * Math.sin(yaw) + displacement.y() * Math.cos(yaw);
        double y = ahead * Math.cos(pitch) + displacement.z() * Math.sin(pitch);
        double above = displacement.z() * Math.cos(pitch) - ahead * Math.sin(pitch);
        return new Position(
                right * Math.cos(roll) - above * Math.sin(roll), y, right * Math.sin(roll) + above * Math.cos(roll));
    }
}
