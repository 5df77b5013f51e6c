package org.dronewatch.bvh;

/**
 * A bounding volume hierarchy with eight children per node over the triangles of a
 * {@link org.dronewatch.kdtree.KDTree}, for incoherent rays: fewer and wider steps than in a kd-tree, each by vector
 * instructions. Immutable, shared by all threads.
 */
final class Bvh {
    /** The distance from the origin up to which the margins of single precision are known to hold, m. */
    static final double FARTHEST = 0x1p40;

    private final int[] pool;
    private final double reach;
    private final int depth;

    /**
     * A finished tree.
     *
     * @param pool nodes and blocks in the layout of {@link BvhNode}
     * @param reach the largest absolute coordinate, m
     * @param depth the largest number of nodes on a path from the root
     */
    Bvh(int[] pool, double reach, int depth) {
        this.pool = pool;
        this.reach = reach;
        this.depth = depth;
    }

    int[] pool() {
        return pool;
    }

    double reach() {
        return reach;
    }

    int depth() {
        return depth;
    }
}
