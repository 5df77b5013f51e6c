package org.dronewatch.models;

/** Smooth noise in the plane from hashed lattice values: no tables, no state, the same everywhere. */
final class ValueNoise {

    private final int seed;

    ValueNoise(int seed) {
        this.seed = seed;
    }

    /** Noise with one bump per unit length, from -1 to 1, with continuous slope and curvature. */
    double at(double x, double y) {
        double cellX = Math.floor(x);
        double cellY = Math.floor(y);
        double u = ease(x - cellX);
        double v = ease(y - cellY);
        int i = (int) cellX;
        int j = (int) cellY;
        double low = mix(lattice(i, j), lattice(i + 1, j), u);
        double high = mix(lattice(i, j + 1), lattice(i + 1, j + 1), u);
        return mix(low, high, v);
    }

    /** Sum of octaves, each half as long and half as high as the one before, scaled to -1 to 1. */
    double octaves(double x, double y, int count) {
        double sum = 0;
        double weight = 1;
        double total = 0;
        double px = x;
        double py = y;
        for (int k = 0; k < count; k++) {
            sum += weight * at(px, py);
            total += weight;
            weight *= 0.5;
            // Each octave is turned as well, or the lattice directions would show as straight lines.
            double turned = 1.6 * px + 1.2 * py + 17.3;
            py = -1.2 * px + 1.6 * py - 9.1;
            px = turned;
        }
        return sum / total;
    }

    private double lattice(int i, int j) {
        int h = seed ^ (i * 0x27d4eb2d) ^ (j * 0x165667b1);
        h = (h ^ (h >>> 15)) * 0x2c1b3c6d;
        h = (h ^ (h >>> 12)) * 0x297a2d39;
        h ^= h >>> 15;
        return h / 2147483648.0;
    }

    private static double ease(double t) {
        return t * t * t * (t * (6 * t - 15) + 10);
    }

    private static double mix(double a, double b, double t) {
        return a + (b - a) * t;
    }
}
