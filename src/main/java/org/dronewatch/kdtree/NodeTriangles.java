package org.dronewatch.kdtree;

import java.util.Arrays;

/** The triangles of a cell with the boxes of their parts inside it, as grid numbers (see {@link KDNode}). */
final class NodeTriangles {
    private static final int BOX = SahSplitFinder.BOX;

    final int[] triangles;
    final int[] boxes;
    int count;

    /** Room for a number of triangles. */
    NodeTriangles(int capacity) {
        this.triangles = new int[capacity];
        this.boxes = new int[BOX * capacity];
    }

    /** The triangles on one side of a split; those that cross it are clipped to the part's cell. */
    NodeTriangles part(Split split, boolean left, int[] voxel, TriangleClipper clipper) {
        int expected = 0;
        for (int i = 0; i < count; i++) {
            expected += isIn(i, split, left) ? 1 : 0;
        }
        NodeTriangles part = new NodeTriangles(expected);
        for (int i = 0; i < count; i++) {
            if (!isIn(i, split, left)) {
                continue;
            }
            int slot = BOX * part.count;
            if (!isIn(i, split, !left)) {
                System.arraycopy(boxes, BOX * i, part.boxes, slot, BOX);
            } else if (!clipper.clip(triangles[i], voxel, part.boxes, slot)) {
                continue;
            }
            part.triangles[part.count++] = triangles[i];
        }
        return part;
    }

    private boolean isIn(int i, Split split, boolean left) {
        int low = boxes[BOX * i + split.axis()];
        int high = boxes[BOX * i + split.axis() + 3];
        return left ? split.isLeft(low, high) : split.isRight(low, high);
    }

    /** The box around all boxes. */
    int[] bounds() {
        int[] union = Arrays.copyOf(boxes, BOX);
        for (int i = 1; i < count; i++) {
            for (int axis = 0; axis < 3; axis++) {
                union[axis] = Math.min(union[axis], boxes[BOX * i + axis]);
                union[axis + 3] = Math.max(union[axis + 3], boxes[BOX * i + axis + 3]);
            }
        }
        return union;
    }
}
