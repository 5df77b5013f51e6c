package org.dronewatch.bvh;

/**
 * A tree of boxes with eight children a node over the triangles of a {@link org.dronewatch.kdtree.KDTree}, for rays that have nothing to do with
 * each other: fewer and wider steps than a kd-tree's, each by vector instructions. Immutable, shared by all threads.
 */
final class Bvh {
    /** Farther from the origin, the margins of single precision are not known to hold, m. */
    static final double FARTHEST = 0x1p40;

    private final int[] pool;
    private final double reach;
    private final int depth;

    /**
     * A finished tree.
     *
     * @param pool nodes and blocks as {@link BvhNode} says
     * @param reach the largest absolute coordinate, m
     * @param depth the largest number of nodes one in another
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
