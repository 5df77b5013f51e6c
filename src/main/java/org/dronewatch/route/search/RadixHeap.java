package org.dronewatch.route.search;

import java.util.Arrays;

/**
 * A queue of numbers that come out in ascending order of their keys, which are 0 or more; no key that is put in may be
 * less than the last one that was taken out: the radix heap of R. K. Ahuja, K. Mehlhorn, J. B. Orlin and R. E. Tarjan,
 * Journal of the ACM 37 (1990). The bits of doubles of 0 or more are in the order of their values. Not thread-safe.
 */
final class RadixHeap {
    private static final int BUCKETS = 65;
    private static final int FIRST = 16;

    private final long[][] keys = new long[BUCKETS][FIRST];
    private final int[][] values = new int[BUCKETS][FIRST];
    private final int[] sizes = new int[BUCKETS];
    private long last;
    private int size;

    /** Puts in a number with a key, at least that of the last one taken out. */
    void add(double key, int value) {
        put(Double.doubleToRawLongBits(key), value);
        size++;
    }

    private void put(long bits, int value) {
        int bucket = Long.SIZE - Long.numberOfLeadingZeros(bits ^ last);
        int at = sizes[bucket];
        if (at == keys[bucket].length) {
            keys[bucket] = Arrays.copyOf(keys[bucket], 2 * at);
            values[bucket] = Arrays.copyOf(values[bucket], 2 * at);
        }
        keys[bucket][at] = bits;
        values[bucket][at] = value;
        sizes[bucket] = at + 1;
    }

    /** Whether nothing is left. */
    boolean isEmpty() {
        return size == 0;
    }

    /** Takes out a number with the least key; there must be one. */
    int poll() {
        if (sizes[0] == 0) {
            spread();
        }
        size--;
        return values[0][--sizes[0]];
    }

    /** The key of the number that was taken out last. */
    double key() {
        return Double.longBitsToDouble(last);
    }

    /** Distributes the first bucket that is not empty over those before it. */
    private void spread() {
        int bucket = 1;
        while (sizes[bucket] == 0) {
            bucket++;
        }
        int count = sizes[bucket];
        long least = keys[bucket][0];
        for (int i = 1; i < count; i++) {
            least = Math.min(least, keys[bucket][i]);
        }
        last = least;
        sizes[bucket] = 0;
        for (int i = 0; i < count; i++) {
            put(keys[bucket][i], values[bucket][i]);
        }
    }
}
