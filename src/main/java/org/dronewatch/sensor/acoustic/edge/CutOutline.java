package org.dronewatch.sensor.acoustic.edge;

import java.util.Arrays;

/**
 * The outline of obstacles in a plane: straight pieces in coordinates u along a line and v across it. Pieces that end
 * at about the same coordinates share a point. For use by one thread.
 */
final class CutOutline {
    private double[] u = new double[256];
    private double[] v = new double[256];

    /** Whether the mesh has a corner or an edge at a point; the other points divide bent pieces. */
    private boolean[] isOfMesh = new boolean[256];

    private Cone[] cones = new Cone[0];
    private int points;
    private int[] ends = new int[512];
    private int pieces;

    /** Within this distance in both coordinates, points are the same, m. */
    private final double tolerance;

    /** The cells by which points are looked up are as wide as this, m: hardly any point is near a border. */
    private final double cell;

    /**
     * A hash table of the cells of all points, with open addressing: each slot holds one more than the index of a
     * point, or 0 if it is free.
     */
    private int[] table = new int[1024];

    /**
     * An outline without pieces.
     *
     * @param tolerance within this distance in both coordinates, points are the same, above 0, m
     */
    CutOutline(double tolerance) {
        this.tolerance = tolerance;
        this.cell = 1000.0 * tolerance;
    }

    /** Removes all pieces, and makes room for at most this many points of the mesh. */
    void clear(int most) {
        points = 0;
        pieces = 0;
        int slots = Math.max(16, Integer.highestOneBit(Math.max(1, most)) * 4);
        if (table.length != slots) {
            table = new int[slots];
        } else {
            Arrays.fill(table, 0);
        }
    }

    /** The point of the mesh at given coordinates: a known one, or a new one. */
    int point(double atU, double atV) {
        long lastU = cell(atU + tolerance);
        long lastV = cell(atV + tolerance);
        for (long cellU = cell(atU - tolerance); cellU <= lastU; cellU++) {
            for (long cellV = cell(atV - tolerance); cellV <= lastV; cellV++) {
                int known = table[slot(cellU, cellV, atU, atV)] - 1;
                if (known >= 0) {
                    return known;
                }
            }
        }
        table[slot(cell(atU), cell(atV), atU, atV)] = points + 1;
        return append(atU, atV, true);
    }

    private long cell(double coordinate) {
        return (long) Math.floor(coordinate / cell);
    }

    /** The slot of a point that is known, among those of a cell; otherwise the first free slot of the cell. */
    private int slot(long cellU, long cellV, double atU, double atV) {
        long bits = cellU * 0x9E3779B97F4A7C15L + cellV;
        bits *= 0xC2B2AE3D27D4EB4FL;
        int slot = (int) (bits >>> 32) & (table.length - 1);
        while (table[slot] != 0) {
            int known = table[slot] - 1;
            if (Math.abs(u[known] - atU) <= tolerance && Math.abs(v[known] - atV) <= tolerance) {
                return slot;
            }
            slot = (slot + 1) & (table.length - 1);
        }
        return slot;
    }

    /** A new point at which a piece is divided, where the mesh has neither a corner nor an edge. */
    int dividingPoint(double atU, double atV) {
        return append(atU, atV, false);
    }

    private int append(double atU, double atV, boolean ofMesh) {
        if (points == u.length) {
            u = Arrays.copyOf(u, 2 * points);
            v = Arrays.copyOf(v, 2 * points);
            isOfMesh = Arrays.copyOf(isOfMesh, 2 * points);
        }
        u[points] = atU;
        v[points] = atV;
        isOfMesh[points] = ofMesh;
        return points++;
    }

    /** Adds a piece between two points, unless they are the same. */
    void add(int start, int end) {
        if (start == end) {
            return;
        }
        if (2 * pieces == ends.length) {
            ends = Arrays.copyOf(ends, 2 * ends.length);
        }
        ends[2 * pieces] = start;
        ends[2 * pieces + 1] = end;
        pieces++;
    }

    /** Collects the directions of the pieces at each point; to be called once all pieces have been added. */
    void finish() {
        int known = cones.length;
        if (known < points) {
            cones = Arrays.copyOf(cones, 2 * points);
            for (int i = known; i < cones.length; i++) {
                cones[i] = new Cone();
            }
        }
        for (int i = 0; i < points; i++) {
            cones[i].clear();
        }
        for (int i = 0; i < pieces; i++) {
            int a = ends[2 * i];
            int b = ends[2 * i + 1];
            double du = u[b] - u[a];
            double dv = v[b] - v[a];
            double length = Math.sqrt(du * du + dv * dv);
            cones[a].add(du / length, dv / length);
            cones[b].add(-du / length, -dv / length);
        }
    }

    /** The number of points at which pieces end. */
    int points() {
        return points;
    }

    double u(int point) {
        return u[point];
    }

    double v(int point) {
        return v[point];
    }

    /** Whether the mesh has a corner or an edge at a point, rather than a piece having been divided there. */
    boolean isOfMesh(int point) {
        return isOfMesh[point];
    }

    /** The directions of the pieces that meet at a point. */
    Cone cone(int point) {
        return cones[point];
    }

    /** Number of pieces. */
    int pieces() {
        return pieces;
    }

    /** The point at which a piece begins. */
    int start(int piece) {
        return ends[2 * piece];
    }

    /** The point at which a piece ends. */
    int end(int piece) {
        return ends[2 * piece + 1];
    }
}
