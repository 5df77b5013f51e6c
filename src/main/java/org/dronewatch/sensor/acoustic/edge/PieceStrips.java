package org.dronewatch.sensor.acoustic.edge;

import java.util.Arrays;

/**
 * The pieces of an outline, sorted into strips across the line between both ends of a path: a leg of the path is
 * compared only with the pieces of the strips that it traverses. For use by one thread.
 */
final class PieceStrips {
    /**
     * The coordinates u and v of both ends of each piece, kept here since comparing legs with pieces takes most of the
     * time.
     */
    private double[] ends = new double[256];

    /**
     * For each strip across the line, the index of its first entry in the list of the pieces that reach into strips.
     */
    private int[] strips = new int[2];

    private int[] entries = new int[256];
    private int stripCount;
    private double stripStart;
    private double stripWidth;
    private int lastBlocking;
    private int comparisons;
    private int pieces;

    /**
     * Sorts the pieces of an outline.
     *
     * @param outline the outline, whose pieces paths may not cross
     * @param distance distance of the far end of all paths from the origin, m
     * @param limit maximum length of a path, m
     */
    void sort(CutOutline outline, double distance, double limit) {
        pieces = outline.pieces();
        if (ends.length < 4 * pieces) {
            ends = new double[8 * pieces];
        }
        for (int i = 0; i < pieces; i++) {
            ends[4 * i] = outline.u(outline.start(i));
            ends[4 * i + 1] = outline.v(outline.start(i));
            ends[4 * i + 2] = outline.u(outline.end(i));
            ends[4 * i + 3] = outline.v(outline.end(i));
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
        // While entries are written, the slot after that of a strip holds the index at which the strip's next entry is
        // to be written.
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

    /** The number of comparisons of legs with pieces since the pieces were sorted. */
    int comparisons() {
        return comparisons;
    }

    /** Whether a leg from one point to another crosses no piece. */
    boolean isClear(double u0, double v0, double u1, double v1) {
        if (pieces > 0 && crosses(lastBlocking, u0, v0, u1, v1)) {
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
}
