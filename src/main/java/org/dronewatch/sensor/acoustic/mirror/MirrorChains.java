package org.dronewatch.sensor.acoustic.mirror;

import java.util.Arrays;

/**
 * Sequences of walls over which sound that leaves a point is reflected specularly, one after another. They form a tree:
 * a chain is its parent and one more wall; chain 0 is empty, and parents come before their children. Immutable.
 */
public final class MirrorChains {
    /** The chain without walls. */
    public static final int EMPTY = 0;

    /** No chain but the empty one. */
    public static final MirrorChains NONE = new MirrorChains(new int[1], new int[1]);

    private static final long STEP = 0x9E3779B97F4A7C15L;

    private final int[] parents;
    private final int[] walls;
    private final int[] orders;

    /** The keys of all chains but the empty one, in a hash table with open addressing; 0 where a slot is free. */
    private final long[] keys;

    private final int highestOrder;

    /**
     * Chains.
     *
     * @param parents of each chain; of the first, which is empty, any
     * @param walls the last wall of each chain; of the first, any
     */
    public MirrorChains(int[] parents, int[] walls) {
        this.parents = parents.clone();
        this.walls = walls.clone();
        this.orders = new int[parents.length];
        long[] found = new long[parents.length];
        for (int chain = 1; chain < parents.length; chain++) {
            orders[chain] = orders[parents[chain]] + 1;
            found[chain] = appended(found[parents[chain]], walls[chain]);
        }
        // At most half full.
        this.keys = new long[Integer.highestOneBit(Math.max(1, parents.length - 1)) << 2];
        for (int chain = 1; chain < parents.length; chain++) {
            keys[slot(found[chain])] = found[chain];
        }
        this.highestOrder = Arrays.stream(orders).max().orElse(0);
    }

    /** A sequence of walls, the first one first, and all chains that it begins with. */
    public static MirrorChains of(int... sequence) {
        int[] itsParents = new int[sequence.length + 1];
        int[] itsWalls = new int[sequence.length + 1];
        for (int i = 1; i < itsWalls.length; i++) {
            itsParents[i] = i - 1;
            itsWalls[i] = sequence[i - 1];
        }
        return new MirrorChains(itsParents, itsWalls);
    }

    /**
     * Some of these chains, and all chains that they begin with.
     *
     * @param isKept for each chain whether it is
     */
    public MirrorChains kept(boolean[] isKept) {
        boolean[] needed = isKept.clone();
        needed[EMPTY] = true;
        int count = 1;
        for (int chain = parents.length - 1; chain > 0; chain--) {
            if (needed[chain]) {
                needed[parents[chain]] = true;
                count++;
            }
        }
        int[] numbers = new int[parents.length];
        int[] itsParents = new int[count];
        int[] itsWalls = new int[count];
        int next = 1;
        for (int chain = 1; chain < parents.length; chain++) {
            if (needed[chain]) {
                itsParents[next] = numbers[parents[chain]];
                itsWalls[next] = walls[chain];
                numbers[chain] = next++;
            }
        }
        return new MirrorChains(itsParents, itsWalls);
    }

    /** The number of chains, the empty one included. */
    public int count() {
        return parents.length;
    }

    /** The chain without its last wall. */
    public int parent(int chain) {
        return parents[chain];
    }

    /** The last wall of a chain. */
    public int wall(int chain) {
        return walls[chain];
    }

    /** How many walls a chain has. */
    public int order(int chain) {
        return orders[chain];
    }

    /** A chain's walls, the first one first. */
    public int[] walls(int chain) {
        int[] sequence = new int[orders[chain]];
        for (int rest = chain; rest != EMPTY; rest = parents[rest]) {
            sequence[orders[rest] - 1] = walls[rest];
        }
        return sequence;
    }

    /** The key of a chain's walls in the reverse order. */
    public long keyOfReverse(int chain) {
        long key = 0L;
        for (int rest = chain; rest != EMPTY; rest = parents[rest]) {
            key = appended(key, walls[rest]);
        }
        return key;
    }

    /**
     * Whether a sequence of walls is one of these chains.
     *
     * @param order how many walls, 1 or more
     * @param key of the sequence
     */
    public boolean contains(int order, long key) {
        // Rays have mostly hit more walls than any chain has: they need no search.
        return order <= highestOrder && keys[slot(key)] == key;
    }

    /** Where a key is, or the free slot where it would be. Keys are random numbers: their last bits will do. */
    private int slot(long key) {
        int mask = keys.length - 1;
        int slot = (int) key & mask;
        while (keys[slot] != key && keys[slot] != 0L) {
            slot = slot + 1 & mask;
        }
        return slot;
    }

    /** The key of a sequence with one more wall at its end; that of the empty one is 0. */
    public static long appended(long key, int wall) {
        return key * STEP + mixed(wall);
    }

    /**
     * The key of a sequence with one more wall before its first: so a sequence is known by the key of its reverse.
     *
     * @param weight of a sequence of this length: 1 for the empty one, {@link #weightOfNext} for each wall
     */
    public static long prepended(long key, int wall, long weight) {
        return key + mixed(wall) * weight;
    }

    /** See {@link #prepended}. */
    public static long weightOfNext(long weight) {
        return weight * STEP;
    }

    /** The finalizer of SplitMix64 (Steele, Lea and Flood, OOPSLA 2014): different walls have unrelated numbers. */
    private static long mixed(int wall) {
        long z = (wall + 1L) * STEP;
        z = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
        z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
        return z ^ (z >>> 31);
    }

    /** The image of a point in each chain, three coordinates each: the point mirrored in the first wall, then in the next. */
    public void images(double x, double y, double z, WallPlanes planes, double[] images) {
        images[0] = x;
        images[1] = y;
        images[2] = z;
        for (int chain = 1; chain < parents.length; chain++) {
            planes.mirror(walls[chain], images, 3 * parents[chain], images, 3 * chain);
        }
    }
}
