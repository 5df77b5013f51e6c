package org.dronewatch.world;

import java.util.Arrays;

/** A growing list of floats without boxes. */
final class Floats {
    private float[] values = new float[1024];
    private int size;

    void add(float value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, size + (size >> 1));
        }
        values[size++] = value;
    }

    float get(int index) {
        return values[index];
    }

    /** Forgets all values. */
    void clear() {
        size = 0;
    }

    int size() {
        return size;
    }

    float[] toArray() {
        return Arrays.copyOf(values, size);
    }
}
