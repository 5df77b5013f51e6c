package org.dronewatch.sensor.acoustic.imagesource;

import java.util.Arrays;

/** The walls that a path has met at the point that it has reached: several at an edge or in a corner. */
final class MetWalls {
    private int[] walls = new int[3];
    private int count;

    void clear() {
        count = 0;
    }

    void add(int wall) {
        if (count == walls.length) {
            walls = Arrays.copyOf(walls, 2 * count);
        }
        walls[count++] = wall;
    }

    /** Whether the path has not met a wall yet. */
    boolean isEmpty() {
        return count == 0;
    }

    boolean contains(int wall) {
        for (int i = 0; i < count; i++) {
            if (walls[i] == wall) {
                return true;
            }
        }
        return false;
    }
}
