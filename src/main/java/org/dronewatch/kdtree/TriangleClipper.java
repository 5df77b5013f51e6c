package org.dronewatch.kdtree;

/**
 * The box of the part of a triangle inside a voxel ("perfect splits"): a triangle that crosses a voxel's corner often
 * fills a small part of it only, and splits at the bounds of that part are better. Clips by Sutherland and Hodgman (1974)
 * in double precision and rounds outwards. One per thread.
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
     * Writes the box of a triangle inside a voxel.
     *
     * @param triangle number of the triangle
     * @param voxel the voxel's box as grid numbers
     * @param boxes where to write the six grid numbers
     * @param slot index of the first of them
     * @return false when the triangle does not reach into the voxel; nothing is written then
     */
    boolean clip(int triangle, int[] voxel, int[] boxes, int slot) {
        for (int i = 0; i < 9; i++) {
            polygon[i] = corners[9 * triangle + i];
        }
        int size = 3;
        for (int axis = 0; axis < 3 && size > 0; axis++) {
            size = clipHalfSpace(size, axis, KDNode.value(voxel[axis]), 1.0);
            size = clipHalfSpace(size, axis, KDNode.value(voxel[axis + 3]), -1.0);
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
        int kept = 0;
        for (int i = 0; i < size; i++) {
            int from = 3 * i;
            int to = 3 * ((i + 1) % size);
            double here = side * (polygon[from + axis] - plane);
            double there = side * (polygon[to + axis] - plane);
            if (here >= 0.0) {
                System.arraycopy(polygon, from, clipped, 3 * kept, 3);
                kept++;
            }
            if (here > 0.0 && there < 0.0 || here < 0.0 && there > 0.0) {
                cross(from, to, here / (here - there), 3 * kept);
                clipped[3 * kept + axis] = plane;
                kept++;
            }
        }
        double[] swap = polygon;
        polygon = clipped;
        clipped = swap;
        return kept;
    }

    private void cross(int from, int to, double fraction, int target) {
        for (int k = 0; k < 3; k++) {
            double start = polygon[from + k];
            clipped[target + k] = start + fraction * (polygon[to + k] - start);
        }
    }
}
