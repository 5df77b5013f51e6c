package org.dronewatch.kdtree;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.parallel.Workers;

/**
 * Builds a tree top down: split where {@link SahSplitFinder} says, stop when no split is cheaper than a leaf. Follows
 * Wald and Havran (2006). Large parts grow side by side on the {@link Workers} that call; the tree is the same for any
 * number of them.
 */
final class KDTreeBuilder {
    private static final int BOX = SahSplitFinder.BOX;
    /** Parts of fewer triangles are not worth another thread. */
    private static final int WORTH_A_THREAD = 2048;

    private final TriangleMesh mesh;
    private final float[] corners;
    private final int depthLimit;

    KDTreeBuilder(TriangleMesh mesh) {
        this.mesh = mesh;
        this.corners = flatten(mesh);
        this.depthLimit = depthLimit(mesh.triangleCount());
    }

    /** The depth at which splitting ends whatever it costs: bounds what degenerate input can do. */
    static int depthLimit(int triangles) {
        return (int) (8.0 + 1.3 * Math.log(Math.max(1, triangles)) / Math.log(2.0));
    }

    KDTree build() {
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
        Subtree tree = new Grower().grow(all, voxel, 0);
        int[] leaves = tree.leafTriangles();
        PlacedTriangles triangles = PlacedTriangles.place(leaves, corners);
        return new KDTree(mesh, tree.nodes(), leaves, triangles, rootBox, tree.depth());
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

    /** What one thread needs to let parts of the tree grow. */
    private final class Grower {
        private final SahSplitFinder splitFinder = new SahSplitFinder();
        private final TriangleClipper clipper = new TriangleClipper(corners);

        Subtree grow(NodeTriangles content, int[] voxel, int level) {
            Subtree tree = new Subtree();
            append(tree, content, voxel, level);
            return tree;
        }

        /** Appends the part of a voxel: its root, all that is left of the split, all that is right of it. */
        private void append(Subtree tree, NodeTriangles content, int[] voxel, int level) {
            if (content.count > WORTH_A_THREAD && Thread.currentThread().isInterrupted()) {
                throw new CancellationException("interrupted while a tree was built");
            }
            Optional<Split> found =
                    level < depthLimit ? splitFinder.find(content.boxes, content.count, voxel) : Optional.empty();
            if (found.isEmpty() || found.get().cost() > SahCost.leaf(content.count)) {
                tree.appendLeaf(content, level);
                return;
            }
            Split split = found.get();
            int[] leftVoxel = voxel.clone();
            leftVoxel[split.axis() + 3] = split.key();
            int[] rightVoxel = voxel.clone();
            rightVoxel[split.axis()] = split.key();
            NodeTriangles left = content.part(split, true, leftVoxel, clipper);
            NodeTriangles right = content.part(split, false, rightVoxel, clipper);

            int parent = tree.reserveNode();
            if (Math.min(left.count, right.count) < WORTH_A_THREAD || Workers.available() == 1) {
                append(tree, left, leftVoxel, level + 1);
                tree.closeInterior(parent, split);
                append(tree, right, rightVoxel, level + 1);
            } else {
                Subtree[] parts = new Subtree[2];
                Workers.both(
                        () -> parts[0] = new Grower().grow(left, leftVoxel, level + 1),
                        () -> parts[1] = new Grower().grow(right, rightVoxel, level + 1));
                tree.append(parts[0]);
                tree.closeInterior(parent, split);
                tree.append(parts[1]);
            }
        }
    }
}
