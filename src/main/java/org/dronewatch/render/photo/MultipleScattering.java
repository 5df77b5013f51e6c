package org.dronewatch.render.photo;

import java.util.Arrays;

/**
 * Sunlight that arrives at a point in {@link ClearAir} from all directions after it was scattered, or reflected by
 * the ground, at least once. The second scattering is computed, all further ones follow as a geometric series of
 * ratio f: {@code 1 / (1 - f)}, with f the part of an even light that is scattered towards the point again (Hillaire,
 * "A scalable and production ready sky and atmosphere rendering technique", Computer Graphics Forum 39, 2020).
 * Scattering is the same in all directions here. Tabulated once. Immutable.
 */
final class MultipleScattering {
    private static final int HEIGHTS = 16;
    private static final int SUNS = 48;

    /** Signed square root of the sun's lowest elevation over 90 degrees: 27 degrees below the horizon. */
    private static final double LOWEST = -0.55;

    /** The numbers of elevations and, over half a turn, of azimuths in which a point looks. */
    private static final int LEVELS = 12;

    private static final int AROUND = 4;
    private static final int STEPS = 16;

    /** The least radiance, so that its logarithm is finite. */
    private static final double DARK = 1e-20;

    /** Logarithms, by height, elevation of the sun and channel: in twilight light falls by powers of ten. */
    private static final float[] TABLE = table();

    private MultipleScattering() {}

    private static float[] table() {
        float[] table = new float[HEIGHTS * SUNS * Daylight.CHANNELS];
        AirPath path = new AirPath();
        for (int i = 0; i < HEIGHTS; i++) {
            double root = i / (HEIGHTS - 1.0);
            double[] light = new double[SUNS * Daylight.CHANNELS];
            double[] again = new double[Daylight.CHANNELS];
            for (int level = 0; level < LEVELS; level++) {
                // Close to each other at the horizon.
                double share = (level + 0.5) * 2.0 / LEVELS - 1.0;
                double weight = Math.abs(share) * 2.0 / LEVELS / AROUND;
                look(path, ClearAir.TOP * root * root, share * Math.abs(share), weight, light, again);
            }
            for (int k = 0; k < light.length; k++) {
                table[i * light.length + k] =
                        (float) Math.log(Math.max(DARK, light[k] / (1.0 - again[k % Daylight.CHANNELS])));
            }
        }
        return table;
    }

    /** Adds what is seen at an elevation, from a height. */
    private static void look(AirPath path, double height, double up, double weight, double[] light, double[] again) {
        double[] left = new double[Daylight.CHANNELS];
        double[] part = new double[Daylight.CHANNELS];
        Arrays.fill(left, 1.0);
        path.start(height, up, STEPS);
        while (path.next()) {
            for (int channel = 0; channel < Daylight.CHANNELS; channel++) {
                double scattered =
                        ClearAir.scatteredByAir(channel, path.air()) + ClearAir.scatteredByHaze(channel, path.haze());
                part[channel] = weight * left[channel] * path.seen(channel) * scattered;
                again[channel] += AROUND * part[channel];
                part[channel] /= 4.0 * Math.PI;
                left[channel] *= Math.exp(-path.depth(channel));
            }
            addSunlit(height, up, path.distance(), path.height(), part, false, light);
        }
        if (up < ClearAir.horizon(height)) {
            for (int channel = 0; channel < Daylight.CHANNELS; channel++) {
                part[channel] = weight * left[channel] * AmbientLight.ALBEDO;
                again[channel] += AROUND * part[channel];
                part[channel] /= Math.PI;
            }
            addSunlit(height, up, ClearAir.length(height, up), 0.0, part, true, light);
        }
    }

    /** Adds what a point at a distance sends, for each elevation of the sun, and azimuths all around. */
    private static void addSunlit(
            double from, double up, double distance, double height, double[] part, boolean ground, double[] light) {
        double[] sunlight = new double[Daylight.CHANNELS];
        double radius = ClearAir.EARTH + height;
        double above = ClearAir.EARTH + from + distance * up;
        double aside = distance * Math.sqrt(1.0 - up * up);
        for (int sun = 0; sun < SUNS; sun++) {
            double elevation = elevation(sun);
            for (int around = 0; around < AROUND; around++) {
                double towards = aside * Math.cos(Math.PI * (around + 0.5) / AROUND);
                double sine = (above * Math.sin(elevation) + towards * Math.cos(elevation)) / radius;
                if (sine < ClearAir.horizon(height)) {
                    continue;
                }
                SunInAir.write(height, Math.min(1.0, sine), sunlight);
                double facing = ground ? Math.max(0.0, sine) : 1.0;
                for (int channel = 0; channel < Daylight.CHANNELS; channel++) {
                    light[sun * Daylight.CHANNELS + channel] += facing * part[channel] * sunlight[channel];
                }
            }
        }
    }

    private static double elevation(int sun) {
        double root = LOWEST + (1.0 - LOWEST) * sun / (SUNS - 1.0);
        return 0.5 * Math.PI * root * Math.abs(root);
    }

    /**
     * Writes the mean radiance from all directions, relative to the sun's irradiance outside the air, 1/sr.
     *
     * @param height height of the point, km, 0 to {@link ClearAir#TOP}
     * @param up sine of the sun's elevation
     */
    static void write(double height, double up, double[] rgb) {
        double quarters = Math.asin(Math.max(-1.0, Math.min(1.0, up))) / (0.5 * Math.PI);
        double root = Math.copySign(Math.sqrt(Math.abs(quarters)), quarters);
        double column = Math.max(0.0, (root - LOWEST) / (1.0 - LOWEST) * (SUNS - 1));
        double row = Math.sqrt(Math.min(1.0, height / ClearAir.TOP)) * (HEIGHTS - 1);
        int i = Math.min(HEIGHTS - 2, (int) row);
        int k = Math.min(SUNS - 2, (int) column);
        double v = row - i;
        double u = column - k;
        for (int channel = 0; channel < Daylight.CHANNELS; channel++) {
            int at = (i * SUNS + k) * Daylight.CHANNELS + channel;
            int next = at + SUNS * Daylight.CHANNELS;
            double lower = TABLE[at] + u * (TABLE[at + Daylight.CHANNELS] - TABLE[at]);
            double upper = TABLE[next] + u * (TABLE[next + Daylight.CHANNELS] - TABLE[next]);
            rgb[channel] = Math.exp(lower + v * (upper - lower));
        }
    }
}
