package org.dronewatch.world;

import java.util.Arrays;

/** A growing list of integers without boxes. */
final class Ints {
    private int[] values = new int[1024];
    private int size;

    void add(int value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, size + (size >> 1));
        }
        values[size++] = value;
    }

    int get(int index) {
        return values[index];
    }

    /** Forgets all values. */
    void clear() {
        size = 0;
    }

    /** The values from one index up to another, which is left out. */
    int[] copyOfRange(int from, int to) {
        return Arrays.copyOfRange(values, from, to);
    }

    int size() {
        return size;
    }

    int[] toArray() {
        return Arrays.copyOf(values, size);
    }
}
