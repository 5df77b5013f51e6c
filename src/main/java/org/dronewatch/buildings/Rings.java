package org.dronewatch.buildings;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/** Closed lines on a plane: x and y of each corner in turn, without repeating the first one. */
final class Rings {
    private Rings() {}

    /** Positive if the corners run counter-clockwise, m2. */
    static double signedArea(double[] ring) {
        double twice = 0.0;
        int last = ring.length - 2;
        // Relative to the first corner, so that nothing is lost far from the origin.
        for (int i = 0; i < ring.length; i += 2) {
            twice +=
                    (ring[last] - ring[0]) * (ring[i + 1] - ring[1]) - (ring[i] - ring[0]) * (ring[last + 1] - ring[1]);
            last = i;
        }
        return 0.5 * twice;
    }

    /** The same ring, counter-clockwise or clockwise. */
    static double[] wound(double[] ring, boolean isCounterClockwise) {
        return signedArea(ring) > 0.0 == isCounterClockwise ? ring : reversed(ring);
    }

    private static double[] reversed(double[] ring) {
        double[] reversed = new double[ring.length];
        for (int i = 0; i < ring.length; i += 2) {
            reversed[ring.length - 2 - i] = ring[i];
            reversed[ring.length - 1 - i] = ring[i + 1];
        }
        return reversed;
    }

    /** The ring without corners that lie nearer to the one before than a given distance, m. */
    static double[] cleaned(double[] ring, double near) {
        double[] kept = new double[ring.length];
        int count = 0;
        for (int i = 0; i < ring.length; i += 2) {
            if (count == 0 || Math.hypot(ring[i] - kept[count - 2], ring[i + 1] - kept[count - 1]) >= near) {
                kept[count++] = ring[i];
                kept[count++] = ring[i + 1];
            }
        }
        while (count > 2 && Math.hypot(kept[count - 2] - kept[0], kept[count - 1] - kept[1]) < near) {
            count -= 2;
        }
        return Arrays.copyOf(kept, count);
    }

    /** Whether a point lies inside; on the line it may be either. */
    static boolean contains(double[] ring, double x, double y) {
        boolean isInside = false;
        int last = ring.length - 2;
        for (int i = 0; i < ring.length; i += 2) {
            if (ring[i + 1] > y != ring[last + 1] > y) {
                double crossing = ring[i] + (y - ring[i + 1]) / (ring[last + 1] - ring[i + 1]) * (ring[last] - ring[i]);
                isInside ^= x < crossing;
            }
            last = i;
        }
        return isInside;
    }

    /** Whether any part of an area lies within a distance of the origin, even if none of its corners does. */
    static boolean isWithin(double distance, List<double[]> outers, List<double[]> inners) {
        if (Stream.concat(outers.stream(), inners.stream()).anyMatch(ring -> distance(ring) <= distance)) {
            return true;
        }
        // No line comes near: the origin is in the middle of the area, of a courtyard, or outside.
        return outers.stream().filter(ring -> contains(ring, 0.0, 0.0)).count()
                > inners.stream().filter(ring -> contains(ring, 0.0, 0.0)).count();
    }

    /** From the origin to the nearest point of the line, m; infinite if there is no corner. */
    private static double distance(double[] ring) {
        double nearest = Double.POSITIVE_INFINITY;
        int last = ring.length - 2;
        for (int i = 0; i < ring.length; i += 2) {
            double sideX = ring[i] - ring[last];
            double sideY = ring[i + 1] - ring[last + 1];
            double square = sideX * sideX + sideY * sideY;
            double along = square > 0.0 ? -(ring[last] * sideX + ring[last + 1] * sideY) / square : 0.0;
            double part = Math.max(0.0, Math.min(1.0, along));
            nearest = Math.min(nearest, Math.hypot(ring[last] + part * sideX, ring[last + 1] + part * sideY));
            last = i;
        }
        return nearest;
    }

    /** Whether all corners turn left, or none turns. */
    static boolean isConvex(double[] ring) {
        int corners = ring.length / 2;
        for (int i = 0; i < corners; i++) {
            int a = 2 * i;
            int b = 2 * ((i + 1) % corners);
            int c = 2 * ((i + 2) % corners);
            double ux = ring[b] - ring[a];
            double uy = ring[b + 1] - ring[a + 1];
            double vx = ring[c] - ring[b];
            double vy = ring[c + 1] - ring[b + 1];
            // Corners of a map are good to centimetres: an almost straight wall is straight.
            if (ux * vy - uy * vx < -1e-3 * Math.hypot(ux, uy) * Math.hypot(vx, vy)) {
                return false;
            }
        }
        return true;
    }

    /** The part of a ring that lies where {@code a x + b y <= c}; empty if there is none. */
    static double[] clipped(double[] ring, double a, double b, double c) {
        double[] kept = new double[2 * ring.length + 4];
        int count = 0;
        int last = ring.length - 2;
        for (int i = 0; i < ring.length; i += 2) {
            double from = a * ring[last] + b * ring[last + 1] - c;
            double to = a * ring[i] + b * ring[i + 1] - c;
            if (from < 0.0 && to > 0.0 || from > 0.0 && to < 0.0) {
                double part = from / (from - to);
                kept[count++] = ring[last] + part * (ring[i] - ring[last]);
                kept[count++] = ring[last + 1] + part * (ring[i + 1] - ring[last + 1]);
            }
            if (to <= 0.0) {
                kept[count++] = ring[i];
                kept[count++] = ring[i + 1];
            }
            last = i;
        }
        return Arrays.copyOf(kept, count);
    }
}
