package org.dronewatch.geometry;

import org.dronewatch.setting.In;
import org.dronewatch.setting.InOrder;
import org.dronewatch.setting.Quantity;
import org.jogamp.vecmath.Point3d;
import org.jogamp.vecmath.Tuple3d;
import org.jogamp.vecmath.Vector3d;

/**
 * A point or displacement in metres; in the world frame x is east, y is north and z is up. Used in settings,
 * because vecmath's tuples are mutable. In a scene's settings each coordinate lies within 100 km of the origin;
 * computed displacements need only be finite.
 *
 * @param x east, m; -100 to 100 km in a scene file
 * @param y north, m; -100 to 100 km in a scene file
 * @param z up, m; -100 to 100 km in a scene file
 */
@InOrder
public record Position(
        @In(value = Quantity.LENGTH, from = -In.FARTHEST, to = In.FARTHEST) double x,
        @In(value = Quantity.LENGTH, from = -In.FARTHEST, to = In.FARTHEST) double y,
        @In(value = Quantity.LENGTH, from = -In.FARTHEST, to = In.FARTHEST) double z) {

    /**
     * Checks that the coordinates are finite.
     *
     * @throws IllegalArgumentException when a coordinate is not finite
     */
    public Position {
        if (!Double.isFinite(x) || !Double.isFinite(y) || !Double.isFinite(z)) {
            throw new IllegalArgumentException("position (" + x + ", " + y + ", " + z + ") must be finite");
        }
    }

    /** A position with the coordinates of a vecmath tuple, in metres. */
    public static Position of(Tuple3d tuple) {
        return new Position(tuple.x, tuple.y, tuple.z);
    }

    /** A new vecmath point at this position. */
    public Point3d toPoint3d() {
        return new Point3d(x, y, z);
    }

    /** A new vecmath vector from the origin to this position. */
    public Vector3d toVector3d() {
        return new Vector3d(x, y, z);
    }

    /** This position moved by a displacement in metres. */
    public Position plus(Position displacement) {
        return new Position(x + displacement.x, y + displacement.y, z + displacement.z);
    }

    /** The displacement from another position to this one. */
    public Position minus(Position other) {
        return new Position(x - other.x, y - other.y, z - other.z);
    }

    /** This displacement scaled by a factor. */
    public Position times(double factor) {
        return new Position(x * factor, y * factor, z * factor);
    }

    /** The scalar product with another displacement, m2. */
    public double dot(Position other) {
        return x * other.x + y * other.y + z * other.z;
    }

    /** The vector product with another displacement, m2: perpendicular to both, right-handed. */
    public Position cross(Position other) {
        return new Position(y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x);
    }

    /**
     * The direction of this displacement, as a vector of length 1.
     *
     * @throws IllegalArgumentException when this displacement has no length
     */
    public Position unit() {
        return times(1.0 / length());
    }

    /** The angle to another displacement, 0 to pi rad; neither may have length 0. */
    public double angle(Position other) {
        return Math.acos(Math.max(-1.0, Math.min(1.0, dot(other) / (length() * other.length()))));
    }

    /** The length of this displacement, m. */
    public double length() {
        return Math.sqrt(x * x + y * y + z * z);
    }

    /** The distance to another position, m. */
    public double distance(Position other) {
        return minus(other).length();
    }

    /**
     * Compares the coordinates as the method generated for a record would. Written out because positions are compared
     * often, and the JIT compiler takes long to compile the generated one.
     */
    @Override
    public boolean equals(Object other) {
        return other instanceof Position that
                && Double.compare(x, that.x) == 0
                && Double.compare(y, that.y) == 0
                && Double.compare(z, that.z) == 0;
    }

    @Override
    public int hashCode() {
        return 31 * (31 * Double.hashCode(x) + Double.hashCode(y)) + Double.hashCode(z);
    }
}
