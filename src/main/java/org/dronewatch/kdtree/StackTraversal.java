package org.dronewatch.kdtree;

/**
 * The default ray tracer: descends to the nearer child and keeps the farther one on a stack, so it visits each node at
 * most once.
 */
public final class StackTraversal extends KDTraversal {
    private static final long NOTHING = KDNode.leaf(0, 0);

    private final int[] stackNode;
    private final double[] stackEntry;
    private final double[] stackExit;

    /**
     * The leaf with the triangle that blocked the segment of the most recent query for any hit; an empty leaf if
     * nothing blocked it.
     */
    private long obstacle = NOTHING;

    /** A ray tracer of a tree for use by one thread. */
    public StackTraversal(KDTree tree) {
        super(tree);
        int size = tree.depth() + 1;
        this.stackNode = new int[size];
        this.stackEntry = new double[size];
        this.stackExit = new double[size];
    }

    @Override
    protected void trace(double tMin, double tMax, boolean anyHit) {
        long[] nodes = tree.nodes();
        double entry = rootEntry(tMin);
        double exit = rootExit(tMax);
        if (!(entry <= exit)) {
            return;
        }
        intersection.setRay(origin, direction);
        if (anyHit) {
            // Neighbouring segments are often hidden by the same triangle.
            testLeaf(obstacle, tMin);
            if (intersection.found()) {
                return;
            }
            obstacle = NOTHING;
        }
        int stacked = 0;
        int index = 0;
        boolean inPlane = false;
        while (true) {
            // Descend to a leaf. Where the parameter is not a number the ray runs inside the split plane: both
            // children are visited, over the same range.
            long node = nodes[index];
            int axis = KDNode.kind(node);
            while (axis != KDNode.LEAF) {
                double inverseAxis = inverse[axis];
                double t = (KDNode.split(node) - origin[axis]) * inverseAxis;
                int near = KDNode.leftChild(index);
                int far = KDNode.rightChild(node);
                if (inverseAxis < 0.0) {
                    int swap = near;
                    near = far;
                    far = swap;
                }
                if (t > exit) {
                    index = near;
                } else if (t < entry) {
                    index = far;
                } else {
                    stackNode[stacked] = far;
                    stackExit[stacked] = exit;
                    if (!Double.isNaN(t)) {
                        stackEntry[stacked] = t * (1.0 - OVERLAP);
                        exit = t * (1.0 + OVERLAP);
                    } else {
                        stackEntry[stacked] = entry;
                        inPlane = true;
                    }
                    stacked++;
                    index = near;
                }
                node = nodes[index];
                axis = KDNode.kind(node);
            }

            testLeaf(node, tMin);
            // A hit inside this cell is nearer than all that is still on the stack; a hit beyond it may not be. A ray
            // inside a split plane meets the cells on both sides at once, so that none of its hits is known to be
            // first.
            if (intersection.found() && (anyHit || !inPlane && intersection.distance() <= exit)) {
                obstacle = anyHit ? node : obstacle;
                return;
            }
            if (stacked == 0) {
                return;
            }
            stacked--;
            index = stackNode[stacked];
            entry = stackEntry[stacked];
            exit = stackExit[stacked];
        }
    }
}
