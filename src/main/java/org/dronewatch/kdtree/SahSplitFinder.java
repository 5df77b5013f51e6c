package org.dronewatch.kdtree;

import java.util.Arrays;
import java.util.Optional;

/**
 * Finds the cheapest plane to split a voxel, by sweeping a plane along each axis. The cost changes only where a triangle
 * ends, lies, or starts, so these events, sorted, are all there is to try.
 *
 * <p>Boxes and voxels are given as grid numbers (see {@link KDNode}), triangles rounded outwards. On the grid the sweep
 * is exact: what it counts on each side is what {@link Split} will put there. A triangle that lies in a plane between
 * two grid values is a thin box here, and both of its sides are tried.
 */
final class SahSplitFinder {
    /** How many numbers a box has: minimum on three axes, then maximum. */
    static final int BOX = 6;

    private static final int END = 0;
    private static final int PLANAR = 1;
    private static final int START = 2;

    private int[] events = new int[0];

    /** The best split so far, while one search runs. */
    private Split best;

    /**
     * The cheapest split of a voxel.
     *
     * @param boxes the triangles' boxes clipped to the voxel, {@link #BOX} numbers each
     * @param count how many triangles there are
     * @param voxel the voxel's box
     * @return the cheapest split, or empty when no plane lies inside the voxel or the voxel has no surface
     */
    Optional<Split> find(int[] boxes, int count, int[] voxel) {
        best = null;
        if (events.length < 2 * count) {
            events = new int[2 * count];
        }
        VoxelShares shares = new VoxelShares(voxel);
        if (shares.area() > 0.0) {
            for (int axis = 0; axis < 3; axis++) {
                sweep(axis, fillEvents(boxes, count, axis), count, voxel, shares);
            }
        }
        return Optional.ofNullable(best);
    }

    private int fillEvents(int[] boxes, int count, int axis) {
        int size = 0;
        for (int i = 0; i < count; i++) {
            int low = boxes[BOX * i + axis];
            int high = boxes[BOX * i + axis + 3];
            if (low == high) {
                events[size++] = KDNode.event(low, PLANAR);
            } else {
                events[size++] = KDNode.event(low, START);
                events[size++] = KDNode.event(high, END);
            }
        }
        Arrays.sort(events, 0, size);
        return size;
    }

    private void sweep(int axis, int size, int count, int[] voxel, VoxelShares shares) {
        int left = 0;
        int right = count;
        int next = 0;
        while (next < size) {
            // All events of one plane, in the order end, planar, start.
            int key = KDNode.eventKey(events[next]);
            int ended = runLength(next, size, KDNode.event(key, END));
            next += ended;
            int planar = runLength(next, size, KDNode.event(key, PLANAR));
            next += planar;
            int started = runLength(next, size, KDNode.event(key, START));
            next += started;

            right -= ended + planar;
            if (key > voxel[axis] && key < voxel[axis + 3]) {
                tryPlane(axis, key, left, planar, right, shares);
            }
            left += started + planar;
        }
    }

    private int runLength(int from, int size, int event) {
        int end = from;
        while (end < size && events[end] == event) {
            end++;
        }
        return end - from;
    }

    private void tryPlane(int axis, int key, int left, int planar, int right, VoxelShares shares) {
        double leftShare = shares.left(axis, key);
        double rightShare = shares.right(axis, key);
        double planarLeftCost = SahCost.split(leftShare, rightShare, left + planar, right);
        double planarRightCost = SahCost.split(leftShare, rightShare, left, right + planar);
        double cost = Math.min(planarLeftCost, planarRightCost);
        if (best == null || cost < best.cost()) {
            best = new Split(axis, key, planarLeftCost <= planarRightCost, cost);
        }
    }

    /** Surface of the parts of a voxel relative to the whole. */
    private static final class VoxelShares {
        private final double[] low = new double[3];
        private final double[] high = new double[3];
        private final double area;

        VoxelShares(int[] voxel) {
            for (int axis = 0; axis < 3; axis++) {
                low[axis] = KDNode.value(voxel[axis]);
                high[axis] = KDNode.value(voxel[axis + 3]);
            }
            this.area = areaBetween(0, low[0], high[0]);
        }

        double area() {
            return area;
        }

        double left(int axis, int key) {
            return areaBetween(axis, low[axis], KDNode.value(key)) / area;
        }

        double right(int axis, int key) {
            return areaBetween(axis, KDNode.value(key), high[axis]) / area;
        }

        /** Half the surface of the voxel cut to an interval on one axis. */
        private double areaBetween(int axis, double from, double to) {
            int second = (axis + 1) % 3;
            int third = (axis + 2) % 3;
            double width = to - from;
            double depth = high[second] - low[second];
            double height = high[third] - low[third];
            return width * depth + depth * height + height * width;
        }
    }
}
