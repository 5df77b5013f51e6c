package org.dronewatch.geometry;

import java.util.Arrays;

/** A growable list of primitive floats (no boxing). */
public final class Floats {
    private float[] values = new float[1024];
    private int size;

    /** Appends a value. */
    public void add(float value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, size + (size >> 1));
        }
        values[size++] = value;
    }

    /** The value at an index, from 0. */
    public float get(int index) {
        return values[index];
    }

    /** Removes all values. */
    public void clear() {
        size = 0;
    }

    /** How many values there are. */
    public int size() {
        return size;
    }

    /** A copy of the values. */
    public float[] toArray() {
        return Arrays.copyOf(values, size);
    }
}
