package org.dronewatch.kdtree;

/**
 * A ray tracer without a stack, following the sequential traversal of Hapala and Havran, "Review: kd-tree traversal
 * algorithms for ray tracing" (2011): it finds a leaf by descending from the root, tests it, continues with the next
 * leaf along the ray, and so on. It is slower than {@link StackTraversal} and kept as an independent check.
 *
 * <p>The original finds the next leaf by a point at a fixed distance behind the face through which the ray leaves. That
 * skips thin cells and stalls at large coordinates. A point just behind the face does neither, but if the ray leaves
 * through an edge or a corner, or runs inside a plane, rounding alone decides in which of the adjacent cells that point
 * lies, and the others are skipped. Here the next leaf is the first one that follows the leaf just tested in the order
 * of the leaves along the ray.
 *
 * <p>The leaves along a ray, and their order, depend on the tree and the ray alone. A child lies along the ray if the
 * ray's range inside it, widened by more than the rounding errors of its ends, is not empty; of two children, the one
 * on the ray's side of the plane comes first, or the left one if the ray runs inside the plane. So cells that the ray
 * merely touches are included, and each descent leads to a later leaf in one fixed order: no leaf is visited twice, and
 * the traversal terminates.
 *
 * <p>A hit ends the ray at its distance. All leaves up to there are tested, so the hit is exactly the nearest of all
 * and, among equally near ones, that with the lowest number.
 */
public final class SequentialTraversal extends KDTraversal {
    /** The index of no node. */
    private static final int NONE = -1;

    private double rayEntry;
    private double rayExit;

    // The range of the ray inside the child that has been entered last.
    private double entry;
    private double exit;

    /** A ray tracer of a tree for use by one thread. */
    public SequentialTraversal(KDTree tree) {
        super(tree);
    }

    @Override
    protected void trace(double tMin, double tMax, boolean anyHit) {
        intersection.setRay(origin, direction);
        rayEntry = rootEntry(tMin);
        rayExit = rootExit(tMax);
        long[] nodes = tree.nodes();
        int leaf = rayEntry <= rayExit ? firstLeaf(0, rayEntry, rayExit) : NONE;
        while (leaf != NONE) {
            testLeaf(nodes[leaf], tMin);
            if (anyHit && intersection.found()) {
                return;
            }
            leaf = leafAfter(leaf);
        }
    }

    /** The first leaf along the ray in a part of the tree whose box the ray meets in a range that is not empty. */
    private int firstLeaf(int root, double partEntry, double partExit) {
        long[] nodes = tree.nodes();
        entry = partEntry;
        exit = partExit;
        int index = root;
        for (long node = nodes[index]; KDNode.kind(node) != KDNode.LEAF; node = nodes[index]) {
            double t = parameter(node);
            // The far child is entered where the ray has passed the plane before it enters the part.
            if (latest(t) < entry) {
                index = farChild(index, node);
            } else {
                index = nearChild(index, node);
                leaveAt(t);
            }
        }
        return index;
    }

    /**
     * The first leaf along the ray that comes after another: in the far child of the deepest node that has the other
     * leaf in its near child and whose far child lies along the ray.
     */
    private int leafAfter(int leaf) {
        long[] nodes = tree.nodes();
        entry = rayEntry;
        exit = Math.min(rayExit, intersection.distance());
        int turn = NONE;
        double turnEntry = 0.0;
        double turnExit = 0.0;
        int index = 0;
        while (index != leaf) {
            long node = nodes[index];
            double t = parameter(node);
            int far = farChild(index, node);
            // Nodes lie in the order of their descent: all that is left of a plane before all that is right of it.
            boolean inRight = leaf >= KDNode.rightChild(node);
            if (inRight == (far == KDNode.rightChild(node))) {
                enterAt(t);
                index = far;
            } else {
                double nearEntry = entry;
                enterAt(t);
                if (entry <= exit) {
                    turn = far;
                    turnEntry = entry;
                    turnExit = exit;
                }
                entry = nearEntry;
                leaveAt(t);
                index = nearChild(index, node);
            }
        }
        return turn == NONE ? NONE : firstLeaf(turn, turnEntry, turnExit);
    }

    /**
     * Where the ray meets a node's plane; NaN if it runs inside the plane: it is then in both children all the time.
     */
    private double parameter(long node) {
        int axis = KDNode.kind(node);
        return (KDNode.split(node) - origin[axis]) * inverse[axis];
    }

    private int nearChild(int index, long node) {
        return inverse[KDNode.kind(node)] < 0.0 ? KDNode.rightChild(node) : KDNode.leftChild(index);
    }

    private int farChild(int index, long node) {
        return inverse[KDNode.kind(node)] < 0.0 ? KDNode.leftChild(index) : KDNode.rightChild(node);
    }

    private void enterAt(double t) {
        double earliest = t - Math.abs(t) * OVERLAP;
        if (earliest > entry) {
            entry = earliest;
        }
    }

    private void leaveAt(double t) {
        if (latest(t) < exit) {
            exit = latest(t);
        }
    }

    private static double latest(double t) {
        return t + Math.abs(t) * OVERLAP;
    }
}
