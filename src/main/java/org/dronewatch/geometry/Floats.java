package org.dronewatch.geometry;

import java.util.Arrays;

/** A growable list of primitive floats (no boxing). */
public final class Floats {
    private float[] values = new float[1024];
    private int size;

    public void add(float value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, size + (size >> 1));
        }
        values[size++] = value;
    }

    public float get(int index) {
        return values[index];
    }

    /** Removes all values. */
    public void clear() {
        size = 0;
    }

    public int size() {
        return size;
    }

    public float[] toArray() {
        return Arrays.copyOf(values, size);
    }
}
