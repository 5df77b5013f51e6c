package org.dronewatch.geometry;

import java.util.Collection;
import org.jogamp.vecmath.Point3d;

/**
 * An axis-aligned box in metres; flat boxes are allowed, empty ones are not. Immutable.
 *
 * @param minX the smallest x of the box
 * @param minY the smallest y
 * @param minZ the smallest z
 * @param maxX the largest x, not below minX
 * @param maxY the largest y
 * @param maxZ the largest z
 */
public record AABB(double minX, double minY, double minZ, double maxX, double maxY, double maxZ) {

    /**
     * Checks the order of the bounds.
     *
     * @throws IllegalArgumentException when a bound is not a number or a minimum exceeds its maximum
     */
    public AABB {
        if (!(minX <= maxX && minY <= maxY && minZ <= maxZ)) {
            throw new IllegalArgumentException("box [" + minX + ", " + minY + ", " + minZ + "] to [" + maxX + ", "
                    + maxY + ", " + maxZ + "] must have each minimum at or below its maximum");
        }
    }

    /**
     * The smallest box around points.
     *
     * @throws IllegalArgumentException when there are none, or a coordinate is not a number
     */
    public static AABB around(Collection<Position> points) {
        if (points.isEmpty()) {
            throw new IllegalArgumentException("a box around no points");
        }
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
        for (Position point : points) {
            double[] at = {point.x(), point.y(), point.z()};
            for (int axis = 0; axis < 3; axis++) {
                low[axis] = Math.min(low[axis], at[axis]);
                high[axis] = Math.max(high[axis], at[axis]);
            }
        }
        return new AABB(low[0], low[1], low[2], high[0], high[1], high[2]);
    }

    /**
     * This box enlarged on all sides.
     *
     * @param room distance by which each face moves outwards, m
     */
    public AABB grown(double room) {
        return new AABB(minX - room, minY - room, minZ - room, maxX + room, maxY + room, maxZ + room);
    }

    /** The smallest box around this one and another. */
    public AABB union(AABB other) {
        return new AABB(
                Math.min(minX, other.minX),
                Math.min(minY, other.minY),
                Math.min(minZ, other.minZ),
                Math.max(maxX, other.maxX),
                Math.max(maxY, other.maxY),
                Math.max(maxZ, other.maxZ));
    }

    /** Whether a point lies in the box or on its border. */
    public boolean contains(Point3d point) {
        return point.x >= minX
                && point.x <= maxX
                && point.y >= minY
                && point.y <= maxY
                && point.z >= minZ
                && point.z <= maxZ;
    }

    /**
     * The eight corners, as a camera projects them: bit 0 of the index chooses the x bound (0 the minimum), bit 1 the y
     * bound and bit 2 the z bound.
     */
    public Point3d[] corners() {
        Point3d[] corners = new Point3d[8];
        for (int i = 0; i < corners.length; i++) {
            corners[i] =
                    new Point3d((i & 1) == 0 ? minX : maxX, (i & 2) == 0 ? minY : maxY, (i & 4) == 0 ? minZ : maxZ);
        }
        return corners;
    }

    /** The centre of the box. */
    public Point3d center() {
        return new Point3d(0.5 * (minX + maxX), 0.5 * (minY + maxY), 0.5 * (minZ + maxZ));
    }

    /** Length of the box's space diagonal, m: the size of a mesh, as this project defines it. */
    public double diagonal() {
        double x = maxX - minX;
        double y = maxY - minY;
        double z = maxZ - minZ;
        return Math.sqrt(x * x + y * y + z * z);
    }

    /** Area of the six faces together, m². */
    public double surfaceArea() {
        double x = maxX - minX;
        double y = maxY - minY;
        double z = maxZ - minZ;
        return 2.0 * (x * y + y * z + z * x);
    }
}
