package org.dronewatch.buildings.io;

import java.util.Arrays;

/** Maps identifiers of nodes to the indices at which the nodes are kept, without an object for each. */
final class LongIndex {
    private static final long MIX = 0x9E3779B97F4A7C15L;

    private long[] keys = new long[1 << 10];
    private int[] values = new int[1 << 10];
    private int size;

    LongIndex() {
        Arrays.fill(values, -1);
    }

    int size() {
        return size;
    }

    /** The number of a key, -1 for one that is not known. */
    int get(long key) {
        return values[slot(key)];
    }

    /** Sets the number of a key, 0 or more. */
    void put(long key, int value) {
        int slot = slot(key);
        if (values[slot] < 0) {
            size++;
        }
        keys[slot] = key;
        values[slot] = value;
        if (2 * size > keys.length) {
            grow();
        }
    }

    private int slot(long key) {
        int mask = keys.length - 1;
        int slot = (int) (key * MIX >>> 32) & mask;
        while (values[slot] >= 0 && keys[slot] != key) {
            slot = slot + 1 & mask;
        }
        return slot;
    }

    private void grow() {
        long[] oldKeys = keys;
        int[] oldValues = values;
        keys = new long[2 * oldKeys.length];
        values = new int[2 * oldKeys.length];
        Arrays.fill(values, -1);
        for (int i = 0; i < oldKeys.length; i++) {
            if (oldValues[i] >= 0) {
                int slot = slot(oldKeys[i]);
                keys[slot] = oldKeys[i];
                values[slot] = oldValues[i];
            }
        }
    }
}
