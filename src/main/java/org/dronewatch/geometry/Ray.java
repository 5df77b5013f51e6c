package org.dronewatch.geometry;

import org.jogamp.vecmath.Point3d;
import org.jogamp.vecmath.Tuple3d;
import org.jogamp.vecmath.Vector3d;

/**
 * A half line, or a segment of it: all points {@code origin + t * direction} with {@code tMin <= t <= tMax}. The
 * direction need not be of unit length; t is a distance in metres only if it is. Immutable.
 */
public final class Ray {
    private final double ox;
    private final double oy;
    private final double oz;
    private final double dx;
    private final double dy;
    private final double dz;
    private final double tMin;
    private final double tMax;

    /** A ray from an origin, without end. See {@link #Ray(Tuple3d, Tuple3d, double, double)}. */
    public Ray(Tuple3d origin, Tuple3d direction) {
        this(origin, direction, 0.0, Double.POSITIVE_INFINITY);
    }

    /** A ray from an origin, without end. See {@link #Ray(Tuple3d, Tuple3d, double, double)}. */
    public Ray(Position origin, Position direction) {
        this(origin.toPoint3d(), direction.toVector3d());
    }

    /**
     * A ray with limits.
     *
     * @param origin where t is 0, m
     * @param direction any finite vector but zero
     * @param tMin the smallest t of the ray, 0 or more
     * @param tMax the largest t, not below tMin; infinity for no end
     * @throws IllegalArgumentException if a value is out of range
     */
    public Ray(Tuple3d origin, Tuple3d direction, double tMin, double tMax) {
        if (!(Double.isFinite(origin.x) && Double.isFinite(origin.y) && Double.isFinite(origin.z))) {
            throw new IllegalArgumentException("ray origin " + origin + " must be finite");
        }
        double squaredLength = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
        if (!(squaredLength > 0.0 && squaredLength < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("ray direction " + direction + " must be finite and not zero");
        }
        if (!(tMin >= 0.0 && tMin <= tMax)) {
            throw new IllegalArgumentException("ray range [" + tMin + ", " + tMax + "] must have 0 <= tMin <= tMax");
        }
        this.ox = origin.x;
        this.oy = origin.y;
        this.oz = origin.z;
        this.dx = direction.x;
        this.dy = direction.y;
        this.dz = direction.z;
        this.tMin = tMin;
        this.tMax = tMax;
    }

    /** The ray from one point towards another, of unit direction, that ends at the second point. */
    public static Ray between(Point3d from, Point3d to) {
        Vector3d direction = new Vector3d(to);
        direction.sub(from);
        double length = direction.length();
        direction.scale(1.0 / length);
        return new Ray(from, direction, 0.0, length);
    }

    /** A copy of the origin, m. */
    public Point3d origin() {
        return new Point3d(ox, oy, oz);
    }

    /** A copy of the given direction, not normalised. */
    public Vector3d direction() {
        return new Vector3d(dx, dy, dz);
    }

    /** The reciprocal of each component of the direction; a zero of either sign gives plus infinity. */
    public Vector3d inverseDirection() {
        return new Vector3d(inverse(dx), inverse(dy), inverse(dz));
    }

    /**
     * The reciprocal of a direction's component; a zero of either sign counts as positive, since its sign has no
     * meaning for a ray.
     */
    public static double inverse(double component) {
        return 1.0 / (component + 0.0);
    }

    /** The smallest ray parameter of this ray. */
    public double tMin() {
        return tMin;
    }

    /** The largest ray parameter of this ray; infinity if it has no end. */
    public double tMax() {
        return tMax;
    }

    /** The point at a ray parameter, m. */
    public Point3d pointAt(double t) {
        return new Point3d(ox + t * dx, oy + t * dy, oz + t * dz);
    }

    @Override
    public String toString() {
        return "Ray[origin=" + origin() + ", direction=" + direction() + ", t=" + tMin + ".." + tMax + "]";
    }
}
