package org.dronewatch.sensor.acoustic.propagation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.util.SplittableRandom;
import org.dronewatch.parallel.VectorInstructions;
import org.junit.jupiter.api.Test;

class BandFactorsTest {
    private static final int BANDS = BandFactors.BANDS;
    private static final int ROW = 16;

    private final long seed = System.nanoTime();
    private final SplittableRandom random = new SplittableRandom(seed);

    private double[] numbers(int count, double least, double most) {
        return random.doubles(count, least, most).toArray();
    }

    @Test
    void vectorsGiveTheSameBits() {
        assumeTrue(VectorInstructions.areAvailable(), "no vectors of 256 bits, or the module of vectors is not named");
        for (int i = 0; i < 10_000; i++) {
            double[] factors = numbers(32, 0.0, 1.0);
            double[] exponents = numbers(BANDS, 0.0, 0.04);
            double by = random.nextDouble(-0.5, 0.5);
            double[] one = numbers(BANDS, 0.0, 1.0);
            double[] oneDecreases = numbers(BANDS, 0.0, 100.0);
            double[] vector = one.clone();
            double[] vectorDecreases = oneDecreases.clone();
            BandFactors.multiplyOneByOne(one, factors, ROW, oneDecreases);
            BandFactors.multiplyByExponentialsOneByOne(one, exponents, by, factors, 1, oneDecreases);
            VectorBands.multiply(vector, factors, ROW, vectorDecreases);
            VectorBands.multiplyByExponentials(vector, exponents, by, factors, 1, vectorDecreases);
            assertThat(vector).as("values, seed %d", seed).containsExactly(one);
            assertThat(vectorDecreases).as("decreases, seed %d", seed).containsExactly(oneDecreases);
        }
    }

    @Test
    void whatTheValuesLoseIsAddedUp() {
        double[] before = numbers(BANDS, 0.5, 1.0);
        double[] values = before.clone();
        double[] factors = numbers(32, 0.0, 1.0);
        double[] exponents = numbers(BANDS, 0.0, 0.04);
        double[] lost = new double[BANDS];
        double[] expected = before.clone();
        for (int i = 0; i < 3; i++) {
            BandFactors.multiply(values, factors, ROW, lost);
            BandFactors.multiplyByExponentials(values, exponents, -0.4, factors, 3, lost);
            for (int band = 0; band < BANDS; band++) {
                expected[band] *= factors[ROW + band] * factors[3 + band] * Math.exp(-0.4 * exponents[band]);
            }
        }
        for (int band = 0; band < BANDS; band++) {
            assertThat(values[band]).as("band %d, seed %d", band, seed).isCloseTo(expected[band], within(1e-12));
            assertThat(lost[band])
                    .as("lost in band %d, seed %d", band, seed)
                    .isCloseTo(before[band] - expected[band], within(1e-12));
        }
    }
}
