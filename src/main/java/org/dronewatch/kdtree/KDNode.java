package org.dronewatch.kdtree;

/**
 * A packed node of a kd-tree: one 64-bit word, whose layout is private to this class.
 *
 * <pre>
 *   63 ........ 34 | 33 .. 32 | 31 |  30 ........ 0
 *   30 bits        |  2 bits  | 0  |  31 bits
 *   split value    |  axis    |    |  right child          interior; the left child is the next word
 *   count          |  3       |    |  first leaf entry     leaf
 * </pre>
 *
 * With 30 bits, a float loses its two lowest mantissa bits. Planes must therefore lie on a grid of floats whose two
 * lowest bits are zero. This class numbers that grid in ascending order, so that the builder can round before it
 * compares and never compares a plane that it cannot store.
 *
 * <p>Public for the library's other ray-tracing packages (bvh and raster), which read nodes; only this package packs
 * them.
 */
public final class KDNode {
    /** The kind of a leaf; kinds 0 to 2 are the split axis of an interior node. */
    public static final int LEAF = 3;
    /** The largest number of triangles in a leaf. */
    static final int MAX_COUNT = (1 << 30) - 1;

    private static final int KIND_MASK = 3;
    private static final int HIGH = 32;
    private static final long LOW_WORD = 0xffffffffL;

    private KDNode() {}

    /**
     * Packs an interior node.
     *
     * @param axis 0, 1 or 2
     * @param splitKey number of the split plane on the grid
     * @param rightChild word index of the right child
     */
    static long interior(int axis, int splitKey, int rightChild) {
        if (axis < 0 || axis >= LEAF || rightChild <= 0) {
            throw new IllegalArgumentException("interior node of axis " + axis + ", right child " + rightChild);
        }
        return (long) (Float.floatToRawIntBits(value(splitKey)) | axis) << HIGH | rightChild;
    }

    /**
     * Packs a leaf.
     *
     * @param first index of its first triangle in the leaf list
     * @param count how many triangles it has, 0 to {@link #MAX_COUNT}
     */
    static long leaf(int first, int count) {
        if (first < 0 || count < 0 || count > MAX_COUNT) {
            throw new IllegalArgumentException("leaf of " + count + " triangles from entry " + first);
        }
        return (long) (count << 2 | LEAF) << HIGH | first;
    }

    /**
     * The same node in a tree that begins earlier.
     *
     * @param nodes how many words come before what was the first
     * @param entries how many leaf entries come before what was the first
     */
    static long moved(long node, int nodes, int entries) {
        return kind(node) == LEAF
                ? leaf(Math.addExact(first(node), entries), count(node))
                : node & ~LOW_WORD | Math.addExact(rightChild(node), nodes);
    }

    /** The split axis, or {@link #LEAF}. */
    public static int kind(long node) {
        return (int) (node >>> HIGH) & KIND_MASK;
    }

    /** The coordinate of an interior node's split plane. */
    public static float split(long node) {
        return Float.intBitsToFloat((int) (node >>> HIGH) & ~KIND_MASK);
    }

    /** The word index of the left child of the interior node at an index. */
    public static int leftChild(int index) {
        return index + 1;
    }

    /** The word index of an interior node's right child. */
    public static int rightChild(long node) {
        return (int) node;
    }

    /** Index of a leaf's first triangle in the leaf list. */
    public static int first(long node) {
        return (int) node;
    }

    /** The number of triangles of a leaf. */
    public static int count(long node) {
        return (int) (node >>> (HIGH + 2));
    }

    /** The number of the largest grid value at or below a coordinate. */
    static int floorKey(double coordinate) {
        float rounded = (float) coordinate;
        return ordered(rounded > coordinate ? Math.nextDown(rounded) : rounded) >> 2;
    }

    /** The number of the smallest grid value at or above a coordinate. */
    static int ceilKey(double coordinate) {
        float rounded = (float) coordinate;
        return (ordered(rounded < coordinate ? Math.nextUp(rounded) : rounded) + 3) >> 2;
    }

    /** The grid value of a number. */
    static float value(int key) {
        int ordered = key << 2;
        return Float.intBitsToFloat(ordered >= 0 ? ordered : Integer.MIN_VALUE | -ordered);
    }

    /** Maps floats to integers of the same order; both zeros become 0. */
    private static int ordered(float coordinate) {
        int bits = Float.floatToRawIntBits(coordinate);
        return bits >= 0 ? bits : Integer.MIN_VALUE - bits;
    }

    /** An event of the sweep, sorted by plane first and then by kind: see {@link SahSplitFinder}. */
    static int event(int key, int type) {
        return key << 2 | type;
    }

    /** The plane of an event. */
    static int eventKey(int event) {
        return event >> 2;
    }

    /** The kind of an event. */
    static int eventType(int event) {
        return event & 3;
    }
}
