package org.dronewatch.render.photo;

import java.util.Arrays;

/**
 * The air of a round earth: how much air, haze and ozone there is at a height, and how much of each light meets on a straight
 * line. Densities are such that a vertical line through all of the atmosphere meets 1 of each. Heights and distances are in km.
 * Holds the amounts of one line: one per thread.
 */
final class AirDepth {
    /** Radius of the earth, km. */
    static final double EARTH = 6371.0;

    /** Height above which no light is scattered, km. */
    static final double TOP = 120.0;

    /** Density of the air every ten kilometres, relative to that at the ground (U.S. Standard Atmosphere, 1976). */
    private static final double[] DENSITIES = {
        1.0, 0.3376, 0.07258, 0.01503, 3.262e-3, 8.383e-4, 2.528e-4, 6.761e-5, 1.507e-5, 2.79e-6, 4.575e-7, 7.93e-8,
        1.814e-8
    };

    private static final double TEN = 10.0;

    /** Scale height of haze, over which its density falls to 1/e, km. */
    private static final double HAZE_SCALE = 1.2;

    /** The layer of ozone, as a triangle: its middle, and its extent to either side, km. */
    private static final double OZONE_HEIGHT = 25.0;

    private static final double OZONE_REACH = 15.0;

    /** Optical depth of haze for light from the zenith, and its single-scattering albedo: assumed, of clear air. */
    private static final double HAZE = 0.03;

    private static final double HAZE_SCATTERS = 0.9;

    /**
     * Optical depths of 300 Dobson units of ozone at 610, 550 and 465 nm, for light from the zenith, of the
     * cross-sections of its Chappuis bands (Gorshelev and others, Atmospheric Measurement Techniques 7, 609, 2014).
     */
    private static final double[] OZONE = {0.037, 0.027, 0.004};

    private static final double[] LOGARITHMS =
            Arrays.stream(DENSITIES).map(Math::log).toArray();

    /** The integral of all densities over the height, km: that of an atmosphere of even density would be as high. */
    private static final double COLUMN = column();

    private double air;
    private double haze;
    private double ozone;

    /** Begins a new line. */
    void clear() {
        air = 0.0;
        haze = 0.0;
        ozone = 0.0;
    }

    /** Adds a piece of the line, at a height. */
    void add(double height, double length) {
        air += length * airAt(height);
        haze += length * hazeAt(height);
        ozone += length * ozoneAt(height);
    }

    /** The amount of air on the line so far: the air mass, if it began on the ground. */
    double air() {
        return air;
    }

    /** Optical depth of the line so far and of another one together. */
    double with(AirDepth other, int channel) {
        return Daylight.depth(channel) * (air + other.air)
                + HAZE * (haze + other.haze)
                + OZONE[channel] * (ozone + other.ozone);
    }

    /** Optical depth of the line so far. */
    double depth(int channel) {
        return Daylight.depth(channel) * air + HAZE * haze + OZONE[channel] * ozone;
    }

    /** The fraction that the air at a height scatters, per km. */
    static double scatteredByAir(double height, int channel) {
        return Daylight.depth(channel) * airAt(height);
    }

    /** The fraction that haze at a height scatters, per km. */
    static double scatteredByHaze(double height) {
        return HAZE * HAZE_SCATTERS * hazeAt(height);
    }

    private static double airAt(double height) {
        int layer = Math.min(DENSITIES.length - 2, (int) (height / TEN));
        return Math.exp(LOGARITHMS[layer] + (height / TEN - layer) * (LOGARITHMS[layer + 1] - LOGARITHMS[layer]))
                / COLUMN;
    }

    private static double column() {
        double sum = 0.0;
        for (int layer = 1; layer < DENSITIES.length; layer++) {
            // The density falls exponentially from one height of the table to the next.
            sum += TEN * (DENSITIES[layer - 1] - DENSITIES[layer]) / (LOGARITHMS[layer - 1] - LOGARITHMS[layer]);
        }
        return sum;
    }

    private static double hazeAt(double height) {
        return Math.exp(-height / HAZE_SCALE) / HAZE_SCALE;
    }

    private static double ozoneAt(double height) {
        return Math.max(0.0, 1.0 - Math.abs(height - OZONE_HEIGHT) / OZONE_REACH) / OZONE_REACH;
    }

    /** Whether a line meets the earth, in a direction given by the sine of its elevation. */
    static boolean meetsEarth(double height, double up) {
        double radius = EARTH + height;
        return up < 0.0 && radius * Math.sqrt(1.0 - up * up) < EARTH;
    }

    /** Where a line ends, at the top of the atmosphere or on the earth, km from its origin. */
    static double end(double height, double up) {
        double radius = EARTH + height;
        double across = radius * radius * (1.0 - up * up);
        if (meetsEarth(height, up)) {
            return Math.max(0.0, -radius * up - Math.sqrt(EARTH * EARTH - across));
        }
        double outer = EARTH + TOP;
        return Math.sqrt(Math.max(0.0, outer * outer - across)) - radius * up;
    }

    /** Height of a point on a line. */
    static double heightAt(double height, double up, double distance) {
        double radius = EARTH + height;
        return Math.max(0.0, Math.sqrt(radius * radius + distance * distance + 2.0 * radius * distance * up) - EARTH);
    }

    /**
     * A point on a line by a fraction from 0 to 1, km from its origin: most points are near its lowest one, where the air is
     * densest.
     *
     * @param end of the line
     */
    static double place(double share, double height, double up, double end) {
        if (!(end > 0.0)) {
            return 0.0;
        }
        double lowest = Math.min(end, Math.max(0.0, -(EARTH + height) * up));
        double border = Math.min(0.5, lowest / end);
        if (share < border) {
            double back = 1.0 - share / border;
            return lowest * (1.0 - back * back);
        }
        double on = (share - border) / (1.0 - border);
        return lowest + (end - lowest) * on * on;
    }

    /**
     * Follows a line from a point to the sun.
     *
     * @param up sine of the sun's elevation there
     * @return false if the earth is in between
     */
    boolean toSun(double height, double up, int steps) {
        if (meetsEarth(height, up)) {
            return false;
        }
        clear();
        double end = end(height, up);
        double from = 0.0;
        for (int step = 0; step < steps; step++) {
            double to = place((step + 1.0) / steps, height, up, end);
            add(heightAt(height, up, 0.5 * (from + to)), to - from);
            from = to;
        }
        return true;
    }
}
