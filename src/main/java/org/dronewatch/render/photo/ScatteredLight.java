package org.dronewatch.render.photo;

/**
 * The radiance of a clear sky as seen from the ground of a round earth, relative to the sun's irradiance outside the
 * air, 1/sr: sunlight that air and haze scatter once towards the observer (after Nishita and others, "Display of the
 * earth taking into account atmospheric scattering", SIGGRAPH 1993), light that was scattered more often ({@link
 * MultipleScattering}), and the light of the night sky. Tabulated. Immutable.
 */
final class ScatteredLight {
    /** Illuminance by the sun outside the atmosphere, lx (IESNA Lighting Handbook, 9th ed., ch. 8). */
    static final double SUN_OUTSIDE = 127_500.0;

    /**
     * Luminance of a moonless night sky far from towns, cd/m2: 22 magnitudes per square second of arc (Leinert and
     * others, Astronomy and Astrophysics Supplement 127, 1, 1998).
     */
    private static final double NIGHT = 1.7e-4;

    /** Colour of the night sky: assumed. */
    private static final double[] NIGHT_COLOUR = {0.8, 1.0, 1.3};

    private static final int CHANNELS = Daylight.CHANNELS;

    private static final int ELEVATIONS = 80;
    private static final int AZIMUTHS = 25;
    private static final int STEPS = 56;

    /** Scattered once by air, once by haze, both without the phase function, and more often; each by channel. */
    private static final int PARTS = 3 * CHANNELS;

    /** By elevation of the line of sight, angle from the sun's azimuth, and part. */
    private final float[] table = new float[ELEVATIONS * AZIMUTHS * PARTS];

    private final AirPath path = new AirPath();
    private final double[] sunlight = new double[CHANNELS];
    private final double[] ambient = new double[CHANNELS];

    /**
     * A sky.
     *
     * @param elevation elevation of the sun, rad; negative below the horizon
     */
    ScatteredLight(double elevation) {
        for (int i = 0; i < ELEVATIONS; i++) {
            double root = i / (ELEVATIONS - 1.0);
            double up = Math.sin(0.5 * Math.PI * root * root);
            for (int k = 0; k < AZIMUTHS; k++) {
                look(up, Math.cos(Math.PI * k / (AZIMUTHS - 1)), elevation, (i * AZIMUTHS + k) * PARTS);
            }
        }
    }

    private void look(double up, double towards, double elevation, int at) {
        double[] left = {1.0, 1.0, 1.0};
        double level = Math.sqrt(1.0 - up * up) * towards;
        path.start(0.0, up, STEPS);
        while (path.next()) {
            double distance = path.distance();
            double sine =
                    ((ClearAir.EARTH + distance * up) * Math.sin(elevation) + distance * level * Math.cos(elevation))
                            / (ClearAir.EARTH + path.height());
            SunInAir.write(path.height(), Math.min(1.0, sine), sunlight);
            MultipleScattering.write(path.height(), sine, ambient);
            for (int channel = 0; channel < CHANNELS; channel++) {
                double seen = left[channel] * path.seen(channel);
                double byAir = seen * ClearAir.scatteredByAir(channel, path.air());
                double byHaze = seen * ClearAir.scatteredByHaze(channel, path.haze());
                table[at + channel] += (float) (byAir * sunlight[channel]);
                table[at + CHANNELS + channel] += (float) (byHaze * sunlight[channel]);
                table[at + 2 * CHANNELS + channel] += (float) ((byAir + byHaze) * ambient[channel]);
                left[channel] *= Math.exp(-path.depth(channel));
            }
        }
    }

    /**
     * Writes the radiance.
     *
     * @param up sine of the elevation, 0 to 1
     * @param azimuth angle from that of the sun, 0 to pi
     * @param cosine cosine of the angle from the sun
     */
    void radiance(double up, double azimuth, double cosine, double[] rgb) {
        double row = Math.sqrt(Math.asin(Math.max(0.0, Math.min(1.0, up))) / (0.5 * Math.PI)) * (ELEVATIONS - 1);
        double column = azimuth / Math.PI * (AZIMUTHS - 1);
        int i = Math.min(ELEVATIONS - 2, (int) row);
        int k = Math.min(AZIMUTHS - 2, (int) column);
        double v = row - i;
        double u = column - k;
        double byAir = ClearAir.airPhase(cosine);
        double byHaze = ClearAir.hazePhase(cosine);
        int at = (i * AZIMUTHS + k) * PARTS;
        for (int channel = 0; channel < CHANNELS; channel++) {
            rgb[channel] = byAir * mixed(at + channel, u, v)
                    + byHaze * mixed(at + CHANNELS + channel, u, v)
                    + mixed(at + 2 * CHANNELS + channel, u, v)
                    + NIGHT / SUN_OUTSIDE * NIGHT_COLOUR[channel];
        }
    }

    private double mixed(int at, double u, double v) {
        int next = at + AZIMUTHS * PARTS;
        double lower = table[at] + u * (table[at + PARTS] - table[at]);
        return lower + v * (table[next] + u * (table[next + PARTS] - table[next]) - lower);
    }
}
