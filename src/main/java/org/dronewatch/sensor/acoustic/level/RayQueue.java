package org.dronewatch.sensor.acoustic.level;

import java.util.Arrays;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;

/**
 * Rays in the order in which they were added, in flat arrays; it grows and is reused. Written by one thread at a time.
 */
final class RayQueue {
    private static final int NUMBERS = 9;
    private static final int COUNTS = 2;

    private double[] numbers = new double[NUMBERS * 1024];
    private int[] counts = new int[COUNTS * 1024];
    private int added;

    void clear() {
        added = 0;
    }

    /** Removes all rays but the first ones. */
    void shorten(int count) {
        added = count;
    }

    /** The number of rays that were added since the queue was cleared. */
    int added() {
        return added;
    }

    void add(AcousticRay ray) {
        if (NUMBERS * (added + 1) > numbers.length) {
            grow();
        }
        int i = NUMBERS * added;
        numbers[i] = ray.originX;
        numbers[i + 1] = ray.originY;
        numbers[i + 2] = ray.originZ;
        numbers[i + 3] = ray.directionX;
        numbers[i + 4] = ray.directionY;
        numbers[i + 5] = ray.directionZ;
        numbers[i + 6] = ray.level;
        numbers[i + 7] = ray.energy;
        numbers[i + 8] = ray.travelled;
        counts[COUNTS * added] = ray.order;
        counts[COUNTS * added + 1] = ray.medium;
        added++;
    }

    /** Adds the first rays of another queue. */
    void addAll(RayQueue other, int count) {
        while (NUMBERS * (added + count) > numbers.length) {
            grow();
        }
        System.arraycopy(other.numbers, 0, numbers, NUMBERS * added, NUMBERS * count);
        System.arraycopy(other.counts, 0, counts, COUNTS * added, COUNTS * count);
        added += count;
    }

    /** Number of surfaces that a ray has hit. */
    int order(int index) {
        return counts[COUNTS * index];
    }

    private void grow() {
        numbers = Arrays.copyOf(numbers, 2 * numbers.length);
        counts = Arrays.copyOf(counts, 2 * counts.length);
    }

    /** Copies a ray of the queue into the given object. */
    void get(int index, AcousticRay ray) {
        int i = NUMBERS * index;
        ray.originX = numbers[i];
        ray.originY = numbers[i + 1];
        ray.originZ = numbers[i + 2];
        ray.directionX = numbers[i + 3];
        ray.directionY = numbers[i + 4];
        ray.directionZ = numbers[i + 5];
        ray.level = numbers[i + 6];
        ray.energy = numbers[i + 7];
        ray.travelled = numbers[i + 8];
        ray.order = counts[COUNTS * index];
        ray.medium = counts[COUNTS * index + 1];
    }
}
