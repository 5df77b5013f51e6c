package org.dronewatch.bvh;

import java.util.Arrays;
import org.dronewatch.kdtree.KDNode;
import org.dronewatch.kdtree.KDTree;

/**
 * Descends a tree for all segments of a {@link FanBeam} at once, nearer cells first, and tests the triangles in the
 * cells that any of them crosses. For use by one thread.
 */
final class FanTracer {
    /** Widens directions, and the interval of a cell, by more than the rounding errors of their bounds. */
    static final double WIDER = 1e-12;

    /** Remembered triangles: a power of two. */
    private static final int REMEMBERED = 256;

    private final KDTree tree;
    private final FanBeam beam;
    private final FanOcclusion test;
    private final double[] origin = new double[3];

    // As in the descent of a picture's tile: for each axis, for planes above the origin and then for those below, the
    // distance ahead, per metre to the plane, at which the first segment meets it, and at which the last one does.
    private final double[] first = new double[6];
    private final double[] last = new double[6];

    /** How far the segments extend from the origin along each axis, and against it, m. */
    private final double[] reach = new double[6];

    private final int[] stackNode;
    private final double[] stackEntry;
    private final double[] stackExit;

    /** The last triangles that were tested, by their lowest bits, with the number of the beam. */
    private final long[] recent = new long[REMEMBERED];

    private long beams;

    /** The triangle that hid the last of a beam that was hidden as a whole; -1 for none. */
    private int obstacle = -1;

    FanTracer(KDTree tree, FanBeam beam) {
        this.tree = tree;
        this.beam = beam;
        this.test = new FanOcclusion(tree.triangles().corners(), beam);
        int size = tree.depth() + 1;
        this.stackNode = new int[size];
        this.stackEntry = new double[size];
        this.stackExit = new double[size];
        Arrays.fill(recent, -1);
    }

    /** Traces the segments of the beam from an origin. */
    void trace(double ox, double oy, double oz, double skipped) {
        origin[0] = ox;
        origin[1] = oy;
        origin[2] = oz;
        beams++;
        setDirections();
        test.begin(origin, skipped);
        // Neighbouring beams are often hidden by the same triangle.
        if (obstacle >= 0) {
            mark(obstacle);
            test.add(obstacle);
        }
        descend();
        int last = test.test();
        obstacle = last >= 0 ? last : obstacle;
    }

    private void setDirections() {
        setDirection(beam.axisAcross, beam.middleAcross - beam.halfAcross, beam.middleAcross + beam.halfAcross);
        setDirection(beam.axisAlong, beam.middleAlong - beam.halfAlong, beam.middleAlong + beam.halfAlong);
        setDirection(beam.axisAhead, beam.sign, beam.sign);
        reach[2 * beam.axisAcross] = beam.highAcross;
        reach[2 * beam.axisAcross + 1] = -beam.lowAcross;
        reach[2 * beam.axisAlong] = beam.highAlong;
        reach[2 * beam.axisAlong + 1] = -beam.lowAlong;
        reach[2 * beam.axisAhead] = beam.farthest * (1.0 + FanBeam.ROUNDING);
        reach[2 * beam.axisAhead + 1] = reach[2 * beam.axisAhead];
    }

    private void setDirection(int axis, double low, double high) {
        first[2 * axis] = high > 0.0 ? (1.0 - WIDER) / high : Double.POSITIVE_INFINITY;
        last[2 * axis] = low > 0.0 ? (1.0 + WIDER) / low : Double.POSITIVE_INFINITY;
        first[2 * axis + 1] = low < 0.0 ? (1.0 - WIDER) / low : Double.NEGATIVE_INFINITY;
        last[2 * axis + 1] = high < 0.0 ? (1.0 + WIDER) / high : Double.NEGATIVE_INFINITY;
    }

    private void descend() {
        double entry = 0.0;
        double exit = beam.farthest * (1.0 + FanBeam.ROUNDING);
        float[] box = tree.rootBox();
        for (int axis = 0; axis < 3; axis++) {
            double toLow = box[axis] - origin[axis];
            double toHigh = box[axis + 3] - origin[axis];
            if (toLow > 0.0) {
                entry = Math.max(entry, toLow * first[2 * axis]);
                exit = Math.min(exit, toHigh * last[2 * axis]);
            } else if (toHigh < 0.0) {
                entry = Math.max(entry, toHigh * first[2 * axis + 1]);
                exit = Math.min(exit, toLow * last[2 * axis + 1]);
            }
        }
        if (!(entry <= exit)) {
            return;
        }
        long[] nodes = tree.nodes();
        int stacked = 0;
        int index = 0;
        while (true) {
            long node = nodes[index];
            int axis = KDNode.kind(node);
            while (axis != KDNode.LEAF) {
                // Where a parameter is not a number the origin lies in the plane: both sides are visited.
                double toPlane = KDNode.split(node) - origin[axis];
                int near = KDNode.leftChild(index);
                int far = KDNode.rightChild(node);
                int side = 2 * axis;
                if (toPlane < 0.0) {
                    int swap = near;
                    near = far;
                    far = swap;
                    side++;
                }
                double firstMeets = toPlane * first[side];
                double lastMeets = toPlane * last[side];
                if (firstMeets > exit || Math.abs(toPlane) > reach[side]) {
                    index = near;
                } else if (lastMeets < entry) {
                    index = far;
                } else {
                    stackNode[stacked] = far;
                    stackEntry[stacked] = firstMeets > entry ? firstMeets : entry;
                    stackExit[stacked] = exit;
                    stacked++;
                    index = near;
                    exit = lastMeets < exit ? lastMeets : exit;
                }
                node = nodes[index];
                axis = KDNode.kind(node);
            }
            if (testLeaf(node) || stacked == 0) {
                return;
            }
            stacked--;
            index = stackNode[stacked];
            entry = stackEntry[stacked];
            exit = stackExit[stacked];
        }
    }

    private boolean testLeaf(long leaf) {
        int[] leafTriangles = tree.leafTriangles();
        int from = KDNode.first(leaf);
        int to = from + KDNode.count(leaf);
        for (int i = from; i < to; i++) {
            int triangle = leafTriangles[i];
            if (mark(triangle) && test.add(triangle)) {
                int last = test.test();
                if (last >= 0) {
                    obstacle = last;
                    return true;
                }
            }
        }
        return false;
    }

    /** Marks a triangle as met by the beam; false if it was before. */
    private boolean mark(int triangle) {
        int slot = triangle & REMEMBERED - 1;
        long visit = beams << 32 | triangle;
        boolean isNew = recent[slot] != visit;
        recent[slot] = visit;
        return isNew;
    }
}
