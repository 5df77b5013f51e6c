package org.dronewatch.sensor.acoustic.energy;

import org.dronewatch.sensor.acoustic.propagation.BandFactors;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.OctaveBands;

/** The properties of the air that the energy model uses. */
final class Air {
    private static final int BANDS = OctaveBands.COUNT;

    /**
     * The fractions that are left are tabulated up to this distance, m, with one row of bands for each metre: a table
     * of this size fits the fastest cache.
     */
    private static final int TABULATED = 256;

    private final double[] exponents = new double[BANDS];
    private final double[] table = new double[BANDS * TABULATED];
    private final double soundSpeed;

    Air(Atmosphere atmosphere) {
        double[] attenuations = atmosphere.attenuations();
        for (int band = 0; band < exponents.length; band++) {
            // Energy factor exp(-m d) for a loss in dB/m.
            exponents[band] = attenuations[band] * Math.log(10.0) / 10.0;
        }
        for (int metre = 0; metre < TABULATED; metre++) {
            for (int band = 0; band < BANDS; band++) {
                table[BANDS * metre + band] = left(band, metre);
            }
        }
        this.soundSpeed = atmosphere.speedOfSound();
    }

    /** The fraction of the energy in a band that is left after a distance, m. */
    double left(int band, double distance) {
        return Math.exp(-exponents[band] * distance);
    }

    /**
     * Deducts the energy that the air absorbs over a distance. Tracing spends much of its time here. Up to a few
     * hundred metres, the fraction left is that of the nearest whole metre times a short Taylor series, whose error is
     * below 3e-12 (0.3 dB/m, more than in any air, is an exponent of 0.035 over half a metre).
     *
     * @param energies energy in each band
     * @param distance distance, m
     * @param absorbed for each band, the energy that the air has absorbed so far, to which this is added
     */
    void attenuate(double[] energies, double distance, double[] absorbed) {
        int metre = (int) (distance + 0.5);
        if (metre >= TABULATED) {
            for (int band = 0; band < BANDS; band++) {
                BandFactors.replace(energies, band, energies[band] * left(band, distance), absorbed);
            }
            return;
        }
        BandFactors.multiplyByExponentials(energies, exponents, metre - distance, table, BANDS * metre, absorbed);
    }

    /** Speed of sound, m/s. */
    double soundSpeed() {
        return soundSpeed;
    }
}
