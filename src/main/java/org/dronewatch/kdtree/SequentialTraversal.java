package org.dronewatch.kdtree;

/**
 * The sequential traversal of Hapala and Havran, "Review: kd-tree traversal algorithms for ray tracing" (2011): find the
 * leaf of a point by descending from the root, test it, step to a point just behind the leaf's exit face, repeat. Needs
 * no stack; it is slower than {@link StackTraversal} and kept as an independent second opinion.
 *
 * <p>Where the original steps by a fixed distance, which skips thin cells and stalls at large coordinates, this one
 * puts the point on the exit axis to the next number behind the face and holds it inside the leaf's bounds on the other
 * axes. Each step so moves on along the ray's sense on one axis and back on none: it ends. A ray that lies in planes of the
 * tree walks along each of their sides: the leaves there end at different places.
 */
public final class SequentialTraversal extends KDTraversal {
    private final double[] point = new double[3];
    private final double[] low = new double[3];
    private final double[] high = new double[3];
    private final double[] leafPoint = new double[3];
    private final double[] leafLow = new double[3];
    private final double[] leafHigh = new double[3];

    /** A traversal of a tree for the use of one thread. */
    public SequentialTraversal(KDTree tree) {
        super(tree);
    }

    @Override
    void trace(double tMin, double tMax, boolean anyHit) {
        double entry = rootEntry(tMin);
        double exit = rootExit(tMax);
        if (!(entry <= exit)) {
            return;
        }
        int still = 0;
        for (int axis = 0; axis < 3; axis++) {
            still |= direction[axis] == 0.0 ? 1 << axis : 0;
        }
        // A ray that runs inside planes of the tree goes along each of their sides in turn.
        int above = still;
        while (true) {
            walk(entry, exit, tMin, anyHit, above);
            if (above == 0 || anyHit && intersection.found()) {
                return;
            }
            above = above - 1 & still;
        }
    }

    /**
     * Walks from leaf to leaf.
     *
     * @param above bits of the axes on which a point in a plane counts to what is above it
     */
    private void walk(double entry, double exit, double tMin, boolean anyHit, int above) {
        float[] root = tree.rootBox();
        for (int axis = 0; axis < 3; axis++) {
            double place = clamp(origin[axis] + entry * direction[axis], root[axis], root[axis + 3]);
            point[axis] = (above & 1 << axis) == 0 ? place : Math.nextUp(place);
        }
        double leafEntry = entry;
        while (true) {
            long leaf = locateLeaf();
            int exitAxis = exitAxis();
            double leafExit = exitAxis < 0 ? Double.POSITIVE_INFINITY : exitParameter(exitAxis);
            testLeaf(leaf, tMin);
            testAround(leafEntry, -1, tMin);
            testAround(leafExit, exitAxis, tMin);
            boolean hitHere = intersection.found() && (anyHit || intersection.distance() <= leafExit * (1.0 + OVERLAP));
            if (hitHere || exitAxis < 0 || leafExit * (1.0 - OVERLAP) > exit || !step(exitAxis, leafExit)) {
                return;
            }
            leafEntry = leafExit;
        }
    }

    /** The leaf that holds the point; its box is left in low and high. A point on a plane counts to the nearer side. */
    private long locateLeaf() {
        long[] nodes = tree.nodes();
        float[] root = tree.rootBox();
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = root[axis];
            high[axis] = root[axis + 3];
        }
        int index = 0;
        long node = nodes[0];
        int axis = KDNode.kind(node);
        while (axis != KDNode.LEAF) {
            double split = KDNode.split(node);
            if (point[axis] < split || point[axis] == split && inverse[axis] >= 0.0) {
                index++;
                high[axis] = split;
            } else {
                index = KDNode.rightChild(node);
                low[axis] = split;
            }
            node = nodes[index];
            axis = KDNode.kind(node);
        }
        return node;
    }

    /** The axis of the leaf's face through which the ray leaves, or -1 when the direction is all zero. */
    private int exitAxis() {
        int nearest = -1;
        double t = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            if (direction[axis] != 0.0 && (nearest < 0 || exitParameter(axis) < t)) {
                nearest = axis;
                t = exitParameter(axis);
            }
        }
        return nearest;
    }

    /**
     * Tests the other leaves about the edge or corner of the leaf that the ray passes at a parameter: rounding alone says
     * which of them it enters, and a step leads to one of them only.
     *
     * @param known the axis on which the ray is known to be at the leaf's face, and alone to be so as a rule, or -1
     */
    private void testAround(double t, int known, double tMin) {
        int ahead = 0;
        int behind = 0;
        for (int axis = 0; axis < 3; axis++) {
            if (direction[axis] == 0.0) {
                continue;
            }
            if (exitParameter(axis) * (1.0 - OVERLAP) <= t * (1.0 + OVERLAP)) {
                ahead |= 1 << axis;
            } else if (entryParameter(axis) * (1.0 + OVERLAP) >= t * (1.0 - OVERLAP)) {
                behind |= 1 << axis;
            }
        }
        int touched = ahead | behind;
        if (Integer.bitCount(touched) < 2 && (known >= 0 || ahead == 0)) {
            return;
        }
        copy(point, leafPoint);
        copy(low, leafLow);
        copy(high, leafHigh);
        for (int crossed = touched; crossed > 0; crossed = crossed - 1 & touched) {
            for (int axis = 0; axis < 3; axis++) {
                int bit = crossed & 1 << axis;
                point[axis] = bit == 0 ? onRay(axis, t) : across(axis, (bit & ahead) != 0);
            }
            testLeaf(locateLeaf(), tMin);
        }
        copy(leafPoint, point);
        copy(leafLow, low);
        copy(leafHigh, high);
    }

    /** A place just behind the leaf's face ahead, or before the one behind. */
    private double across(int axis, boolean ahead) {
        return inverse[axis] >= 0.0 == ahead ? Math.nextUp(leafHigh[axis]) : Math.nextDown(leafLow[axis]);
    }

    /** Where the ray is on an axis, held inside the leaf; the face behind it does not belong to the leaf. */
    private double onRay(int axis, double t) {
        if (direction[axis] == 0.0) {
            return leafPoint[axis];
        }
        double place = origin[axis] + t * direction[axis];
        return inverse[axis] >= 0.0
                ? clamp(place, Math.nextUp(leafLow[axis]), leafHigh[axis])
                : clamp(place, leafLow[axis], Math.nextDown(leafHigh[axis]));
    }

    private static void copy(double[] from, double[] to) {
        System.arraycopy(from, 0, to, 0, 3);
    }

    private double entryParameter(int axis) {
        double face = inverse[axis] >= 0.0 ? low[axis] : high[axis];
        return (face - origin[axis]) * inverse[axis];
    }

    private double exitParameter(int axis) {
        double face = inverse[axis] >= 0.0 ? high[axis] : low[axis];
        return (face - origin[axis]) * inverse[axis];
    }

    /** Moves the point just behind the leaf's exit face; false when that is outside the root's box. */
    private boolean step(int exitAxis, double t) {
        float[] root = tree.rootBox();
        for (int axis = 0; axis < 3; axis++) {
            if (axis != exitAxis && direction[axis] != 0.0) {
                double ahead = origin[axis] + t * direction[axis];
                point[axis] = inverse[axis] >= 0.0
                        ? clamp(ahead, point[axis], high[axis])
                        : clamp(ahead, low[axis], point[axis]);
            }
        }
        boolean forward = inverse[exitAxis] >= 0.0;
        double face = forward ? high[exitAxis] : low[exitAxis];
        point[exitAxis] = forward ? Math.nextUp(face) : Math.nextDown(face);
        return forward ? face < root[exitAxis + 3] : face > root[exitAxis];
    }

    private static double clamp(double value, double least, double most) {
        return Math.min(Math.max(value, least), most);
    }
}
