package org.dronewatch.bvh;

import java.util.Arrays;
import org.dronewatch.kdtree.LeafOrderTriangles;

/** Writes a tree of parts as a {@link Bvh}: nodes of eight children, by repeatedly opening the largest child. */
final class BvhWriter {
    private final LeafOrderTriangles triangles;
    private final int[] order;
    private int[] pool;
    private int used = BvhNode.ROOT;
    private int depth;

    /**
     * A writer of the tree over triangles.
     *
     * @param triangles in leaf order
     * @param order their indices, part by part
     */
    BvhWriter(LeafOrderTriangles triangles, int[] order) {
        this.triangles = triangles;
        this.order = order;
        this.pool = new int[BvhNode.ROOT + BvhNode.NODE + order.length * BvhNode.BLOCK / 2];
    }

    /** The tree whose root holds a part. */
    Bvh write(BvhPart root, double reach) {
        emit(root, 1);
        return new Bvh(Arrays.copyOf(pool, used), reach, depth);
    }

    /** Appends a node and all below it; returns its index. Its leaves come first, then its other children. */
    private int emit(BvhPart part, int level) {
        depth = Math.max(depth, level);
        BvhPart[] children = new BvhPart[BvhNode.WIDTH];
        int number = open(part, children);
        int index = reserve(BvhNode.NODE);
        for (int child = 0; child < BvhNode.WIDTH; child++) {
            for (int k = 0; k < 6; k++) {
                // A box that no ray hits, where there is no child.
                float nothing = k < 3 ? Float.MAX_VALUE : -Float.MAX_VALUE;
                float bound = child < number ? children[child].box[k] : nothing;
                BvhNode.setBound(pool, index, k, child, bound);
            }
        }
        for (int child = 0; child < number; child++) {
            if (children[child].isLeaf()) {
                int blocks = appendBlocks(children[child]);
                BvhNode.setReference(pool, index, child, blocks);
            }
        }
        for (int child = 0; child < number; child++) {
            if (!children[child].isLeaf()) {
                int node = emit(children[child], level + 1);
                BvhNode.setReference(pool, index, child, node);
            }
        }
        return index;
    }

    /** Opens the largest child repeatedly until there are eight, or only leaves. */
    private static int open(BvhPart part, BvhPart[] children) {
        children[0] = part;
        int number = 1;
        while (number < BvhNode.WIDTH) {
            int largest = -1;
            for (int i = 0; i < number; i++) {
                if (!children[i].isLeaf() && (largest < 0 || children[i].area() > children[largest].area())) {
                    largest = i;
                }
            }
            if (largest < 0) {
                return number;
            }
            BvhPart opened = children[largest];
            children[largest] = opened.left;
            children[number++] = opened.right;
        }
        return number;
    }

    private int reserve(int ints) {
        int first = used;
        used += ints;
        if (used > pool.length) {
            pool = Arrays.copyOf(pool, (int) Math.min(Integer.MAX_VALUE - 8L, Math.max(used, 1.5 * pool.length)));
        }
        return first;
    }

    /** Appends a leaf's triangles; unused lanes hold triangles without extent, which no ray hits. */
    private int appendBlocks(BvhPart leaf) {
        int size = leaf.to - leaf.from;
        int blocks = Math.max(1, BvhNode.blocks(size));
        int first = reserve(blocks * BvhNode.BLOCK);
        for (int i = 0; i < size; i++) {
            int block = first + i / BvhNode.TRIANGLES * BvhNode.BLOCK;
            int lane = i % BvhNode.TRIANGLES;
            int index = order[leaf.from + i];
            for (int k = 0; k < 9; k++) {
                BvhNode.setCoordinate(pool, block, k, lane, triangles.corners()[9 * index + k]);
            }
            BvhNode.setNumber(pool, block, lane, triangles.numbers()[index]);
        }
        return BvhNode.leaf(first, blocks);
    }
}
