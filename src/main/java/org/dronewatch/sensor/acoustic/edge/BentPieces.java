package org.dronewatch.sensor.acoustic.edge;

import java.util.Arrays;
import org.dronewatch.sensor.acoustic.propagation.PathCurvature;

/**
 * Collects the pieces of parabolas in which a plane cuts curved surfaces, and divides them into straight pieces. For
 * use by one thread.
 */
final class BentPieces {
    private static final int MOST_PARTS = 1000;

    private final CutOutline outline;

    /** The points at both ends of each piece. */
    private int[] ends = new int[128];

    /** The distance across the line by which each surface is displaced for each metre by which it is raised, m. */
    private double[] steepness = new double[64];

    private int count;
    private double[] divided = new double[64];

    BentPieces(CutOutline outline) {
        this.outline = outline;
    }

    void clear() {
        count = 0;
    }

    /** Adds a piece, to be divided once all points of the mesh are known. */
    void add(int start, int end, double perSag) {
        if (count == steepness.length) {
            ends = Arrays.copyOf(ends, 4 * count);
            steepness = Arrays.copyOf(steepness, 2 * count);
        }
        boolean isForward = outline.u(start) <= outline.u(end);
        ends[2 * count] = isForward ? start : end;
        ends[2 * count + 1] = isForward ? end : start;
        steepness[count] = perSag;
        count++;
    }

    /**
     * Divides the pieces into parts that are nearly straight, and adds these to the outline. They are also divided at
     * every point of the mesh that lies on them: there must be no gap under a wall on bent ground. Neither may parts
     * run above an end of the path that lies on the ground: pieces are divided there, too.
     *
     * @param curvature curvature of sound, 1/m
     * @param distance distance along the line of the far end of the path, m
     */
    void divide(double curvature, double distance) {
        int ofMesh = outline.points();
        for (int piece = 0; piece < count; piece++) {
            int start = ends[2 * piece];
            double from = outline.u(start);
            double to = outline.u(ends[2 * piece + 1]);
            int parts = Math.min(MOST_PARTS, PathCurvature.pieces(curvature * steepness[piece], to - from));
            int divisions = 0;
            if (divided.length < parts + ofMesh + 2) {
                divided = new double[2 * (parts + ofMesh) + 2];
            }
            for (int part = 1; part < parts; part++) {
                divided[divisions++] = from + (to - from) * part / parts;
            }
            for (int point = 0; point < ofMesh && parts > 1; point++) {
                double at = outline.u(point);
                if (at > from
                        && at < to
                        && Math.abs(outline.v(point) - across(piece, at, curvature)) < PathCurvature.EXACT) {
                    divided[divisions++] = at;
                }
            }
            if (from < 0.0 && to > 0.0) {
                divided[divisions++] = 0.0;
            }
            if (from < distance && to > distance) {
                divided[divisions++] = distance;
            }
            Arrays.sort(divided, 0, divisions);
            int before = start;
            for (int division = 0; division < divisions; division++) {
                double at = divided[division];
                if (division == 0 || at != divided[division - 1]) {
                    int next = outline.dividingPoint(at, across(piece, at, curvature));
                    outline.add(before, next);
                    before = next;
                }
            }
            outline.add(before, ends[2 * piece + 1]);
        }
    }

    /** The coordinate of a piece across the line at a distance along the line, m. */
    private double across(int piece, double along, double curvature) {
        int start = ends[2 * piece];
        int end = ends[2 * piece + 1];
        double from = outline.u(start);
        double to = outline.u(end);
        double share = (along - from) / (to - from);
        double bow = 0.5 * curvature * (along - from) * (to - along);
        return outline.v(start) + share * (outline.v(end) - outline.v(start)) + steepness[piece] * bow;
    }
}
