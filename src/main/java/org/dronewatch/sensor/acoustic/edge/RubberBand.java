package org.dronewatch.sensor.acoustic.edge;

import java.util.Arrays;

/**
 * The shortest path between two points around the outline of obstacles in a plane: a taut string. It is straight from
 * corner to corner of the outline, and touches the outline at each without crossing it; found by A* over such legs. For
 * use by one thread.
 */
final class RubberBand {
    /**
     * Distance at which the path passes a corner, m. It keeps legs along a face off that face; gaps narrower than twice
     * this are closed. Lengths are those of the path without it.
     */
    private static final double PASSING = 5e-5;

    /** Tolerance of the test whether a leg only touches the faces at its ends: it may enter them at this angle, rad. */
    private static final double TOUCHING = 1e-3;

    /**
     * A search that compares legs with pieces more often than this is abandoned: there may be no path, as out of a
     * closed building. Paths in a cathedral need some thousand comparisons.
     */
    private static final int MOST_COMPARISONS = 50_000;

    /** The last node is the far end of the path; the others are corners. */
    private int nodes;

    private int[] point = new int[64];
    private double[] u = new double[64];
    private double[] v = new double[64];
    private double[] passingU = new double[64];
    private double[] passingV = new double[64];
    private double[] toEnd = new double[64];
    private double[] length = new double[64];
    private int[] before = new int[64];
    private boolean[] closed = new boolean[64];

    private CutOutline cut;

    /** Both ends of each piece, u and v: legs are compared with pieces most of the time. */
    private double[] ends = new double[256];

    /** The pieces that reach into each strip across the line: the index of the first entry of each strip. */
    private int[] strips = new int[2];

    private int[] entries = new int[256];
    private int stripCount;
    private double stripStart;
    private double stripWidth;
    private int lastBlocking;
    private int comparisons;

    private double pathLength;
    private int[] path = new int[16];
    private int corners;

    /**
     * Searches for the shortest path from the origin to a point on the u axis.
     *
     * @param outline what may not be crossed
     * @param distance of the far end, m
     * @param limit maximum length of a path, m
     * @return whether one was found
     */
    boolean find(CutOutline outline, double distance, double limit) {
        cut = outline;
        collectNodes(distance, limit);
        sortPieces(distance, limit);
        int end = nodes - 1;
        relax(-1, 0.0, 0.0, 0.0, 0.0, 0.0, limit);
        while (comparisons < MOST_COMPARISONS) {
            int next = -1;
            double shortest = limit;
            for (int i = 0; i < nodes; i++) {
                if (!closed[i] && length[i] + toEnd[i] <= shortest) {
                    shortest = length[i] + toEnd[i];
                    next = i;
                }
            }
            if (next < 0) {
                return false;
            }
            closed[next] = true;
            if (next == end) {
                remember(end);
                return true;
            }
            relax(next, u[next], v[next], passingU[next], passingV[next], length[next], limit);
        }
        return false;
    }

    /** Length of the path found last, m. */
    double length() {
        return pathLength;
    }

    /** Number of corners that the path goes round. */
    int corners() {
        return corners;
    }

    /** Coordinate along the line, m, of a corner of the path; 0 is the first from the origin. */
    double u(int corner) {
        return u[path[corner]];
    }

    /** Coordinate across the line, m, of a corner of the path. */
    double v(int corner) {
        return v[path[corner]];
    }

    /** By how much the outline bends at a corner of the path, rad. */
    double bend(int corner) {
        int at = point[path[corner]];
        return cut.isOfMesh(at) ? cut.cone(at).bend() : 0.0;
    }

    private void collectNodes(double distance, double limit) {
        reserve(cut.points() + 1);
        nodes = 0;
        for (int i = 0; i < cut.points(); i++) {
            double pu = cut.u(i);
            double pv = cut.v(i);
            double ahead = Math.sqrt((distance - pu) * (distance - pu) + pv * pv);
            Cone cone = cut.cone(i);
            if (Math.sqrt(pu * pu + pv * pv) + ahead <= limit && cone.isCorner()) {
                add(i, pu, pv, pu - PASSING * cone.middleU(), pv - PASSING * cone.middleV(), ahead);
            }
        }
        add(-1, distance, 0.0, distance, 0.0, 0.0);
        Arrays.fill(length, 0, nodes, Double.POSITIVE_INFINITY);
        Arrays.fill(closed, 0, nodes, false);
    }

    private void add(int number, double atU, double atV, double besideU, double besideV, double ahead) {
        point[nodes] = number;
        u[nodes] = atU;
        v[nodes] = atV;
        passingU[nodes] = besideU;
        passingV[nodes] = besideV;
        toEnd[nodes] = ahead;
        nodes++;
    }

    /** Tries the legs from a node, or from the origin (-1), to all others. */
    private void relax(
            int from, double fromU, double fromV, double besideU, double besideV, double soFar, double limit) {
        for (int to = 0; to < nodes; to++) {
            if (closed[to]) {
                continue;
            }
            double du = u[to] - fromU;
            double dv = v[to] - fromV;
            double leg = Math.sqrt(du * du + dv * dv);
            double sum = soFar + leg;
            if (sum < length[to]
                    && sum + toEnd[to] <= limit
                    && touches(from, du, dv, leg)
                    && touches(to, du, dv, leg)
                    && isClear(besideU, besideV, passingU[to], passingV[to])) {
                length[to] = sum;
                before[to] = from;
            }
        }
    }

    /** Whether the outline at a node lies on one side of a leg: a taut string has no other legs. */
    private boolean touches(int node, double du, double dv, double leg) {
        if (node < 0 || point[node] < 0) {
            return true;
        }
        Cone cone = cut.cone(point[node]);
        double first = du * cone.firstV() - dv * cone.firstU();
        double last = du * cone.lastV() - dv * cone.lastU();
        double slack = TOUCHING * leg;
        return first >= -slack && last >= -slack || first <= slack && last <= slack;
    }

    private boolean isClear(double u0, double v0, double u1, double v1) {
        if (cut.pieces() > 0 && crosses(lastBlocking, u0, v0, u1, v1)) {
            return false;
        }
        int first = strip(Math.min(u0, u1));
        int last = strip(Math.max(u0, u1));
        for (int i = strips[first]; i < strips[last + 1]; i++) {
            if (crosses(entries[i], u0, v0, u1, v1)) {
                lastBlocking = entries[i];
                comparisons += i - strips[first] + 1;
                return false;
            }
        }
        comparisons += strips[last + 1] - strips[first];
        return true;
    }

    private boolean crosses(int piece, double u0, double v0, double u1, double v1) {
        int at = 4 * piece;
        double au = ends[at] - u0;
        double av = ends[at + 1] - v0;
        double bu = ends[at + 2] - u0;
        double bv = ends[at + 3] - v0;
        double du = u1 - u0;
        double dv = v1 - v0;
        double ofA = du * av - dv * au;
        double ofB = du * bv - dv * bu;
        if (ofA > 0.0 && ofB > 0.0 || ofA < 0.0 && ofB < 0.0) {
            return false;
        }
        double eu = bu - au;
        double ev = bv - av;
        double ofStart = ev * au - eu * av;
        double ofEnd = ofStart - (ev * du - eu * dv);
        return !(ofStart > 0.0 && ofEnd > 0.0 || ofStart < 0.0 && ofEnd < 0.0);
    }

    private int strip(double at) {
        return Math.max(0, Math.min(stripCount - 1, (int) ((at - stripStart) / stripWidth)));
    }

    private void sortPieces(double distance, double limit) {
        int pieces = cut.pieces();
        if (ends.length < 4 * pieces) {
            ends = new double[8 * pieces];
        }
        for (int i = 0; i < pieces; i++) {
            ends[4 * i] = cut.u(cut.start(i));
            ends[4 * i + 1] = cut.v(cut.start(i));
            ends[4 * i + 2] = cut.u(cut.end(i));
            ends[4 * i + 3] = cut.v(cut.end(i));
        }
        lastBlocking = 0;
        comparisons = 0;
        stripCount = Math.max(1, Math.min(256, pieces / 4));
        stripStart = 0.5 * (distance - limit);
        stripWidth = limit / stripCount;
        if (strips.length < stripCount + 2) {
            strips = new int[stripCount + 2];
        }
        Arrays.fill(strips, 0, stripCount + 2, 0);
        for (int i = 0; i < pieces; i++) {
            for (int s = firstStrip(i); s <= lastStrip(i); s++) {
                strips[s + 2]++;
            }
        }
        for (int s = 2; s < stripCount + 2; s++) {
            strips[s] += strips[s - 1];
        }
        int all = strips[stripCount + 1];
        if (entries.length < all) {
            entries = new int[2 * all];
        }
        // While entries are written, the slot after a strip's holds where its next one goes.
        for (int i = 0; i < pieces; i++) {
            for (int s = firstStrip(i); s <= lastStrip(i); s++) {
                entries[strips[s + 1]++] = i;
            }
        }
    }

    private int firstStrip(int piece) {
        return strip(Math.min(ends[4 * piece], ends[4 * piece + 2]));
    }

    private int lastStrip(int piece) {
        return strip(Math.max(ends[4 * piece], ends[4 * piece + 2]));
    }

    private void remember(int end) {
        pathLength = length[end];
        corners = 0;
        for (int i = before[end]; i >= 0; i = before[i]) {
            if (corners == path.length) {
                path = Arrays.copyOf(path, 2 * corners);
            }
            path[corners++] = i;
        }
        for (int i = 0; i < corners / 2; i++) {
            int swap = path[i];
            path[i] = path[corners - 1 - i];
            path[corners - 1 - i] = swap;
        }
    }

    private void reserve(int most) {
        if (u.length < most) {
            int size = 2 * most;
            point = new int[size];
            u = new double[size];
            v = new double[size];
            passingU = new double[size];
            passingV = new double[size];
            toEnd = new double[size];
            length = new double[size];
            before = new int[size];
            closed = new boolean[size];
        }
    }
}
