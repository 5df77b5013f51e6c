package org.dronewatch.sensor.acoustic.level;

import java.util.Arrays;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;

/** Rays that wait to be traced, first in, first out, in flat arrays; it grows and is reused. One per thread. */
final class RayQueue {
    private static final int NUMBERS = 9;
    private static final int COUNTS = 2;

    private double[] numbers = new double[NUMBERS * 1024];
    private int[] counts = new int[COUNTS * 1024];
    private int added;
    private int taken;

    void clear() {
        added = 0;
        taken = 0;
    }

    /** How many rays were added since the queue was cleared. */
    int added() {
        return added;
    }

    void add(AcousticRay ray) {
        if (NUMBERS * (added + 1) > numbers.length) {
            numbers = Arrays.copyOf(numbers, 2 * numbers.length);
            counts = Arrays.copyOf(counts, 2 * counts.length);
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

    /** Copies the first waiting ray into a carrier; false when none waits. */
    boolean take(AcousticRay ray) {
        if (taken == added) {
            return false;
        }
        int i = NUMBERS * taken;
        ray.originX = numbers[i];
        ray.originY = numbers[i + 1];
        ray.originZ = numbers[i + 2];
        ray.directionX = numbers[i + 3];
        ray.directionY = numbers[i + 4];
        ray.directionZ = numbers[i + 5];
        ray.level = numbers[i + 6];
        ray.energy = numbers[i + 7];
        ray.travelled = numbers[i + 8];
        ray.order = counts[COUNTS * taken];
        ray.medium = counts[COUNTS * taken + 1];
        taken++;
        return true;
    }
}
