package org.dronewatch.models;

/**
 * A position or direction in a model's own frame: metres, y up, right-handed, as is usual in OBJ files.
 *
 * @param x metres to the right (east)
 * @param y metres up
 * @param z metres backward (south)
 */
public record Point(double x, double y, double z) {

    /** Sum of two vectors. */
    public Point plus(Point other) {
        return new Point(x + other.x, y + other.y, z + other.z);
    }

    /** Vector that leads from {@code other} to this point. */
    public Point minus(Point other) {
        return new Point(x - other.x, y - other.y, z - other.z);
    }

    /** Vector scaled by a factor. */
    public Point times(double factor) {
        return new Point(x * factor, y * factor, z * factor);
    }

    /** Scalar product. */
    public double dot(Point other) {
        return x * other.x + y * other.y + z * other.z;
    }

    /** Right-handed vector product. */
    public Point cross(Point other) {
        return new Point(y * other.z - z * other.y, z * other.x - x * other.z, x * other.y - y * other.x);
    }

    /** Euclidean length. */
    public double length() {
        return Math.sqrt(dot(this));
    }

    /**
     * Vector of length one in the same direction.
     *
     * @throws ArithmeticException if the length is zero
     */
    public Point unit() {
        double length = length();
        if (length == 0) {
            throw new ArithmeticException("the zero vector has no direction");
        }
        return times(1 / length);
    }

    /** Point on the segment to {@code other}: this point at 0, the other one at 1. */
    public Point towards(Point other, double fraction) {
        return plus(other.minus(this).times(fraction));
    }

    /** Some unit vector at right angles to this one, always the same for the same direction. */
    Point perpendicular() {
        Point helper = Math.abs(y) < 0.9 * length() ? new Point(0, 1, 0) : new Point(1, 0, 0);
        return cross(helper).unit();
    }
}
