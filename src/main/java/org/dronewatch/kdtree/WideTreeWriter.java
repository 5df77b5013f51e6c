package org.dronewatch.kdtree;

import java.util.Arrays;

/** Writes a tree of parts as a {@link WideTree}: nodes of eight children, by opening the largest again and again. */
final class WideTreeWriter {
    private final LeafOrderTriangles triangles;
    private final int[] order;
    private int[] pool;
    private int used = WideNode.ROOT;
    private int depth;

    /**
     * For triangles.
     *
     * @param triangles at their places
     * @param order the places as the parts name them
     */
    WideTreeWriter(LeafOrderTriangles triangles, int[] order) {
        this.triangles = triangles;
        this.order = order;
        this.pool = new int[WideNode.ROOT + WideNode.NODE + order.length * WideNode.BLOCK / 2];
    }

    /** The tree whose root holds a part. */
    WideTree write(WidePart root, double reach) {
        emit(root, 1);
        return new WideTree(Arrays.copyOf(pool, used), reach, depth);
    }

    /** Appends a node with all that is below it; gives its place. Its leaves come first, then its other children. */
    private int emit(WidePart part, int level) {
        depth = Math.max(depth, level);
        WidePart[] children = new WidePart[WideNode.WIDTH];
        int number = open(part, children);
        int place = reserve(WideNode.NODE);
        for (int child = 0; child < WideNode.WIDTH; child++) {
            for (int k = 0; k < 6; k++) {
                // A box that no ray meets, in the place of a child that is not there.
                float nothing = k < 3 ? Float.MAX_VALUE : -Float.MAX_VALUE;
                float bound = child < number ? children[child].box[k] : nothing;
                WideNode.setBound(pool, place, k, child, bound);
            }
        }
        for (int child = 0; child < number; child++) {
            if (children[child].isLeaf()) {
                int blocks = appendBlocks(children[child]);
                WideNode.setReference(pool, place, child, blocks);
            }
        }
        for (int child = 0; child < number; child++) {
            if (!children[child].isLeaf()) {
                int node = emit(children[child], level + 1);
                WideNode.setReference(pool, place, child, node);
            }
        }
        return place;
    }

    /** Opens the largest child again and again until there are eight, or only leaves. */
    private static int open(WidePart part, WidePart[] children) {
        children[0] = part;
        int number = 1;
        while (number < WideNode.WIDTH) {
            int largest = -1;
            for (int i = 0; i < number; i++) {
                if (!children[i].isLeaf() && (largest < 0 || children[i].area() > children[largest].area())) {
                    largest = i;
                }
            }
            if (largest < 0) {
                return number;
            }
            WidePart opened = children[largest];
            children[largest] = opened.left;
            children[number++] = opened.right;
        }
        return number;
    }

    private int reserve(int ints) {
        int place = used;
        used += ints;
        if (used > pool.length) {
            pool = Arrays.copyOf(pool, (int) Math.min(Integer.MAX_VALUE - 8L, Math.max(used, 1.5 * pool.length)));
        }
        return place;
    }

    /** Appends a leaf's triangles; places that stay free hold triangles without extent, which no ray hits. */
    private int appendBlocks(WidePart leaf) {
        int size = leaf.to - leaf.from;
        int blocks = Math.max(1, WideNode.blocks(size));
        int first = reserve(blocks * WideNode.BLOCK);
        for (int i = 0; i < size; i++) {
            int block = first + i / WideNode.TRIANGLES * WideNode.BLOCK;
            int lane = i % WideNode.TRIANGLES;
            int place = order[leaf.from + i];
            for (int k = 0; k < 9; k++) {
                WideNode.setCoordinate(pool, block, k, lane, triangles.corners()[9 * place + k]);
            }
            WideNode.setNumber(pool, block, lane, triangles.numbers()[place]);
        }
        return WideNode.leaf(first, blocks);
    }
}
