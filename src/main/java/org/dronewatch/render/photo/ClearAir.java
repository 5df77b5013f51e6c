package org.dronewatch.render.photo;

import java.util.Arrays;
import org.dronewatch.world.ClearSky;

/**
 * The clear air of a round earth without refraction: the densities of air, haze and ozone are given as the fraction of
 * the vertical column that a kilometre contains. Heights and distances are in km, optical depths are for light from the
 * zenith and by channel: red, green and blue are light of 610, 550 and 465 nm.
 */
final class ClearAir {
    /** Radius of the earth. */
    static final double EARTH = 6371.0;

    /** The height above which nothing is scattered. */
    static final double TOP = 160.0;

    /** Density of the air every ten kilometres, relative to that at the ground (U.S. Standard Atmosphere, 1976). */
    private static final double[] DENSITIES = {
        1.0, 0.3376, 0.07258, 0.01503, 3.262e-3, 8.383e-4, 2.528e-4, 6.761e-5, 1.507e-5, 2.79e-6, 4.575e-7, 7.93e-8,
        1.814e-8, 6.655e-9, 3.127e-9, 1.695e-9, 1.007e-9
    };

    private static final double LAYER = 10.0;

    private static final double[] LOGARITHMS =
            Arrays.stream(DENSITIES).map(Math::log).toArray();

    /** The integral of density over height, relative to the density at the ground. */
    private static final double COLUMN = column();

    /** Scale height of haze, over which it falls to 1/e (Bruneton and Neyret, Computer Graphics Forum 27, 2008). */
    static final double HAZE_SCALE = 1.2;

    /** The layer of ozone, as a triangle: its middle, and its extent to either side (Hillaire 2020). */
    private static final double OZONE_HEIGHT = 25.0;

    private static final double OZONE_REACH = 15.0;

    /** Optical depths of air (Bucholtz, Applied Optics 34, 1995, 2765). */
    private static final double[] AIR = {0.064, 0.097, 0.193};

    /**
     * Optical depths of 300 Dobson units of ozone, from the cross-sections of its Chappuis bands (Gorshelev and others,
     * Atmospheric Measurement Techniques 7, 2014, 609).
     */
    private static final double[] OZONE = {0.037, 0.027, 0.004};

    /**
     * Optical depths of haze: in green what air and ozone leave of the 0.21 that a clear sky has ({@link ClearSky}), in
     * other colours by the power -1.3 of wavelength (Angstrom, Geografiska Annaler 11, 1929, 156).
     */
    private static final double[] HAZE = {0.0752, 0.086, 0.107};

    /** The scattered fraction of the light that haze takes away: assumed, as by Hillaire 2020. */
    private static final double HAZE_SCATTERS = 0.9;

    /** How much haze scatters forward: the asymmetry of Henyey and Greenstein (1941), as by Nishita and others 1993. */
    private static final double FORWARD = 0.76;

    private ClearAir() {}

    /** The density of air: the fraction of its vertical column that a kilometre at this density contains. */
    static double air(double height) {
        int layer = Math.min(LOGARITHMS.length - 2, (int) (height / LAYER));
        double share = height / LAYER - layer;
        return Math.exp(LOGARITHMS[layer] + share * (LOGARITHMS[layer + 1] - LOGARITHMS[layer])) / COLUMN;
    }

    /** The logarithm of density is linear between the heights of the table. */
    private static double column() {
        double sum = 0.0;
        for (int i = 1; i < DENSITIES.length; i++) {
            sum += LAYER * (DENSITIES[i - 1] - DENSITIES[i]) / (LOGARITHMS[i - 1] - LOGARITHMS[i]);
        }
        return sum;
    }

    static double haze(double height) {
        return Math.exp(-height / HAZE_SCALE) / HAZE_SCALE;
    }

    static double ozone(double height) {
        return Math.max(0.0, 1.0 - Math.abs(height - OZONE_HEIGHT) / OZONE_REACH) / OZONE_REACH;
    }

    /** Optical depth of columns of air, haze and ozone, each as a fraction of the whole column above the ground. */
    static double depth(int channel, double air, double haze, double ozone) {
        return AIR[channel] * air + HAZE[channel] * haze + OZONE[channel] * ozone;
    }

    /** What the air of a column, or of a density, scatters. */
    static double scatteredByAir(int channel, double air) {
        return AIR[channel] * air;
    }

    /** What the haze of a column, or of a density, scatters. */
    static double scatteredByHaze(int channel, double haze) {
        return HAZE[channel] * HAZE_SCATTERS * haze;
    }

    /** Rayleigh's phase function, 1/sr. */
    static double airPhase(double cosine) {
        return 3.0 / (16.0 * Math.PI) * (1.0 + cosine * cosine);
    }

    /** The phase function of haze, 1/sr. */
    static double hazePhase(double cosine) {
        double square = 1.0 + FORWARD * FORWARD - 2.0 * FORWARD * cosine;
        return (1.0 - FORWARD * FORWARD) / (4.0 * Math.PI * square * Math.sqrt(square));
    }

    /** Sine of the elevation of the horizon as seen from a height: 0 or less. */
    static double horizon(double height) {
        double ratio = EARTH / (EARTH + height);
        return -Math.sqrt(Math.max(0.0, 1.0 - ratio * ratio));
    }

    /**
     * Length of a line to the top of the air or to the ground, whichever it meets.
     *
     * @param up sine of the line's elevation
     */
    static double length(double height, double up) {
        double radius = EARTH + height;
        double across = radius * radius * (1.0 - up * up);
        if (up < 0.0 && across < EARTH * EARTH) {
            return -radius * up - Math.sqrt(EARTH * EARTH - across);
        }
        return Math.sqrt(Math.max(0.0, (EARTH + TOP) * (EARTH + TOP) - across)) - radius * up;
    }
}
