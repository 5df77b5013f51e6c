package org.dronewatch.render.photo;

/**
 * Light that the air scatters more than once, for one sun: the mean radiance that reaches each place from all directions.
 * After the first scattering it is taken to be even in all directions and everywhere near, so that each further one adds the
 * same fraction f of the last: together {@code 1 / (1 - f)} of the second (S. Hillaire, "A scalable and production ready sky
 * and atmosphere rendering technique", Computer Graphics Forum 39(4), 2020, section 5.5). Without it the earth's shadow would be
 * seen as an edge in a black sky. Holds the last place: one per thread.
 */
final class MultipleScattering {
    private static final int CHANNELS = Daylight.CHANNELS;
    private static final int HEIGHTS = 14;
    private static final int ELEVATIONS = 21;

    /** From one elevation of the sun to the next, rad: a line of sight stays within 12 degrees of arc of the observer. */
    private static final double STEP = Math.toRadians(1.25);

    /** Directions over which is averaged: by elevation, and by azimuth on one side of the sun. */
    private static final int UP = 8;

    private static final int AROUND = 4;

    private static final double LEAST = 1e-30;

    private final double lowest;

    /** Logarithms of radiances by elevation of the sun, height and channel: they span many powers of ten. */
    private final double[] table = new double[ELEVATIONS * HEIGHTS * CHANNELS];

    private final double[] found = new double[CHANNELS];

    /**
     * A table about an elevation of the sun.
     *
     * @param elevation rad
     */
    MultipleScattering(double elevation) {
        this.lowest = elevation - STEP * (ELEVATIONS - 1) / 2.0;
        SkyRay ray = new SkyRay(12, 10);
        for (int i = 0; i < ELEVATIONS; i++) {
            for (int k = 0; k < HEIGHTS; k++) {
                fill(ray, height(k), lowest + STEP * i, (i * HEIGHTS + k) * CHANNELS);
            }
        }
    }

    private void fill(SkyRay ray, double height, double sun, int at) {
        double[] second = new double[CHANNELS];
        double[] again = new double[CHANNELS];
        for (int i = 0; i < UP; i++) {
            // Closest to each other at the horizon, where most of the air is.
            double middle = 2.0 * (i + 0.5) / UP - 1.0;
            double up = Math.signum(middle) * middle * middle;
            double weight = 2.0 * Math.abs(middle) / (UP * AROUND);
            for (int k = 0; k < AROUND; k++) {
                ray.follow(height, up, Math.cos(Math.PI * (k + 0.5) / AROUND), sun, null);
                for (int channel = 0; channel < CHANNELS; channel++) {
                    second[channel] += weight * ray.evenly(channel);
                    again[channel] += weight * ray.often(channel);
                }
            }
        }
        for (int channel = 0; channel < CHANNELS; channel++) {
            table[at + channel] = Math.log(LEAST + second[channel] / (1.0 - again[channel]));
        }
    }

    /** Denser where the air is. */
    private static double height(int number) {
        double share = (double) number / (HEIGHTS - 1);
        return AirDepth.TOP * share * share;
    }

    /**
     * Goes to a place.
     *
     * @param height km
     * @param sun elevation of the sun there, rad
     */
    void find(double height, double sun) {
        double row = Math.max(0.0, Math.min(ELEVATIONS - 1.0, (sun - lowest) / STEP));
        double column = Math.sqrt(Math.max(0.0, Math.min(1.0, height / AirDepth.TOP))) * (HEIGHTS - 1);
        int i = Math.min(ELEVATIONS - 2, (int) row);
        int k = Math.min(HEIGHTS - 2, (int) column);
        double v = row - i;
        double u = column - k;
        int at = (i * HEIGHTS + k) * CHANNELS;
        int next = at + HEIGHTS * CHANNELS;
        for (int channel = 0; channel < CHANNELS; channel++) {
            double here = table[at + channel] + u * (table[at + CHANNELS + channel] - table[at + channel]);
            double there = table[next + channel] + u * (table[next + CHANNELS + channel] - table[next + channel]);
            found[channel] = Math.exp(here + v * (there - here));
        }
    }

    /** Mean radiance from all directions at the place found last, per sr. */
    double radiance(int channel) {
        return found[channel];
    }
}
