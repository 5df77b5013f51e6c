package org.dronewatch.kdtree;

/**
 * The box of the part of a triangle inside a cell ("perfect splits"): a triangle that crosses a cell's corner often
 * fills only a small part of it, and splits at the bounds of that part are better. Clips by Sutherland and Hodgman
 * (1974) in double precision and rounds outwards. For use by one thread.
 */
final class TriangleClipper {
    /** A triangle cut by six planes has at most nine corners. */
    private static final int MAX_CORNERS = 9;

    private final float[] corners;
    private double[] polygon = new double[3 * (MAX_CORNERS + 1)];
    private double[] clipped = new double[3 * (MAX_CORNERS + 1)];

    /** A clipper of triangles given by nine coordinates each. */
    TriangleClipper(float[] corners) {
        this.corners = corners;
    }

    /**
     * Writes the box of a triangle inside a cell.
     *
     * @param triangle number of the triangle
     * @param voxel the cell's box as grid numbers
     * @param boxes where to write the six grid numbers
     * @param slot index of the first of them
     * @return false when the triangle does not reach into the cell; nothing is written then
     */
    boolean clip(int triangle, int[] voxel, int[] boxes, int slot) {
        for (int i = 0; i < 9; i++) {
            polygon[i] = corners[9 * triangle + i];
        }
        int size = 3;
        for (int axis = 0; axis < 3 && size > 0; axis++) {
            double a = corners[9 * triangle + axis];
            double b = corners[9 * triangle + 3 + axis];
            double c = corners[9 * triangle + 6 + axis];
            double low = KDNode.value(voxel[axis]);
            double high = KDNode.value(voxel[axis + 3]);
            if (a < low || b < low || c < low) {
                size = clipHalfSpace(size, axis, low, 1.0);
            }
            if (size > 0 && (a > high || b > high || c > high)) {
                size = clipHalfSpace(size, axis, high, -1.0);
            }
        }
        if (size == 0) {
            return false;
        }
        for (int axis = 0; axis < 3; axis++) {
            double low = Double.POSITIVE_INFINITY;
            double high = Double.NEGATIVE_INFINITY;
            for (int i = 0; i < size; i++) {
                low = Math.min(low, polygon[3 * i + axis]);
                high = Math.max(high, polygon[3 * i + axis]);
            }
            boxes[slot + axis] = Math.max(KDNode.floorKey(low), voxel[axis]);
            boxes[slot + axis + 3] = Math.min(KDNode.ceilKey(high), voxel[axis + 3]);
        }
        return true;
    }

    /** Keeps what lies at or beyond a plane: above it for side 1, below it for side -1. */
    private int clipHalfSpace(int size, int axis, double plane, double side) {
        double[] from = polygon;
        double[] to = clipped;
        int kept = 0;
        int previous = 3 * (size - 1);
        double before = side * (from[previous + axis] - plane);
        for (int i = 0; i < 3 * size; i += 3) {
            double here = side * (from[i + axis] - plane);
            if (before > 0.0 && here < 0.0 || before < 0.0 && here > 0.0) {
                double fraction = before / (before - here);
                for (int k = 0; k < 3; k++) {
                    to[kept + k] = from[previous + k] + fraction * (from[i + k] - from[previous + k]);
                }
                to[kept + axis] = plane;
                kept += 3;
            }
            if (here >= 0.0) {
                to[kept] = from[i];
                to[kept + 1] = from[i + 1];
                to[kept + 2] = from[i + 2];
                kept += 3;
            }
            previous = i;
            before = here;
        }
        polygon = to;
        clipped = from;
        return kept / 3;
    }
}
