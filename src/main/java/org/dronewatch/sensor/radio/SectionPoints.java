package org.dronewatch.sensor.radio;

import java.util.Arrays;

/**
 * The points of a section, without duplicates: u along its line and t across it, m. Points are the same only if their
 * coordinates are equal to the last bit. Allocates only when there are more points than ever before. For use by one
 * thread.
 */
final class SectionPoints {
    private static final int FIRST = 64;

    private double[] u = new double[FIRST];
    private double[] t = new double[FIRST];
    private int count;

    /** A hash table, at most half full: numbers of points, and the round in which each slot was taken. */
    private int[] slots = new int[2 * FIRST];

    private int[] rounds = new int[2 * FIRST];
    private int round = 1;

    /** Removes all points. */
    void clear() {
        count = 0;
        if (round == Integer.MAX_VALUE) {
            Arrays.fill(rounds, 0);
            round = 0;
        }
        round++;
    }

    /** The number of a point: that of an equal point if there is one, or else the next free number. */
    int number(double along, double across) {
        // Without negative zeros, equal numbers have equal bits.
        double uThere = along + 0.0;
        double tThere = across + 0.0;
        int slot = slot(uThere, tThere);
        while (rounds[slot] == round) {
            int there = slots[slot];
            if (u[there] == uThere && t[there] == tThere) {
                return there;
            }
            slot = slot + 1 & slots.length - 1;
        }
        if (count == u.length) {
            grow();
            return number(along, across);
        }
        u[count] = uThere;
        t[count] = tThere;
        take(slot, count);
        return count++;
    }

    private void take(int slot, int point) {
        slots[slot] = point;
        rounds[slot] = round;
    }

    private int slot(double along, double across) {
        long bits = 31 * Double.doubleToRawLongBits(along) + Double.doubleToRawLongBits(across);
        // Multiplication by the golden ratio spreads the bits (Knuth, The Art of Computer Programming 3, 6.4).
        long spread = bits * 0x9E3779B97F4A7C15L;
        return (int) (spread >>> Integer.SIZE) & slots.length - 1;
    }

    private void grow() {
        u = Arrays.copyOf(u, 2 * count);
        t = Arrays.copyOf(t, 2 * count);
        slots = new int[2 * u.length];
        rounds = new int[slots.length];
        for (int point = 0; point < count; point++) {
            int slot = slot(u[point], t[point]);
            while (rounds[slot] == round) {
                slot = slot + 1 & slots.length - 1;
            }
            take(slot, point);
        }
    }

    int count() {
        return count;
    }

    double u(int point) {
        return u[point];
    }

    double t(int point) {
        return t[point];
    }
}
