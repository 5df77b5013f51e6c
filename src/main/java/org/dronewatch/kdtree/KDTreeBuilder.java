package org.dronewatch.kdtree;

import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.parallel.LongTask;

/**
 * Builds a tree top down: split where {@link SahSplitFinder} finds it cheapest, stop when no split is cheaper than a
 * leaf. Follows Wald and Havran (2006). Large parts grow side by side on the {@link org.dronewatch.parallel.Workers} of
 * the calling thread; the tree is the same for any number of them.
 *
 * <p>Two limits bound what degenerate input can do: on the depth ({@link #depthLimit}), and on the references to
 * triangles in the leaves ({@link #MAX_REFERENCES}), which {@link TreeGrower} divides among the parts of the tree.
 * Memory is thus proportional to the number of triangles, both while the tree grows and once it is complete. The limits
 * do not change a tree that stays within them.
 */
final class KDTreeBuilder {
    private static final int BOX = SahSplitFinder.BOX;
    /**
     * Maximum number of references that the leaves of a tree hold per triangle of the mesh, on average. The packaged
     * models have 2 to 7, closed surfaces 2 to 4, ground 1 to 2; without a limit, bundles of slivers would have as many
     * references per triangle as they have triangles.
     */
    static final int MAX_REFERENCES = 16;

    private final TriangleMesh mesh;
    private final SahCost costs;
    private final float[] corners;
    private final long duplicates;

    /** A builder of a tree of at most {@link #MAX_REFERENCES} references per triangle. */
    KDTreeBuilder(TriangleMesh mesh, SahCost costs) {
        this(mesh, costs, MAX_REFERENCES);
    }

    /**
     * A builder.
     *
     * @param costs costs that decide whether a cell is split, and where
     * @param maxReferences maximum average number of references per triangle, at least 1
     */
    KDTreeBuilder(TriangleMesh mesh, SahCost costs, int maxReferences) {
        this.mesh = mesh;
        this.costs = costs;
        this.corners = flatten(mesh);
        this.duplicates = (maxReferences - 1L) * mesh.triangleCount();
    }

    /** The depth at which splitting ends, whatever the cost: this bounds what degenerate input can do. */
    static int depthLimit(int triangles) {
        return (int) (8.0 + 1.3 * Math.log(Math.max(1, triangles)) / Math.log(2.0));
    }

    KDTree build() {
        return build(LongTask.silent());
    }

    KDTree build(LongTask task) {
        int count = mesh.triangleCount();
        float[] rootBox = new float[BOX];
        NodeTriangles all = new NodeTriangles(count);
        int[] voxel = new int[BOX];
        if (count > 0) {
            for (int i = 0; i < count; i++) {
                all.triangles[i] = i;
                writeBox(i, all.boxes);
            }
            all.count = count;
            voxel = all.bounds();
            for (int k = 0; k < BOX; k++) {
                rootBox[k] = KDNode.value(voxel[k]);
            }
        }
        Cell root = new Cell(all, voxel, 0, count);
        Subtree tree = new TreeGrower(corners, costs, depthLimit(count), task).grow(root, duplicates);
        int[] leaves = tree.leafTriangles();
        LeafOrderTriangles triangles = LeafOrderTriangles.of(leaves, corners);
        return new KDTree(mesh, costs, tree.nodes(), leaves, triangles, rootBox, tree.depth());
    }

    private static float[] flatten(TriangleMesh mesh) {
        float[] flat = new float[9 * mesh.triangleCount()];
        for (int i = 0; i < flat.length; i++) {
            flat[i] = mesh.coordinate(i / 9, i / 3 % 3, i % 3);
        }
        return flat;
    }

    private void writeBox(int triangle, int[] boxes) {
        for (int axis = 0; axis < 3; axis++) {
            float a = corners[9 * triangle + axis];
            float b = corners[9 * triangle + 3 + axis];
            float c = corners[9 * triangle + 6 + axis];
            boxes[BOX * triangle + axis] = KDNode.floorKey(Math.min(a, Math.min(b, c)));
            boxes[BOX * triangle + axis + 3] = KDNode.ceilKey(Math.max(a, Math.max(b, c)));
        }
    }
}
