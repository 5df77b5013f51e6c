package org.dronewatch.sensor.acoustic.imagesource;

import java.util.Arrays;

/**
 * The image sources of a point: the point mirrored in a sequence of walls that reflect its sound specularly, one after
 * another. They form a tree: an image is its parent mirrored in one more wall; image 0 is the point itself, and parents
 * come before their children. Sequences of walls are looked up by keys: 64-bit polynomial hashes of the wall numbers.
 * Equal sequences have equal keys, and different sequences are taken to have different keys. Immutable.
 */
public final class ImageSources {
    /** The point itself, which is not mirrored. */
    public static final int ORIGINAL = 0;

    /** The point alone, without images. */
    public static final ImageSources NONE = new ImageSources(new int[1], new int[1]);

    private static final long STEP = 0x9E3779B97F4A7C15L;

    private final int[] parents;
    private final int[] walls;
    private final int[] orders;

    /** The keys of all images but the point itself, in a hash table with open addressing; 0 where a slot is free. */
    private final long[] keys;

    private final int highestOrder;

    /**
     * A tree of image sources.
     *
     * @param parents index of the parent of each image; any number for the first, which is the point itself
     * @param walls the last wall of each image; any number for the first
     */
    public ImageSources(int[] parents, int[] walls) {
        this.parents = parents.clone();
        this.walls = walls.clone();
        this.orders = new int[parents.length];
        long[] found = new long[parents.length];
        for (int image = 1; image < parents.length; image++) {
            orders[image] = orders[parents[image]] + 1;
            found[image] = appended(found[parents[image]], walls[image]);
        }
        // The table is at most half full.
        this.keys = new long[Integer.highestOneBit(Math.max(1, parents.length - 1)) << 2];
        for (int image = 1; image < parents.length; image++) {
            keys[slot(found[image])] = found[image];
        }
        this.highestOrder = Arrays.stream(orders).max().orElse(0);
    }

    /** The image of a point in a sequence of walls, in order from the first, and all its parents. */
    public static ImageSources of(int... sequence) {
        int[] itsParents = new int[sequence.length + 1];
        int[] itsWalls = new int[sequence.length + 1];
        for (int i = 1; i < itsWalls.length; i++) {
            itsParents[i] = i - 1;
            itsWalls[i] = sequence[i - 1];
        }
        return new ImageSources(itsParents, itsWalls);
    }

    /**
     * A subset of these images, with all their parents.
     *
     * @param isKept whether each image is kept
     */
    public ImageSources kept(boolean[] isKept) {
        boolean[] needed = isKept.clone();
        needed[ORIGINAL] = true;
        int count = 1;
        for (int image = parents.length - 1; image > 0; image--) {
            if (needed[image]) {
                needed[parents[image]] = true;
                count++;
            }
        }
        int[] numbers = new int[parents.length];
        int[] itsParents = new int[count];
        int[] itsWalls = new int[count];
        int next = 1;
        for (int image = 1; image < parents.length; image++) {
            if (needed[image]) {
                itsParents[next] = numbers[parents[image]];
                itsWalls[next] = walls[image];
                numbers[image] = next++;
            }
        }
        return new ImageSources(itsParents, itsWalls);
    }

    /** The number of images, the point itself included. */
    public int count() {
        return parents.length;
    }

    /** The parent of an image: mirrored in the image's last wall, it gives the image. */
    public int parent(int image) {
        return parents[image];
    }

    /** The last wall of an image. */
    public int wall(int image) {
        return walls[image];
    }

    /**
     * The first wall of an image: the first to reflect sound from the point itself, or the last to reflect sound to it.
     */
    public int firstWall(int image) {
        int first = image;
        while (parents[first] != ORIGINAL) {
            first = parents[first];
        }
        return walls[first];
    }

    /** The number of walls in which an image is mirrored. */
    public int order(int image) {
        return orders[image];
    }

    /** An image's walls, in order from the first. */
    public int[] walls(int image) {
        int[] sequence = new int[orders[image]];
        for (int rest = image; rest != ORIGINAL; rest = parents[rest]) {
            sequence[orders[rest] - 1] = walls[rest];
        }
        return sequence;
    }

    /** The key of an image's walls in reverse order. */
    public long keyOfReverse(int image) {
        long key = 0L;
        for (int rest = image; rest != ORIGINAL; rest = parents[rest]) {
            key = appended(key, walls[rest]);
        }
        return key;
    }

    /**
     * Whether a sequence of walls is that of one of these images.
     *
     * @param order number of walls, 1 or more
     * @param key key of the sequence, made with {@link #appended} or {@link #prepended}
     */
    public boolean contains(int order, long key) {
        // Most rays have hit more walls than any image has: no search is needed for them.
        return order <= highestOrder && keys[slot(key)] == key;
    }

    /**
     * The slot that holds a key, or the free slot in which the key would be put. Keys are like random numbers, so their
     * last bits suffice as a hash.
     */
    private int slot(long key) {
        int mask = keys.length - 1;
        int slot = (int) key & mask;
        while (keys[slot] != key && keys[slot] != 0L) {
            slot = slot + 1 & mask;
        }
        return slot;
    }

    /** The key of a sequence with one more wall at its end; the key of an empty sequence is 0. */
    public static long appended(long key, int wall) {
        return key * STEP + mixed(wall);
    }

    /**
     * The key of a sequence with one more wall before its first one. Allows the key of a reversed sequence to be formed
     * wall by wall.
     *
     * @param weight power of the hash's multiplier for the length of the sequence: 1 for an empty sequence;
     *     {@link #weightOfNext} gives the weight for one more wall
     */
    public static long prepended(long key, int wall, long weight) {
        return key + mixed(wall) * weight;
    }

    /** The weight for a sequence with one more wall; see {@link #prepended}. */
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

    /**
     * Writes the positions of the images of a point into an array, three coordinates in metres for each image: the
     * point is mirrored in the first wall, the result in the next, and so on.
     */
    public void positions(double x, double y, double z, WallPlanes planes, double[] images) {
        images[0] = x;
        images[1] = y;
        images[2] = z;
        for (int image = 1; image < parents.length; image++) {
            planes.mirror(walls[image], images, 3 * parents[image], images, 3 * image);
        }
    }
}
