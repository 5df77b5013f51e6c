package org.dronewatch.bvh;

import java.util.Arrays;
import java.util.concurrent.CancellationException;
import org.dronewatch.kdtree.LeafOrderTriangles;
import org.dronewatch.parallel.Workers;

/**
 * Builds a {@link Bvh}: first a binary tree of boxes, then nodes of eight children, by repeatedly opening the largest
 * child. The centres of a box's triangles are sorted into bins, and the box is split at the border between bins that is
 * cheapest by the surface area heuristic (Wald, "On fast construction of SAH-based bounding volume hierarchies", 2007).
 * The tree is the same for any number of threads.
 */
final class BvhBuilder {
    private static final int BOX = 6;
    private static final int BINS = 32;

    /** Cost of a box's test over that of a block's: measured. */
    private static final float STEP = 0.5f;

    /** Maximum number of triangles of a leaf, where splitting does not pay. */
    private static final int MAX_IN_LEAF = 8;

    /** Below this level, parts are halved by number, which bounds the cost of degenerate input. */
    private static final int DEEPEST = 60;

    /** Parts of fewer triangles are not worth another thread. */
    private static final int WORTH_A_THREAD = 4096;

    private final LeafOrderTriangles triangles;
    private final float[] corners;
    private final int count;
    private final float[] boxes;
    /** Indices of triangles in leaf order, part by part. */
    private final int[] order;

    /**
     * A builder.
     *
     * @param triangles of a kd-tree, in leaf order: neighbours are stored together
     */
    BvhBuilder(LeafOrderTriangles triangles) {
        this.triangles = triangles;
        this.corners = triangles.corners();
        this.count = triangles.count();
        this.boxes = new float[BOX * count];
        this.order = new int[count];
    }

    Bvh build() {
        double reach = 0.0;
        for (int i = 0; i < count; i++) {
            order[i] = i;
            writeBox(i);
            for (int k = 0; k < BOX; k++) {
                reach = Math.max(reach, Math.abs(boxes[BOX * i + k]));
            }
        }
        BvhPart root = part(0, count);
        split(root, 0);
        return new BvhWriter(triangles, order).write(root, reach);
    }

    private void writeBox(int index) {
        for (int axis = 0; axis < 3; axis++) {
            float a = corners[9 * index + axis];
            float b = corners[9 * index + 3 + axis];
            float c = corners[9 * index + 6 + axis];
            boxes[BOX * index + axis] = Math.min(a, Math.min(b, c));
            boxes[BOX * index + axis + 3] = Math.max(a, Math.max(b, c));
        }
    }

    private BvhPart part(int from, int to) {
        float[] box = emptyBox();
        for (int i = from; i < to; i++) {
            grow(box, 0, boxes, BOX * order[i]);
        }
        return new BvhPart(box, from, to);
    }

    private static float[] emptyBox() {
        float[] box = new float[BOX];
        clear(box, 0);
        return box;
    }

    private static void clear(float[] box, int at) {
        Arrays.fill(box, at, at + 3, Float.POSITIVE_INFINITY);
        Arrays.fill(box, at + 3, at + BOX, Float.NEGATIVE_INFINITY);
    }

    private static void grow(float[] box, int at, float[] by, int from) {
        for (int axis = 0; axis < 3; axis++) {
            box[at + axis] = Math.min(box[at + axis], by[from + axis]);
            box[at + 3 + axis] = Math.max(box[at + 3 + axis], by[from + 3 + axis]);
        }
    }

    /** Half the surface of a box; 0 for an empty one. */
    static float area(float[] box, int at) {
        float x = box[at + 3] - box[at];
        float y = box[at + 4] - box[at + 1];
        float z = box[at + 5] - box[at + 2];
        return x < 0.0f ? 0.0f : x * y + y * z + z * x;
    }

    private void split(BvhPart part, int level) {
        int size = part.to - part.from;
        if (size > WORTH_A_THREAD && Thread.currentThread().isInterrupted()) {
            throw new CancellationException("interrupted while a tree was built");
        }
        if (size <= 1) {
            return;
        }
        Bins bins = new Bins(part);
        boolean splits = level < DEEPEST && bins.find();
        if (size <= MAX_IN_LEAF
                && (!splits || bins.bestCost + STEP * area(part.box, 0) >= area(part.box, 0) * BvhNode.blocks(size))) {
            return;
        }
        int middle = splits ? bins.partition() : part.from + size / 2;
        part.left = part(part.from, middle);
        part.right = part(middle, part.to);
        if (size < WORTH_A_THREAD || Workers.available() == 1) {
            split(part.left, level + 1);
            split(part.right, level + 1);
        } else {
            Workers.both(() -> split(part.left, level + 1), () -> split(part.right, level + 1));
        }
    }

    /** The triangles of a part, sorted into bins by their centres, and where to split them. */
    private final class Bins {
        private final BvhPart part;
        private final int number;
        private final float[] low = new float[3];
        private final float[] scale = new float[3];
        private final int[] counts = new int[3 * BINS];
        private final float[] binBoxes = new float[3 * BINS * BOX];
        private float bestCost = Float.POSITIVE_INFINITY;
        private int bestAxis;
        private int bestBin;

        Bins(BvhPart part) {
            this.part = part;
            this.number = Math.min(BINS, 6 + (part.to - part.from) / 2);
        }

        /** Finds the cheapest border between bins; false when all centres fall into one bin. */
        boolean find() {
            setScale();
            fill();
            for (int axis = 0; axis < 3; axis++) {
                if (scale[axis] > 0.0f) {
                    sweep(axis);
                }
            }
            return bestCost < Float.POSITIVE_INFINITY;
        }

        /** Twice the centre of a triangle's box. */
        private float centre(int index, int axis) {
            return boxes[BOX * index + axis] + boxes[BOX * index + axis + 3];
        }

        private void setScale() {
            for (int axis = 0; axis < 3; axis++) {
                float first = Float.POSITIVE_INFINITY;
                float last = Float.NEGATIVE_INFINITY;
                for (int i = part.from; i < part.to; i++) {
                    first = Math.min(first, centre(order[i], axis));
                    last = Math.max(last, centre(order[i], axis));
                }
                low[axis] = first;
                float stretch = number * 0.9999f / (last - first);
                // 0 when all are at one point, or so near to each other that the quotient is useless.
                scale[axis] = last > first && stretch < 1e30f ? stretch : 0.0f;
            }
        }

        private int bin(int index, int axis) {
            return (int) ((centre(index, axis) - low[axis]) * scale[axis]);
        }

        private void fill() {
            for (int i = 0; i < 3 * BINS; i++) {
                clear(binBoxes, BOX * i);
            }
            for (int i = part.from; i < part.to; i++) {
                for (int axis = 0; axis < 3; axis++) {
                    int bin = axis * BINS + bin(order[i], axis);
                    counts[bin]++;
                    grow(binBoxes, BOX * bin, boxes, BOX * order[i]);
                }
            }
        }

        /** Costs of all borders on an axis: right sides from the last bin down, then left sides from the first up. */
        private void sweep(int axis) {
            float[] rightAreas = new float[BINS];
            int[] rightCounts = new int[BINS];
            float[] side = emptyBox();
            int size = 0;
            for (int bin = number - 1; bin > 0; bin--) {
                size += counts[axis * BINS + bin];
                grow(side, 0, binBoxes, BOX * (axis * BINS + bin));
                rightAreas[bin] = area(side, 0);
                rightCounts[bin] = size;
            }
            clear(side, 0);
            size = 0;
            for (int bin = 1; bin < number; bin++) {
                size += counts[axis * BINS + bin - 1];
                grow(side, 0, binBoxes, BOX * (axis * BINS + bin - 1));
                if (size > 0 && rightCounts[bin] > 0) {
                    float cost = area(side, 0) * work(size) + rightAreas[bin] * work(rightCounts[bin]);
                    if (cost < bestCost) {
                        bestCost = cost;
                        bestAxis = axis;
                        bestBin = bin;
                    }
                }
            }
        }

        /** Blocks that triangles fill: whole blocks near the leaves, else a fraction. */
        private float work(int triangles) {
            boolean many = part.to - part.from > 4 * BvhNode.TRIANGLES;
            return many ? (float) triangles / BvhNode.TRIANGLES : BvhNode.blocks(triangles);
        }

        /** Partitions the triangles at the best border; returns the index of the first on its right. */
        int partition() {
            int left = part.from;
            int right = part.to - 1;
            while (left <= right) {
                if (bin(order[left], bestAxis) < bestBin) {
                    left++;
                } else {
                    int swap = order[left];
                    order[left] = order[right];
                    order[right--] = swap;
                }
            }
            return left;
        }
    }
}
