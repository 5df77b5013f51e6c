package org.dronewatch.kdtree;

/** What the ray tracers that walk the cells of a kd-tree have in common. */
abstract class KDTraversal extends RayTracer {
    /**
     * How far, relatively, two cells of the tree may overlap along a ray: a few roundings of a plane's ray parameter. A
     * hit on the border of two cells is then looked for in both.
     */
    static final double OVERLAP = 8.0 * 0x1p-53;

    final KDTree tree;

    KDTraversal(KDTree tree) {
        super(tree.triangles());
        this.tree = tree;
    }

    /** The smallest ray parameter inside the root's box, not below tMin; wider than exact by {@link #OVERLAP}. */
    final double rootEntry(double tMin) {
        float[] box = tree.rootBox();
        double entry = tMin;
        for (int axis = 0; axis < 3; axis++) {
            double plane = inverse[axis] >= 0.0 ? box[axis] : box[axis + 3];
            double t = (plane - origin[axis]) * inverse[axis];
            // Not a number when the ray runs inside the plane: that bounds nothing, and the comparison says so.
            if (t * (1.0 - OVERLAP) > entry) {
                entry = t * (1.0 - OVERLAP);
            }
        }
        return entry;
    }

    /** The largest ray parameter inside the root's box, not above tMax; negative when the box lies behind. */
    final double rootExit(double tMax) {
        float[] box = tree.rootBox();
        double exit = tMax;
        for (int axis = 0; axis < 3; axis++) {
            double plane = inverse[axis] >= 0.0 ? box[axis + 3] : box[axis];
            double t = (plane - origin[axis]) * inverse[axis];
            if (t * (1.0 + OVERLAP) < exit) {
                exit = t * (1.0 + OVERLAP);
            }
        }
        return exit;
    }

    /** Tests the triangles of a leaf. */
    final void testLeaf(long leaf, double tMin) {
        int[] leafTriangles = tree.leafTriangles();
        int from = KDNode.first(leaf);
        int to = from + KDNode.count(leaf);
        for (int i = from; i < to; i++) {
            intersection.test(leafTriangles[i], tMin);
        }
    }
}
