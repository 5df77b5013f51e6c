package org.dronewatch.kdtree;

import java.util.Arrays;
import java.util.Optional;
import org.dronewatch.geometry.TriangleMesh;

/**
 * Builds a tree top down: split where {@link SahSplitFinder} says, stop when no split is cheaper than a leaf. Follows
 * Wald and Havran (2006) in O(n log² n): the events are sorted anew in each node, as plain integers.
 */
final class KDTreeBuilder {
    private static final int BOX = SahSplitFinder.BOX;

    private final TriangleMesh mesh;
    private final float[] corners;
    private final SahSplitFinder splitFinder = new SahSplitFinder();
    private final TriangleClipper clipper;
    private final int depthLimit;

    private long[] nodes = new long[64];
    private int nodeCount;
    private int[] leafTriangles = new int[64];
    private int leafTriangleCount;
    private int depth;

    KDTreeBuilder(TriangleMesh mesh) {
        this.mesh = mesh;
        this.corners = flatten(mesh);
        this.clipper = new TriangleClipper(corners);
        this.depthLimit = depthLimit(mesh.triangleCount());
    }

    /** The depth at which splitting ends whatever it costs: bounds what degenerate input can do. */
    static int depthLimit(int triangles) {
        return (int) (8.0 + 1.3 * Math.log(Math.max(1, triangles)) / Math.log(2.0));
    }

    KDTree build() {
        int count = mesh.triangleCount();
        float[] rootBox = new float[BOX];
        if (count == 0) {
            appendLeaf(new int[0], 0);
        } else {
            int[] triangles = new int[count];
            int[] boxes = new int[BOX * count];
            for (int i = 0; i < count; i++) {
                triangles[i] = i;
                writeBox(i, boxes);
            }
            int[] voxel = unionOf(boxes, count);
            for (int k = 0; k < BOX; k++) {
                rootBox[k] = KDNode.value(voxel[k]);
            }
            append(new NodeTriangles(triangles, boxes, count), voxel, 0);
        }
        return new KDTree(
                mesh,
                Arrays.copyOf(nodes, nodeCount),
                Arrays.copyOf(leafTriangles, leafTriangleCount),
                corners,
                rootBox,
                depth);
    }

    /** Appends the subtree of a voxel: its root, all of the left part, all of the right part. */
    private void append(NodeTriangles content, int[] voxel, int level) {
        depth = Math.max(depth, level);
        Optional<Split> found =
                level < depthLimit ? splitFinder.find(content.boxes, content.count, voxel) : Optional.empty();
        if (found.isEmpty() || found.get().cost() > SahCost.leaf(content.count)) {
            appendLeaf(content.triangles, content.count);
            return;
        }
        Split split = found.get();
        int[] leftVoxel = voxel.clone();
        leftVoxel[split.axis() + 3] = split.key();
        int[] rightVoxel = voxel.clone();
        rightVoxel[split.axis()] = split.key();
        NodeTriangles left = part(content, split, true, leftVoxel);
        NodeTriangles right = part(content, split, false, rightVoxel);

        int parent = reserveNode();
        append(left, leftVoxel, level + 1);
        nodes[parent] = KDNode.interior(split.axis(), split.key(), nodeCount);
        append(right, rightVoxel, level + 1);
    }

    /** The triangles on one side of a split; those that cross it are clipped to the part's voxel. */
    private NodeTriangles part(NodeTriangles whole, Split split, boolean leftPart, int[] voxel) {
        int expected = 0;
        for (int i = 0; i < whole.count; i++) {
            expected += whole.isIn(i, split, leftPart) ? 1 : 0;
        }
        NodeTriangles part = new NodeTriangles(new int[expected], new int[BOX * expected], 0);
        for (int i = 0; i < whole.count; i++) {
            if (!whole.isIn(i, split, leftPart)) {
                continue;
            }
            boolean crosses = whole.isIn(i, split, !leftPart);
            int slot = BOX * part.count;
            if (!crosses) {
                System.arraycopy(whole.boxes, BOX * i, part.boxes, slot, BOX);
            } else if (!clipper.clip(whole.triangles[i], voxel, part.boxes, slot)) {
                continue;
            }
            part.triangles[part.count++] = whole.triangles[i];
        }
        return part;
    }

    private int reserveNode() {
        if (nodeCount == nodes.length) {
            nodes = Arrays.copyOf(nodes, 2 * nodes.length);
        }
        return nodeCount++;
    }

    private void appendLeaf(int[] triangles, int count) {
        int node = reserveNode();
        if (leafTriangleCount + count > leafTriangles.length) {
            leafTriangles = Arrays.copyOf(leafTriangles, Math.max(2 * leafTriangles.length, leafTriangleCount + count));
        }
        System.arraycopy(triangles, 0, leafTriangles, leafTriangleCount, count);
        nodes[node] = KDNode.leaf(leafTriangleCount, count);
        leafTriangleCount += count;
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

    private static int[] unionOf(int[] boxes, int count) {
        int[] union = Arrays.copyOf(boxes, BOX);
        for (int i = 1; i < count; i++) {
            for (int axis = 0; axis < 3; axis++) {
                union[axis] = Math.min(union[axis], boxes[BOX * i + axis]);
                union[axis + 3] = Math.max(union[axis + 3], boxes[BOX * i + axis + 3]);
            }
        }
        return union;
    }

    /** The triangles of a voxel with their clipped boxes. */
    private static final class NodeTriangles {
        final int[] triangles;
        final int[] boxes;
        int count;

        NodeTriangles(int[] triangles, int[] boxes, int count) {
            this.triangles = triangles;
            this.boxes = boxes;
            this.count = count;
        }

        boolean isIn(int i, Split split, boolean left) {
            int low = boxes[BOX * i + split.axis()];
            int high = boxes[BOX * i + split.axis() + 3];
            return left ? split.isLeft(low, high) : split.isRight(low, high);
        }
    }
}
