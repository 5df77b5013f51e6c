package org.dronewatch.geometry;

import java.util.Arrays;

/** A growable list of primitive integers (no boxing). */
public final class Ints {
    private int[] values = new int[1024];
    private int size;

    /** Appends a value. */
    public void add(int value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, size + (size >> 1));
        }
        values[size++] = value;
    }

    /** The value at an index, from 0. */
    public int get(int index) {
        return values[index];
    }

    /** Removes all values. */
    public void clear() {
        size = 0;
    }

    /** The values from one index up to another, exclusive. */
    public int[] copyOfRange(int from, int to) {
        return Arrays.copyOfRange(values, from, to);
    }

    /** How many values there are. */
    public int size() {
        return size;
    }

    /** A copy of the values. */
    public int[] toArray() {
        return Arrays.copyOf(values, size);
    }
}
