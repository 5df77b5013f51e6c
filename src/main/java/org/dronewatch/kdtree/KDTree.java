package org.dronewatch.kdtree;

import java.util.concurrent.CancellationException;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.parallel.LongTask;

/**
 * A kd-tree over a mesh: packed nodes, the triangles of the leaves, and the triangles in leaf order. Holds data only:
 * ray tracers such as {@link StackTraversal} traverse it, and {@link KDTreeStats} measures it. Immutable, shared by all
 * threads.
 */
public final class KDTree {
    private final TriangleMesh mesh;
    private final SahCost costs;
    private final long[] nodes;
    private final int[] leafTriangles;
    private final LeafOrderTriangles triangles;
    private final float[] bounds;
    private final int depth;

    /**
     * A finished tree; the builder's own arrays are handed over, not copied.
     *
     * @param mesh the mesh that the tree indexes
     * @param costs costs with which the tree was built
     * @param nodes packed nodes, the root first
     * @param leafTriangles indices of triangles in leaf order, leaf by leaf
     * @param triangles the triangles in leaf order
     * @param bounds the root's box, minimum on three axes, then maximum
     * @param depth the largest number of splits above a leaf
     */
    KDTree(
            TriangleMesh mesh,
            SahCost costs,
            long[] nodes,
            int[] leafTriangles,
            LeafOrderTriangles triangles,
            float[] bounds,
            int depth) {
        this.mesh = mesh;
        this.costs = costs;
        this.nodes = nodes;
        this.leafTriangles = leafTriangles;
        this.triangles = triangles;
        this.bounds = bounds;
        this.depth = depth;
    }

    /**
     * Builds the tree of a mesh; if the mesh has no triangles, no ray hits anything.
     *
     * @throws CancellationException when the thread is interrupted while the tree is built
     */
    public static KDTree of(TriangleMesh mesh) {
        return of(mesh, SahCost.DEFAULT);
    }

    /**
     * Builds the tree of a mesh with given costs, which affect the speed of rays, but not their hits.
     *
     * @throws CancellationException when the thread is interrupted while the tree is built
     */
    public static KDTree of(TriangleMesh mesh, SahCost costs) {
        return of(mesh, costs, LongTask.silent());
    }

    /**
     * Builds the tree of a mesh and reports its progress.
     *
     * @param task receives the progress, up to the number of triangles
     * @throws CancellationException when the thread is interrupted while the tree is built
     */
    public static KDTree of(TriangleMesh mesh, SahCost costs, LongTask task) {
        return new KDTreeBuilder(mesh, costs).build(task);
    }

    /** The costs with which this tree was built. */
    public SahCost costs() {
        return costs;
    }

    /** The mesh that this tree indexes. */
    public TriangleMesh mesh() {
        return mesh;
    }

    /** The root's box: the mesh's bounds rounded outwards by up to four units in the last place. */
    public AABB bounds() {
        return new AABB(bounds[0], bounds[1], bounds[2], bounds[3], bounds[4], bounds[5]);
    }

    /**
     * The packed nodes, the root first; for the ray-tracing packages of this library, which do not write to the array.
     */
    public long[] nodes() {
        return nodes;
    }

    /**
     * The indices of the leaves' triangles in {@link #triangles()}, leaf by leaf; for the ray-tracing packages of this
     * library, which do not write to the array.
     */
    public int[] leafTriangles() {
        return leafTriangles;
    }

    /** The triangles in leaf order; for the ray-tracing packages of this library. */
    public LeafOrderTriangles triangles() {
        return triangles;
    }

    /**
     * The root's box: minimum on three axes, then maximum, m; for the ray-tracing packages of this library, which do
     * not write to the array.
     */
    public float[] rootBox() {
        return bounds;
    }

    /** The largest number of splits above a leaf. */
    public int depth() {
        return depth;
    }
}
