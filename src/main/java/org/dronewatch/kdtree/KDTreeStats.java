package org.dronewatch.kdtree;

/**
 * Statistics of a finished tree.
 *
 * @param triangles triangles of the mesh
 * @param nodes number of nodes, interior nodes and leaves together
 * @param leaves number of leaves
 * @param emptyLeaves leaves without a triangle
 * @param meanLeafSize mean number of triangles in the leaves that have any
 * @param maxLeafSize triangles in the fullest leaf
 * @param depth splits above the deepest leaf
 * @param sahCost expected cost of a ray that meets the root's box, in the units of {@link KDTree#costs}
 * @param bytes memory, bytes: nodes, triangle lists of the leaves, and the triangles' corners and indices in the mesh
 */
public record KDTreeStats(
        int triangles,
        int nodes,
        int leaves,
        int emptyLeaves,
        double meanLeafSize,
        int maxLeafSize,
        int depth,
        double sahCost,
        long bytes) {

    /** Measures a tree. */
    public static KDTreeStats of(KDTree tree) {
        Count count = new Count(tree);
        double cost = count.costOf(0, tree.rootBox().clone());
        int filled = count.leaves - count.emptyLeaves;
        long bytes = Long.BYTES * (long) tree.nodes().length
                + Integer.BYTES
                        * ((long) tree.leafTriangles().length + tree.triangles().numbers().length)
                + Float.BYTES * (long) tree.triangles().corners().length;
        return new KDTreeStats(
                tree.mesh().triangleCount(),
                tree.nodes().length,
                count.leaves,
                count.emptyLeaves,
                filled == 0 ? 0.0 : tree.leafTriangles().length / (double) filled,
                count.maxLeafSize,
                tree.depth(),
                cost,
                bytes);
    }

    /** Walks the tree and counts. */
    private static final class Count {
        private final long[] nodes;
        private final SahCost costs;
        private int leaves;
        private int emptyLeaves;
        private int maxLeafSize;

        Count(KDTree tree) {
            this.nodes = tree.nodes();
            this.costs = tree.costs();
        }

        /** Expected cost of a ray that meets a subtree's box. */
        double costOf(int index, float[] box) {
            long node = nodes[index];
            int axis = KDNode.kind(node);
            if (axis == KDNode.LEAF) {
                int size = KDNode.count(node);
                leaves++;
                emptyLeaves += size == 0 ? 1 : 0;
                maxLeafSize = Math.max(maxLeafSize, size);
                return costs.leaf(size);
            }
            float[] left = box.clone();
            left[axis + 3] = KDNode.split(node);
            float[] right = box.clone();
            right[axis] = KDNode.split(node);
            double whole = halfSurface(box);
            double leftCost = costOf(KDNode.leftChild(index), left);
            double rightCost = costOf(KDNode.rightChild(node), right);
            return whole > 0.0
                    ? costs.traversal() + (halfSurface(left) * leftCost + halfSurface(right) * rightCost) / whole
                    : costs.traversal() + leftCost + rightCost;
        }

        private static double halfSurface(float[] box) {
            double x = (double) box[3] - box[0];
            double y = (double) box[4] - box[1];
            double z = (double) box[5] - box[2];
            return x * y + y * z + z * x;
        }
    }
}
