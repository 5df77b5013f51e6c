package org.dronewatch.kdtree;

/**
 * The layout of a wide tree in one array of ints; the only file with its offsets. A node holds the boxes of its eight
 * children and where they are; a block holds four triangles. Coordinates are the bits of floats, eight or four side by side,
 * so that one vector takes them all.
 *
 * <pre>
 * node,  64 ints: low x, low y, low z, high x, high y, high z of 8 children, 8 references, 8 spare
 * block, 40 ints: x, y, z of the first, second, third corners of 4 triangles, their 4 numbers
 * reference: place of a node; or, with the sign bit, place of the first block and in the 2 lowest bits how many follow it
 * </pre>
 */
final class WideNode {
    /** Children of a node. */
    static final int WIDTH = 8;

    /** Ints of a node: whole cache lines. */
    static final int NODE = 64;

    /** The first reference in a node. */
    static final int REFERENCES = 6 * WIDTH;

    /** Triangles of a block. */
    static final int TRIANGLES = 4;

    /** The first triangle number in a block. */
    static final int NUMBERS = 9 * TRIANGLES;

    /** Ints of a block. */
    static final int BLOCK = NUMBERS + TRIANGLES;

    /** Blocks of a leaf at most. */
    static final int MOST_BLOCKS = 4;

    /** Where the root is: a header of 16 bytes and 48 more put it at the start of a cache line. */
    static final int ROOT = 12;

    private static final int LEAF = 0x80000000;
    private static final int FOLLOWING = MOST_BLOCKS - 1;

    private WideNode() {}

    /** How many blocks so many triangles fill. */
    static int blocks(int triangles) {
        return (triangles + TRIANGLES - 1) / TRIANGLES;
    }

    /** A reference to blocks. */
    static int leaf(int place, int blocks) {
        return LEAF | place | blocks - 1;
    }

    static boolean isLeaf(int reference) {
        return reference < 0;
    }

    /** Where the first block of a leaf is. */
    static int firstBlock(int leaf) {
        return leaf & ~(LEAF | FOLLOWING);
    }

    /** Where the last block of a leaf is. */
    static int lastBlock(int leaf) {
        return firstBlock(leaf) + (leaf & FOLLOWING) * BLOCK;
    }
}
