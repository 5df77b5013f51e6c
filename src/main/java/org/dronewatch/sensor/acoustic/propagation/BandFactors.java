package org.dronewatch.sensor.acoustic.propagation;

import org.dronewatch.parallel.VectorInstructions;
import org.dronewatch.sound.OctaveBands;

/**
 * Multiplies the energies of a ray in all bands by factors, records the decrease in each band, and adds energies up.
 * Uses vector instructions where possible; without them, the results are the same, bit for bit.
 */
public final class BandFactors {
    static final int BANDS = OctaveBands.COUNT;

    private static final boolean VECTORS = VectorInstructions.areAvailable();

    private BandFactors() {}

    /**
     * Multiplies the value in each band, in place, by a factor.
     *
     * @param row index in {@code factors} of the first band's factor
     * @param decreases for each band, the sum of all decreases so far, to which this one is added
     */
    public static void multiply(double[] values, double[] factors, int row, double[] decreases) {
        if (VECTORS) {
            VectorBands.multiply(values, factors, row, decreases);
        } else {
            multiplyOneByOne(values, factors, row, decreases);
        }
    }

    static void multiplyOneByOne(double[] values, double[] factors, int row, double[] decreases) {
        for (int band = 0; band < BANDS; band++) {
            replace(values, band, values[band] * factors[row + band], decreases);
        }
    }

    /**
     * Multiplies the value in each band, in place, by a factor and by {@code exp(by * exponent)}, computed as a Taylor
     * series up to the fifth power: for arguments of a magnitude below 0.02, it is accurate to 1e-13. Its terms are
     * added in pairs (Estrin's scheme), which takes fewer dependent steps than Horner's.
     *
     * @param exponents the exponent in each band
     * @param by factor by which the exponents are multiplied
     * @param row index in {@code factors} of the first band's factor
     * @param decreases for each band, the sum of all decreases so far, to which this one is added
     */
    public static void multiplyByExponentials(
            double[] values, double[] exponents, double by, double[] factors, int row, double[] decreases) {
        if (VECTORS) {
            VectorBands.multiplyByExponentials(values, exponents, by, factors, row, decreases);
        } else {
            multiplyByExponentialsOneByOne(values, exponents, by, factors, row, decreases);
        }
    }

    static void multiplyByExponentialsOneByOne(
            double[] values, double[] exponents, double by, double[] factors, int row, double[] decreases) {
        for (int band = 0; band < BANDS; band++) {
            double x = exponents[band] * by;
            double square = x * x;
            double cubic = x * (1.0 / 6.0) + 0.5 + square * (x * (1.0 / 120.0) + 1.0 / 24.0);
            double series = x + 1.0 + square * cubic;
            replace(values, band, values[band] * factors[row + band] * series, decreases);
        }
    }

    /** Replaces the value in a band by a smaller one, and adds the decrease to the sum of those so far. */
    public static void replace(double[] values, int band, double after, double[] decreases) {
        decreases[band] += values[band] - after;
        values[band] = after;
    }

    /** The sum over all bands, added pairwise, so that additions overlap instead of each waiting for the one before. */
    public static double sum(double[] values) {
        return ((values[0] + values[1]) + (values[2] + values[3]))
                + ((values[4] + values[5]) + (values[6] + values[7]));
    }
}
