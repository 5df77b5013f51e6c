package org.dronewatch.geometry;

/**
 * The segment in which a plane intersects a triangle. A plane through corners is treated as if it lay an infinitesimal
 * distance to one side of them, so that it intersects each triangle in one segment or not at all, and the segments of
 * triangles that share an edge share an end there, to the last bit. For use by one thread.
 */
public final class CutTriangle {
    /** The least and the greatest distance within which ends of segments touch, m. */
    private static final double LEAST_TOUCHING = 1e-6;

    private static final double MOST_TOUCHING = 1e-4;

    /** The relative rounding error of coordinates, which have single precision. */
    private static final double ROUNDING = 3e-8;

    private final Corners corners;
    private final double tolerance;
    private final double[][] corner = new double[3][3];
    private final double[] height = new double[3];
    private final double[] first = new double[3];
    private final double[] second = new double[3];

    /** The corners of triangles. */
    @FunctionalInterface
    public interface Corners {
        /**
         * One coordinate of a corner, m.
         *
         * @param triangle index of the triangle
         * @param corner 0 to 2
         * @param axis 0 to 2 for x, y and z
         */
        float coordinate(int triangle, int corner, int axis);
    }

    /**
     * A cutter of triangles.
     *
     * @param corners corners of the triangles that are cut
     * @param tolerance distance from the plane below which corners count as lying on it, m
     */
    public CutTriangle(Corners corners, double tolerance) {
        this.corners = corners;
        this.tolerance = tolerance;
    }

    /**
     * The distance within which the ends of two segments touch, m: where a corner of one triangle lies on an edge of
     * another, rounding separates them. In proportion to the largest coordinate, but 0.001 mm to 0.1 mm.
     */
    public static double touching(TriangleMesh mesh) {
        return Math.max(LEAST_TOUCHING, Math.min(MOST_TOUCHING, ROUNDING * mesh.greatestCoordinate()));
    }

    /**
     * Cuts a triangle.
     *
     * @param triangle index of the triangle
     * @param origin a point of the plane, m
     * @param normal unit normal of the plane
     * @return whether the plane cuts the triangle
     */
    public boolean cut(int triangle, Position origin, Position normal) {
        int above = 0;
        for (int k = 0; k < 3; k++) {
            double[] c = corner[k];
            c[0] = corners.coordinate(triangle, k, 0) - origin.x();
            c[1] = corners.coordinate(triangle, k, 1) - origin.y();
            c[2] = corners.coordinate(triangle, k, 2) - origin.z();
            double over = c[0] * normal.x() + c[1] * normal.y() + c[2] * normal.z();
            height[k] = Math.abs(over) < tolerance ? 0.0 : over;
            above += height[k] >= 0.0 ? 1 : 0;
        }
        if (above == 0 || above == 3) {
            return false;
        }
        int alone = 0;
        while (height[alone] >= 0.0 != (above == 1)) {
            alone++;
        }
        cross(alone, (alone + 1) % 3, first);
        cross(alone, (alone + 2) % 3, second);
        return true;
    }

    /**
     * One end of the segment found by the most recent cut, relative to the plane's origin, m; valid until the next cut.
     */
    public double[] first() {
        return first;
    }

    /** The other end of the segment found by the most recent cut, in the same form as {@link #first()}. */
    public double[] second() {
        return second;
    }

    /**
     * The point at which the plane cuts a side, the same from either end and for both triangles that share the side.
     */
    private void cross(int one, int other, double[] at) {
        boolean swap = isAfter(corner[one], corner[other]);
        double[] from = corner[swap ? other : one];
        double[] to = corner[swap ? one : other];
        double ofFrom = height[swap ? other : one];
        double ofTo = height[swap ? one : other];
        double fraction = ofFrom / (ofFrom - ofTo);
        for (int axis = 0; axis < 3; axis++) {
            // Exact at both ends, so that all sides that end in a corner on the plane are cut in one point.
            at[axis] = ofTo == 0.0 ? to[axis] : from[axis] + fraction * (to[axis] - from[axis]);
        }
    }

    /**
     * Whether point p comes after point q in the lexicographic order of their coordinates. In this order, a side is
     * followed in the same direction in every triangle to which it belongs.
     *
     * @param p three coordinates
     * @param q three coordinates
     */
    public static boolean isAfter(double[] p, double[] q) {
        return p[0] != q[0] ? p[0] > q[0] : p[1] != q[1] ? p[1] > q[1] : p[2] > q[2];
    }
}
