package org.dronewatch.sensor.acoustic.propagation;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorSpecies;

/** The products of {@link BandFactors}, computed by vector instructions, four bands at a time. */
final class VectorBands {
    private static final VectorSpecies<Double> DOUBLES_4 = DoubleVector.SPECIES_256;
    private static final int LANES = 4;

    private VectorBands() {}

    static void multiply(double[] values, double[] factors, int row, double[] decreases) {
        for (int band = 0; band < BandFactors.BANDS; band += LANES) {
            DoubleVector before = load(values, band);
            replace(values, before, before.mul(load(factors, row + band)), decreases, band);
        }
    }

    static void multiplyByExponentials(
            double[] values, double[] exponents, double by, double[] factors, int row, double[] decreases) {
        for (int band = 0; band < BandFactors.BANDS; band += LANES) {
            DoubleVector x = load(exponents, band).mul(by);
            DoubleVector square = x.mul(x);
            DoubleVector cubic =
                    x.mul(1.0 / 6.0).add(0.5).add(square.mul(x.mul(1.0 / 120.0).add(1.0 / 24.0)));
            DoubleVector series = x.add(1.0).add(square.mul(cubic));
            DoubleVector before = load(values, band);
            replace(values, before, before.mul(load(factors, row + band)).mul(series), decreases, band);
        }
    }

    private static void replace(
            double[] values, DoubleVector before, DoubleVector after, double[] decreases, int band) {
        after.intoArray(values, band);
        load(decreases, band).add(before.sub(after)).intoArray(decreases, band);
    }

    private static DoubleVector load(double[] values, int at) {
        return DoubleVector.fromArray(DOUBLES_4, values, at);
    }
}
