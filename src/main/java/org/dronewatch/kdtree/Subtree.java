package org.dronewatch.kdtree;

import java.util.Arrays;

/**
 * Nodes and leaf lists of a part of a tree while it grows; links and entries are counted from the beginning of the
 * part.
 */
final class Subtree {
    private static final int FIRST_SIZE = 64;

    private long[] nodes = new long[FIRST_SIZE];
    private int nodeCount;
    private int[] leafTriangles = new int[FIRST_SIZE];
    private int leafTriangleCount;
    private int depth;

    /** How many nodes there are: the index of the next. */
    int nodeCount() {
        return nodeCount;
    }

    /** Splits above the deepest leaf, from the root of the whole tree on. */
    int depth() {
        return depth;
    }

    /** Reserves a node that is known later; returns its index. */
    int reserveNode() {
        ensureNodes(1);
        return nodeCount++;
    }

    /** Sets a reserved node whose left child is the next and whose right child is where the next node comes. */
    void closeInterior(int index, Split split) {
        nodes[index] = KDNode.interior(split.axis(), split.key(), nodeCount);
    }

    /** Appends a leaf. */
    void appendLeaf(Cell cell) {
        NodeTriangles content = cell.content();
        ensureNodes(1);
        ensureTriangles(content.count);
        System.arraycopy(content.triangles, 0, leafTriangles, leafTriangleCount, content.count);
        nodes[nodeCount++] = KDNode.leaf(leafTriangleCount, content.count);
        leafTriangleCount += content.count;
        depth = Math.max(depth, cell.level());
    }

    /** Appends another part. */
    void append(Subtree other) {
        ensureNodes(other.nodeCount);
        ensureTriangles(other.leafTriangleCount);
        for (int i = 0; i < other.nodeCount; i++) {
            nodes[nodeCount + i] = KDNode.moved(other.nodes[i], nodeCount, leafTriangleCount);
        }
        System.arraycopy(other.leafTriangles, 0, leafTriangles, leafTriangleCount, other.leafTriangleCount);
        nodeCount += other.nodeCount;
        leafTriangleCount += other.leafTriangleCount;
        depth = Math.max(depth, other.depth);
    }

    private void ensureNodes(int more) {
        if (nodeCount + more > nodes.length) {
            nodes = Arrays.copyOf(nodes, Math.max(2 * nodes.length, nodeCount + more));
        }
    }

    private void ensureTriangles(int more) {
        if (leafTriangleCount + more > leafTriangles.length) {
            leafTriangles = Arrays.copyOf(leafTriangles, Math.max(2 * leafTriangles.length, leafTriangleCount + more));
        }
    }

    /** The packed nodes. */
    long[] nodes() {
        return Arrays.copyOf(nodes, nodeCount);
    }

    /** The triangles of the leaves. */
    int[] leafTriangles() {
        return Arrays.copyOf(leafTriangles, leafTriangleCount);
    }
}
