package org.dronewatch.bvh;

/**
 * The layout of the BVH in one array of ints; no other class knows its offsets. A node holds the boxes of its eight
 * children and references to them; a block holds four triangles. Coordinates are the bits of floats, eight or four side
 * by side, so that one vector takes them all.
 *
 * <pre>
 * node,  64 ints: low x, low y, low z, high x, high y, high z of 8 children, 8 references, 8 spare
 * block, 40 ints: x, y, z of the first, second, third corners of 4 triangles, their 4 numbers
 * reference: index of a node; or, with the sign bit, index of the first block, and in the 2 lowest bits how many follow
 * it
 * </pre>
 */
final class BvhNode {
    /** Children of a node. */
    static final int WIDTH = 8;

    /** Ints of a node: whole cache lines. */
    static final int NODE = 64;

    /** Triangles of a block. */
    static final int TRIANGLES = 4;

    /** Ints from the coordinates of a corner of a block's triangles to those of the next corner. */
    static final int CORNER = 3 * TRIANGLES;

    /** Ints from a block to its triangles' numbers. */
    static final int NUMBERS = 9 * TRIANGLES;

    /** Ints of a block. */
    static final int BLOCK = 10 * TRIANGLES;

    /** Maximum number of blocks of a leaf. */
    static final int MOST_BLOCKS = 4;

    /** Index of the root: the array's header of 16 bytes and 48 bytes more put it at the start of a cache line. */
    static final int ROOT = 12;

    /** The reference to nothing. */
    static final int NONE = 0;

    private static final int REFERENCES = 6 * WIDTH;
    private static final int LEAF = 0x80000000;
    private static final int FOLLOWING = MOST_BLOCKS - 1;

    private BvhNode() {}

    /** Ints from a node to the lower bounds of its children on an axis. */
    static int lower(int axis) {
        return axis * WIDTH;
    }

    /** Ints from a node to the upper bounds of its children on an axis. */
    static int upper(int axis) {
        return (3 + axis) * WIDTH;
    }

    /** A bound of a child: 0 to 2 the lower ones on the axes, 3 to 5 the upper ones. */
    static float bound(int[] pool, int node, int bound, int child) {
        return Float.intBitsToFloat(pool[node + bound * WIDTH + child]);
    }

    static void setBound(int[] pool, int node, int bound, int child, float value) {
        pool[node + bound * WIDTH + child] = Float.floatToRawIntBits(value);
    }

    /** The reference to a child. */
    static int reference(int[] pool, int node, int child) {
        return pool[node + REFERENCES + child];
    }

    static void setReference(int[] pool, int node, int child, int reference) {
        pool[node + REFERENCES + child] = reference;
    }

    /** How many blocks hold a number of triangles. */
    static int blocks(int triangles) {
        return (triangles + TRIANGLES - 1) / TRIANGLES;
    }

    /**
     * A reference to blocks.
     *
     * @param first index of the first
     * @param blocks how many, 1 to {@link #MOST_BLOCKS}
     */
    static int leaf(int first, int blocks) {
        if (first <= 0 || (first & FOLLOWING) != 0 || blocks < 1 || blocks > MOST_BLOCKS) {
            throw new IllegalArgumentException("leaf of " + blocks + " blocks from " + first);
        }
        return LEAF | first | blocks - 1;
    }

    static boolean isLeaf(int reference) {
        return reference < 0;
    }

    /** Index of the first block of a leaf. */
    static int firstBlock(int leaf) {
        return leaf & ~(LEAF | FOLLOWING);
    }

    /** Index of the last block of a leaf. */
    static int lastBlock(int leaf) {
        return firstBlock(leaf) + (leaf & FOLLOWING) * BLOCK;
    }

    /** Ints from a block to its triangles' coordinates on an axis, of their first corners. */
    static int coordinates(int axis) {
        return axis * TRIANGLES;
    }

    /** A coordinate of a triangle of a block: 0 to 8, corner by corner. */
    static float coordinate(int[] pool, int block, int coordinate, int triangle) {
        return Float.intBitsToFloat(pool[block + coordinate * TRIANGLES + triangle]);
    }

    static void setCoordinate(int[] pool, int block, int coordinate, int triangle, float value) {
        pool[block + coordinate * TRIANGLES + triangle] = Float.floatToRawIntBits(value);
    }

    /** The number in the mesh of a triangle of a block. */
    static int number(int[] pool, int block, int triangle) {
        return pool[block + NUMBERS + triangle];
    }

    static void setNumber(int[] pool, int block, int triangle, int number) {
        pool[block + NUMBERS + triangle] = number;
    }
}
