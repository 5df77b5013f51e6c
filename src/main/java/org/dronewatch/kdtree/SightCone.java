package org.dronewatch.kdtree;

import org.dronewatch.geometry.Position;

/**
 * Determines whether all lines of sight from a point to a sphere are clear of the triangles of a tree. A single descent
 * of the tree checks that no triangle comes near a pyramid that has its apex at the point and contains these lines.
 * Remembers its most recent answer. For use by one thread.
 */
public final class SightCone {
    /** Four sides, one through the point, and one behind the sphere. */
    private static final int PLANES = 6;

    private static final int NUMBERS = 4;

    /** Rounding, as a fraction of lengths. */
    private static final double SLACK = 1e-5;

    private static final double ROUNDING = 1e-12;

    /** The greatest slope of the sides: the pyramid of a near sphere would be much wider than its lines of sight. */
    private static final double STEEPEST = 1.0;

    private final KDTree tree;
    private final float[] corners;

    /** For each plane its normal, which points out of the pyramid, and its distance from the origin along it. */
    private final double[] planes = new double[NUMBERS * PLANES];

    /** The corners of the pyramid: the point, then four behind the sphere. */
    private final double[] pyramid = new double[3 * 5];

    private final Position from;
    private Position asked;
    private double askedRadius;
    private boolean answer;

    /** The lines of sight from a point, m, among the triangles of a tree. */
    public SightCone(KDTree tree, Position from) {
        this.tree = tree;
        this.from = from;
        this.corners = tree.triangles().corners();
    }

    /**
     * Whether it is certain that no triangle comes near a line of sight, up to the far side of the sphere.
     *
     * @param at the centre of the sphere, m
     * @param radius radius of the sphere, m
     * @return false if a triangle may come near, or if the point is close to the sphere
     */
    public boolean isClear(Position at, double radius) {
        if (!at.equals(asked) || radius != askedRadius) {
            answer = findOut(at, radius);
            asked = at;
            askedRadius = radius;
        }
        return answer;
    }

    private boolean findOut(Position at, double radius) {
        Position vector = at.minus(from);
        double range = vector.length();
        double square = range * range - radius * radius;
        double slope = square > 0.0 ? (1.0 + SLACK) * radius / Math.sqrt(square) + SLACK : Double.POSITIVE_INFINITY;
        if (!(slope < STEEPEST)) {
            return false;
        }
        Position ahead = vector.times(1.0 / range);
        Position top = Math.abs(ahead.z()) < 0.9 ? new Position(0, 0, 1) : new Position(0, 1, 0);
        Position aside = ahead.cross(top).unit();
        Position above = aside.cross(ahead);
        setPyramid(ahead, aside, above, slope, range + radius);
        float[] box = tree.rootBox();
        return isClear(0, box[0], box[1], box[2], box[3], box[4], box[5]);
    }

    private void setPyramid(Position ahead, Position aside, Position above, double slope, double end) {
        double depth = end * (1.0 + SLACK);
        set(0, aside.minus(ahead.times(slope)), from);
        set(1, aside.times(-1.0).minus(ahead.times(slope)), from);
        set(2, above.minus(ahead.times(slope)), from);
        set(3, above.times(-1.0).minus(ahead.times(slope)), from);
        set(4, ahead.times(-1.0), from.minus(ahead.times(SLACK)));
        Position far = from.plus(ahead.times(depth));
        set(5, ahead, far);
        setCorner(0, from);
        for (int i = 0; i < 4; i++) {
            double side = (i & 1) == 0 ? slope * depth : -slope * depth;
            double up = (i & 2) == 0 ? slope * depth : -slope * depth;
            setCorner(i + 1, far.plus(aside.times(side)).plus(above.times(up)));
        }
    }

    private void set(int plane, Position normal, Position point) {
        int i = NUMBERS * plane;
        planes[i] = normal.x();
        planes[i + 1] = normal.y();
        planes[i + 2] = normal.z();
        planes[i + 3] = normal.dot(point);
    }

    private void setCorner(int number, Position corner) {
        pyramid[3 * number] = corner.x();
        pyramid[3 * number + 1] = corner.y();
        pyramid[3 * number + 2] = corner.z();
    }

    private boolean isClear(int index, double x0, double y0, double z0, double x1, double y1, double z1) {
        if (isBeyond(x0, y0, z0, x1, y1, z1)) {
            return true;
        }
        long node = tree.nodes()[index];
        int kind = KDNode.kind(node);
        if (kind == KDNode.LEAF) {
            return isLeafClear(node);
        }
        double split = KDNode.split(node);
        int left = KDNode.leftChild(index);
        int right = KDNode.rightChild(node);
        return isClear(left, x0, y0, z0, kind == 0 ? split : x1, kind == 1 ? split : y1, kind == 2 ? split : z1)
                && isClear(right, kind == 0 ? split : x0, kind == 1 ? split : y0, kind == 2 ? split : z0, x1, y1, z1);
    }

    /** Whether a box lies beyond one of the planes. */
    private boolean isBeyond(double x0, double y0, double z0, double x1, double y1, double z1) {
        for (int i = 0; i < planes.length; i += NUMBERS) {
            double x = planes[i] > 0.0 ? x0 : x1;
            double y = planes[i + 1] > 0.0 ? y0 : y1;
            double z = planes[i + 2] > 0.0 ? z0 : z1;
            if (planes[i] * x + planes[i + 1] * y + planes[i + 2] * z > planes[i + 3] + rounding(x, y, z)) {
                return true;
            }
        }
        return false;
    }

    private boolean isLeafClear(long leaf) {
        int from = KDNode.first(leaf);
        int to = from + KDNode.count(leaf);
        for (int i = from; i < to; i++) {
            int triangle = 9 * tree.leafTriangles()[i];
            if (!isBeyond(triangle) && !isAside(triangle) && !isBesideAnEdge(triangle)) {
                return false;
            }
        }
        return true;
    }

    /** Whether a triangle lies beyond one of the planes. */
    private boolean isBeyond(int triangle) {
        for (int i = 0; i < planes.length; i += NUMBERS) {
            if (isBeyond(i, triangle) && isBeyond(i, triangle + 3) && isBeyond(i, triangle + 6)) {
                return true;
            }
        }
        return false;
    }

    /** Whether all corners of the pyramid are on one side of a triangle's plane. */
    private boolean isAside(int triangle) {
        float[] c = corners;
        double ax = c[triangle];
        double ay = c[triangle + 1];
        double az = c[triangle + 2];
        double bx = c[triangle + 3] - ax;
        double by = c[triangle + 4] - ay;
        double bz = c[triangle + 5] - az;
        double cx = c[triangle + 6] - ax;
        double cy = c[triangle + 7] - ay;
        double cz = c[triangle + 8] - az;
        double nx = by * cz - bz * cy;
        double ny = bz * cx - bx * cz;
        double nz = bx * cy - by * cx;
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < pyramid.length; i += 3) {
            double height = nx * (pyramid[i] - ax) + ny * (pyramid[i + 1] - ay) + nz * (pyramid[i + 2] - az);
            least = Math.min(least, height);
            most = Math.max(most, height);
        }
        // Above the rounding of the normal times that of the distances, which are at most the sum of the coordinates.
        double reach = Math.max(Math.abs(least), Math.abs(most));
        double slack = SLACK * Math.sqrt(nx * nx + ny * ny + nz * nz) + 1e-9 * reach;
        return least > slack || most < -slack;
    }

    /** Whether a plane through the point and an edge separates the pyramid from a triangle. */
    private boolean isBesideAnEdge(int triangle) {
        return isBeside(triangle, triangle + 3, triangle + 6)
                || isBeside(triangle + 3, triangle + 6, triangle)
                || isBeside(triangle + 6, triangle, triangle + 3);
    }

    private boolean isBeside(int start, int end, int third) {
        double ax = corners[start] - pyramid[0];
        double ay = corners[start + 1] - pyramid[1];
        double az = corners[start + 2] - pyramid[2];
        double bx = corners[end] - pyramid[0];
        double by = corners[end + 1] - pyramid[1];
        double bz = corners[end + 2] - pyramid[2];
        double nx = ay * bz - az * by;
        double ny = az * bx - ax * bz;
        double nz = ax * by - ay * bx;
        double side = nx * (corners[third] - pyramid[0])
                + ny * (corners[third + 1] - pyramid[1])
                + nz * (corners[third + 2] - pyramid[2]);
        double sign = side > 0.0 ? -1.0 : 1.0;
        double lengths = Math.sqrt((ax * ax + ay * ay + az * az) * (bx * bx + by * by + bz * bz));
        for (int i = 3; i < pyramid.length; i += 3) {
            double x = pyramid[i] - pyramid[0];
            double y = pyramid[i + 1] - pyramid[1];
            double z = pyramid[i + 2] - pyramid[2];
            double slack = ROUNDING * lengths * (Math.abs(x) + Math.abs(y) + Math.abs(z));
            if (!(sign * (nx * x + ny * y + nz * z) > slack)) {
                return false;
            }
        }
        return true;
    }

    private boolean isBeyond(int plane, int corner) {
        double x = corners[corner];
        double y = corners[corner + 1];
        double z = corners[corner + 2];
        return planes[plane] * x + planes[plane + 1] * y + planes[plane + 2] * z
                > planes[plane + 3] + rounding(x, y, z);
    }

    /** Above the rounding of a distance from a plane, m. */
    private static double rounding(double x, double y, double z) {
        return ROUNDING * (1.0 + Math.abs(x) + Math.abs(y) + Math.abs(z));
    }
}
