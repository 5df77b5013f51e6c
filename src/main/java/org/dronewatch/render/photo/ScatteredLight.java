package org.dronewatch.render.photo;

import java.util.Arrays;

/**
 * The colour of a clear sky: sunlight that the air of a round earth has scattered once (after Nishita, Sirai, Tadamura
 * and Nakamae, "Display of the earth taking into account atmospheric scattering", SIGGRAPH 1993), with multiple
 * scattering in its mean colour, less near the horizon, and the light of the night sky. How much of these two there is, is
 * assumed. With the sun well below the horizon the earth's shadow is seen as an edge. Tabulated. Immutable.
 */
final class ScatteredLight {
    private static final int CHANNELS = Daylight.CHANNELS;

    /** Radius of the earth, and height of the sunlit air, km. */
    private static final double EARTH = 6371.0;

    private static final double TOP = 100.0;

    /** Scale heights, over which density falls to 1/e, of air and haze, km. */
    private static final double AIR_SCALE = 8.0;

    private static final double HAZE_SCALE = 1.2;

    /** The layer of ozone, as a triangle: its middle, and its extent to either side, km. */
    private static final double OZONE_HEIGHT = 25.0;

    private static final double OZONE_REACH = 15.0;

    /** Optical depth of haze for light from the zenith, and its single-scattering albedo: assumed, of clear air. */
    private static final double HAZE = 0.03;

    private static final double HAZE_SCATTERS = 0.9;

    /** How much haze scatters forward (Henyey and Greenstein 1941). */
    private static final double FORWARD = 0.76;

    /**
     * Optical depths of 300 Dobson units of ozone at 610, 550 and 465 nm, for light from the zenith, of the
     * cross-sections of its Chappuis bands (Gorshelev and others, Atmospheric Measurement Techniques 7, 609, 2014).
     */
    private static final double[] OZONE = {0.037, 0.027, 0.004};

    /** Multiple scattering, relative to the mean of single scattering: assumed. */
    private static final double MORE_OFTEN = 0.35;

    /** Sine of the elevation at which half of the multiple scattering is left, near the thick horizon: assumed. */
    private static final double THICK = 0.1;

    /** The sky of a moonless night, relative to sunlight outside the atmosphere: assumed. */
    private static final double[] NIGHT = {0.8e-8, 1.0e-8, 1.3e-8};

    /** Sine of an elevation: below it the sky has the colour that it has there. */
    private static final double LOWEST = 0.01;

    private static final int ELEVATIONS = 33;
    private static final int AZIMUTHS = 17;
    private static final int STEPS = 40;
    private static final int STEPS_TO_SUN = 20;

    /** By elevation of the line of sight, angle from the sun's azimuth, and channel. */
    private final float[] table = new float[ELEVATIONS * AZIMUTHS * CHANNELS];

    private final double day;

    /**
     * A sky.
     *
     * @param elevation of the sun, rad; negative below the horizon
     */
    ScatteredLight(double elevation) {
        double[] sun = {Math.cos(elevation), 0.0, Math.sin(elevation)};
        double[] rgb = new double[CHANNELS];
        double[] mean = new double[CHANNELS];
        for (int i = 0; i < ELEVATIONS; i++) {
            double up = up(i);
            for (int k = 0; k < AZIMUTHS; k++) {
                double azimuth = Math.PI * k / (AZIMUTHS - 1);
                double weight = k == 0 || k == AZIMUTHS - 1 ? 0.5 : 1.0;
                double level = Math.sqrt(1.0 - up * up);
                scatter(level * Math.cos(azimuth), level * Math.sin(azimuth), up, sun, rgb);
                for (int channel = 0; channel < CHANNELS; channel++) {
                    table[at(i, k) + channel] = (float) rgb[channel];
                    // The nodes are closer to each other at the horizon.
                    mean[channel] += rgb[channel] * weight * 2.0 * Math.sqrt(up) / (ELEVATIONS * (AZIMUTHS - 1));
                }
            }
        }
        for (int i = 0; i < table.length; i++) {
            double up = up(i / (AZIMUTHS * CHANNELS));
            double from = MORE_OFTEN * up / (up + THICK);
            table[i] += (float) (from * mean[i % CHANNELS] + NIGHT[i % CHANNELS]);
        }
        double lit = Daylight.brightness(mean);
        this.day = lit / (lit + Daylight.brightness(NIGHT));
    }

    /** The fraction of the light that comes from the sun; the rest is that of the night. */
    double day() {
        return day;
    }

    /**
     * Writes the colour of the sky, of brightness 1.
     *
     * @param up sine of the elevation, 0 to 1
     * @param azimuth angle from that of the sun, 0 to pi
     */
    void colour(double up, double azimuth, double[] rgb) {
        double row = Math.sqrt(Math.max(LOWEST, Math.min(1.0, up))) * (ELEVATIONS - 1);
        double column = azimuth / Math.PI * (AZIMUTHS - 1);
        int i = Math.min(ELEVATIONS - 2, (int) row);
        int k = Math.min(AZIMUTHS - 2, (int) column);
        double v = row - i;
        double u = column - k;
        for (int channel = 0; channel < CHANNELS; channel++) {
            rgb[channel] = (1.0 - v) * ((1.0 - u) * table[at(i, k) + channel] + u * table[at(i, k + 1) + channel])
                    + v * ((1.0 - u) * table[at(i + 1, k) + channel] + u * table[at(i + 1, k + 1) + channel]);
        }
        Daylight.equallyBright(rgb);
    }

    private static double up(int row) {
        double root = (double) row / (ELEVATIONS - 1);
        return root * root;
    }

    private static int at(int row, int column) {
        return (row * AZIMUTHS + column) * CHANNELS;
    }

    /** Light scattered towards an observer on the ground, relative to sunlight outside the atmosphere. */
    private static void scatter(double x, double y, double z, double[] sun, double[] rgb) {
        Arrays.fill(rgb, 0.0);
        double cosine = x * sun[0] + y * sun[1] + z * sun[2];
        double ofAir = 3.0 / (16.0 * Math.PI) * (1.0 + cosine * cosine);
        double ofHaze = (1.0 - FORWARD * FORWARD)
                / (4.0 * Math.PI * Math.pow(1.0 + FORWARD * FORWARD - 2.0 * FORWARD * cosine, 1.5));
        double end = toHeight(0.0, z, TOP);
        double[] column = new double[3];
        double[] toSun = new double[3];
        double from = 0.0;
        for (int step = 0; step < STEPS; step++) {
            // Short steps where the air is dense.
            double share = (step + 1.0) / STEPS;
            double to = end * share * share * share;
            double length = to - from;
            double middle = 0.5 * (from + to);
            double py = middle * y;
            double px = middle * x;
            double pz = EARTH + middle * z;
            double radius = Math.sqrt(px * px + py * py + pz * pz);
            double height = radius - EARTH;
            double air = Math.exp(-height / AIR_SCALE) / AIR_SCALE;
            double haze = Math.exp(-height / HAZE_SCALE) / HAZE_SCALE;
            double ozone = ozone(height);
            add(column, 0.5 * length, air, haze, ozone);
            if (light(height, (px * sun[0] + pz * sun[2]) / radius, toSun)) {
                for (int channel = 0; channel < CHANNELS; channel++) {
                    double depth = Daylight.depth(channel) * (column[0] + toSun[0])
                            + HAZE * (column[1] + toSun[1])
                            + OZONE[channel] * (column[2] + toSun[2]);
                    rgb[channel] += length
                            * Math.exp(-depth)
                            * (Daylight.depth(channel) * air * ofAir + HAZE * HAZE_SCATTERS * haze * ofHaze);
                }
            }
            add(column, 0.5 * length, air, haze, ozone);
            from = to;
        }
    }

    private static void add(double[] column, double length, double air, double haze, double ozone) {
        column[0] += length * air;
        column[1] += length * haze;
        column[2] += length * ozone;
    }

    /** Density of ozone, with an integral of 1 over the whole layer. */
    private static double ozone(double height) {
        return Math.max(0.0, 1.0 - Math.abs(height - OZONE_HEIGHT) / OZONE_REACH) / OZONE_REACH;
    }

    /** Distance along a line from one height to another, in a direction given by the sine of its elevation. */
    private static double toHeight(double height, double up, double other) {
        double radius = EARTH + height;
        double outer = EARTH + other;
        double across = radius * radius * (1.0 - up * up);
        return Math.sqrt(Math.max(0.0, outer * outer - across)) - radius * up;
    }

    /** Finds the air between a point and the sun; false if the earth is in between. */
    private static boolean light(double height, double up, double[] column) {
        double radius = EARTH + height;
        if (up < 0.0 && radius * Math.sqrt(1.0 - up * up) < EARTH) {
            return false;
        }
        Arrays.fill(column, 0.0);
        double end = toHeight(height, up, TOP);
        // Where the line is lowest the air is densest: steps are short around there.
        double lowest = Math.max(0.0, -radius * up);
        double from = 0.0;
        for (int step = 0; step < STEPS_TO_SUN; step++) {
            double to = place((step + 1.0) / STEPS_TO_SUN, lowest, end);
            double middle = 0.5 * (from + to);
            double above = Math.sqrt(radius * radius + middle * middle + 2.0 * radius * middle * up) - EARTH;
            add(
                    column,
                    to - from,
                    Math.exp(-above / AIR_SCALE) / AIR_SCALE,
                    Math.exp(-above / HAZE_SCALE) / HAZE_SCALE,
                    ozone(above));
            from = to;
        }
        return true;
    }

    /** A point on a line by a fraction from 0 to 1: most points are near its lowest one. */
    private static double place(double share, double lowest, double end) {
        double border = Math.min(0.5, lowest / end);
        if (share < border) {
            double back = 1.0 - share / border;
            return lowest * (1.0 - back * back);
        }
        double on = (share - border) / (1.0 - border);
        return lowest + (end - lowest) * on * on;
    }
}
