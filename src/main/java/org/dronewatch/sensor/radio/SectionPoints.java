package org.dronewatch.sensor.radio;

import java.util.Arrays;

/**
 * The points of a section, without duplicates: u along its line and t across it, m. Points that are very close to each
 * other are the same. Allocates only when there are more points than ever before. For use by one thread.
 */
final class SectionPoints {
    private static final int FIRST = 64;

    /** The cells by which points are looked up are this many times as wide as the tolerance. */
    private static final double WIDE = 1000.0;

    private final double tolerance;
    private final double cell;

    private double[] u = new double[FIRST];
    private double[] t = new double[FIRST];
    private int count;

    /** A hash table, at most half full: numbers of points, and the round in which each slot was taken. */
    private int[] slots = new int[2 * FIRST];

    private int[] rounds = new int[2 * FIRST];
    private int round = 1;

    /**
     * No points.
     *
     * @param tolerance within this distance in both coordinates, points are the same, above 0, m
     */
    SectionPoints(double tolerance) {
        this.tolerance = tolerance;
        this.cell = WIDE * tolerance;
    }

    /** Removes all points. */
    void clear() {
        count = 0;
        if (round == Integer.MAX_VALUE) {
            Arrays.fill(rounds, 0);
            round = 0;
        }
        round++;
    }

    /** The number of a point: that of a point that is the same, if there is one, or else the next free number. */
    int number(double along, double across) {
        long lastU = cell(along + tolerance);
        long lastT = cell(across + tolerance);
        for (long cellU = cell(along - tolerance); cellU <= lastU; cellU++) {
            for (long cellT = cell(across - tolerance); cellT <= lastT; cellT++) {
                int slot = slot(cellU, cellT, along, across);
                if (rounds[slot] == round) {
                    return slots[slot];
                }
            }
        }
        if (count == u.length) {
            grow();
        }
        u[count] = along;
        t[count] = across;
        take(slot(cell(along), cell(across), along, across), count);
        return count++;
    }

    private long cell(double coordinate) {
        return (long) Math.floor(coordinate / cell);
    }

    /** The slot of a point that is the same, among those of a cell; otherwise the first free slot of the cell. */
    private int slot(long cellU, long cellT, double along, double across) {
        // Multiplication by the golden ratio spreads the bits (Knuth, The Art of Computer Programming 3, 6.4).
        long spread = (31 * cellU + cellT) * 0x9E3779B97F4A7C15L;
        int slot = (int) (spread >>> Integer.SIZE) & slots.length - 1;
        while (rounds[slot] == round) {
            int there = slots[slot];
            if (Math.abs(u[there] - along) <= tolerance && Math.abs(t[there] - across) <= tolerance) {
                return slot;
            }
            slot = slot + 1 & slots.length - 1;
        }
        return slot;
    }

    private void take(int slot, int point) {
        slots[slot] = point;
        rounds[slot] = round;
    }

    private void grow() {
        u = Arrays.copyOf(u, 2 * count);
        t = Arrays.copyOf(t, 2 * count);
        slots = new int[2 * u.length];
        rounds = new int[slots.length];
        for (int point = 0; point < count; point++) {
            take(slot(cell(u[point]), cell(t[point]), u[point], t[point]), point);
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
