package org.dronewatch.render.photo;

/**
 * The radiance of a clear sky, brightness and colour together: sunlight that the air of a round earth has scattered once
 * (after Nishita, Sirai, Tadamura and Nakamae, "Display of the earth taking into account atmospheric scattering", SIGGRAPH
 * 1993) and more often ({@link MultipleScattering}), and the light of the night sky. Relative to the irradiance of the sun
 * outside the atmosphere, per sr. Tabulated. Immutable.
 */
final class ScatteredLight {
    private static final int CHANNELS = Daylight.CHANNELS;

    /** Illuminance by the sun outside the atmosphere, lx (IESNA Lighting Handbook, 9th ed., ch. 8). */
    static final double SUN_OUTSIDE = 127_500.0;

    /**
     * Luminance of a moonless night sky far from towns, cd/m2: 22 magnitudes per square second of arc (Leinert and others,
     * Astronomy and Astrophysics Supplement 127, 1, 1998).
     */
    private static final double NIGHT = 1.7e-4;

    /** Colour of the night sky: assumed. */
    private static final double[] NIGHT_COLOUR = {0.8, 1.0, 1.3};

    private static final int ELEVATIONS = 49;
    private static final int AZIMUTHS = 25;
    private static final int STEPS = 32;
    private static final int STEPS_TO_SUN = 16;

    /** Logarithms by elevation of the line of sight, angle from the sun's azimuth, and channel. */
    private final float[] table = new float[ELEVATIONS * AZIMUTHS * CHANNELS];

    /**
     * A sky.
     *
     * @param elevation of the sun, rad; negative below the horizon
     */
    ScatteredLight(double elevation) {
        MultipleScattering more = new MultipleScattering(elevation);
        SkyRay ray = new SkyRay(STEPS, STEPS_TO_SUN);
        for (int i = 0; i < ELEVATIONS; i++) {
            for (int k = 0; k < AZIMUTHS; k++) {
                ray.follow(0.0, up(i), Math.cos(Math.PI * k / (AZIMUTHS - 1)), elevation, more);
                for (int channel = 0; channel < CHANNELS; channel++) {
                    double night = NIGHT / SUN_OUTSIDE * NIGHT_COLOUR[channel];
                    table[at(i, k) + channel] = (float) Math.log(ray.once(channel) + ray.often(channel) + night);
                }
            }
        }
    }

    /**
     * Writes the radiance of the sky, per sr, relative to the irradiance of the sun outside the atmosphere.
     *
     * @param up sine of the elevation, 0 to 1
     * @param azimuth angle from that of the sun, 0 to pi
     */
    void radiance(double up, double azimuth, double[] rgb) {
        double row = Math.sqrt(Math.max(0.0, Math.min(1.0, up))) * (ELEVATIONS - 1);
        double column = azimuth / Math.PI * (AZIMUTHS - 1);
        int i = Math.min(ELEVATIONS - 2, (int) row);
        int k = Math.min(AZIMUTHS - 2, (int) column);
        double v = row - i;
        double u = column - k;
        for (int channel = 0; channel < CHANNELS; channel++) {
            rgb[channel] = Math.exp(smooth(
                    across(i - 1, k, u, channel),
                    across(i, k, u, channel),
                    across(i + 1, k, u, channel),
                    across(i + 2, k, u, channel),
                    v));
        }
    }

    private double across(int row, int column, double u, int channel) {
        return smooth(
                node(row, column - 1, channel),
                node(row, column, channel),
                node(row, column + 1, channel),
                node(row, column + 2, channel),
                u);
    }

    /** Beyond its edges the sky is its own mirror image: at the sun's azimuth and opposite exactly, at the others closely. */
    private double node(int row, int column, int channel) {
        return table[at(mirrored(row, ELEVATIONS), mirrored(column, AZIMUTHS)) + channel];
    }

    private static int mirrored(int number, int count) {
        return number < 0 ? -number : number >= count ? 2 * (count - 1) - number : number;
    }

    /** The curve through two values without a kink there, by their neighbours (Catmull and Rom 1974). */
    private static double smooth(double before, double from, double to, double after, double share) {
        double slope = 0.5 * (to - before);
        double next = 0.5 * (after - from);
        double rise = to - from;
        return from + share * (slope + share * (3.0 * rise - 2.0 * slope - next + share * (slope + next - 2.0 * rise)));
    }

    /** Rows are closer to each other at the horizon. */
    private static double up(int row) {
        double root = (double) row / (ELEVATIONS - 1);
        return root * root;
    }

    private static int at(int row, int column) {
        return (row * AZIMUTHS + column) * CHANNELS;
    }
}
