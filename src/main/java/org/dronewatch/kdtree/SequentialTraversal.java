package org.dronewatch.kdtree;

/**
 * The sequential traversal of Hapala and Havran, "Review: kd-tree traversal algorithms for ray tracing" (2011): find the
 * leaf of a point by descending from the root, test it, step to a point just behind the leaf's exit face, repeat. Needs
 * no stack; it is slower than {@link StackTraversal} and kept as an independent second opinion.
 *
 * <p>Where the original steps by a fixed distance, which skips thin cells and stalls at large coordinates, this one
 * puts the point on the exit axis to the next number behind the face and holds it inside the leaf's bounds on the other
 * axes. Each step so moves on along the ray's sense on one axis and back on none: it ends.
 */
public final class SequentialTraversal extends KDTraversal {
    private final double[] point = new double[3];
    private final double[] low = new double[3];
    private final double[] high = new double[3];

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
        float[] root = tree.rootBox();
        for (int axis = 0; axis < 3; axis++) {
            point[axis] = clamp(origin[axis] + entry * direction[axis], root[axis], root[axis + 3]);
        }
        while (true) {
            long leaf = locateLeaf();
            int exitAxis = exitAxis();
            double leafExit = exitAxis < 0 ? Double.POSITIVE_INFINITY : exitParameter(exitAxis);
            testLeaf(leaf, tMin);
            boolean hitHere = intersection.found() && (anyHit || intersection.distance() <= leafExit * (1.0 + OVERLAP));
            if (hitHere || exitAxis < 0 || leafExit * (1.0 - OVERLAP) > exit || !step(exitAxis, leafExit)) {
                return;
            }
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
