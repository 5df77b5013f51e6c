package org.dronewatch.sound.surface;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TurbulentCoherenceTest {
    private static final double SOUND_SPEED = 343.2;

    /** Phase and amplitude together: 500 m, source at 30 m, microphone at 1.5 m. */
    @ParameterizedTest
    @CsvSource({"250, 0.935", "500, 0.764", "1000, 0.341", "2000, 0.0135"})
    void pathsLoseStep(double frequency, double coherence) {
        assertThat(TurbulentCoherence.MODERATE.at(frequency, SOUND_SPEED, 500, 30, 1.5))
                .isCloseTo(coherence, within(5e-4));
    }

    /**
     * Near the source, where waves follow their rays, the mean of the product of two waves is {@code exp(-D / 2)}, and
     * D, the variance of the difference of their phases, is an integral of the correlation of the refractive index
     * along both rays: here summed by brute force.
     */
    @ParameterizedTest
    @CsvSource({"100, 2, 500", "60, 0.5, 1000", "200, 4, 250"})
    void isTheMeanOverAllPhases(double length, double apart, double frequency) {
        TurbulentCoherence air = new TurbulentCoherence(5e-6, 1.1);
        int steps = 4000;
        double step = length / steps;
        double variance = 0.0;
        for (int i = 0; i < steps; i++) {
            double atI = (i + 0.5) * step;
            for (int j = 0; j < steps; j++) {
                double along = (i - j) * step;
                if (Math.abs(along) > 6 * air.scale()) {
                    continue;
                }
                double atJ = (j + 0.5) * step;
                // Two straight rays from one point, whose distance grows to that at their ends.
                double same = 0.5 * apart * (atI - atJ) / length;
                double other = 0.5 * apart * (atI + atJ) / length;
                variance += 2.0 * (correlation(along, same, air) - correlation(along, other, air));
            }
        }
        double k = 2 * Math.PI * frequency / SOUND_SPEED;
        variance *= k * k * step * step;
        // Of two heights h and h, the distance between the paths is h.
        assertThat(air.at(frequency, SOUND_SPEED, length, apart, apart))
                .isCloseTo(Math.exp(-0.5 * variance), within(2e-3));
    }

    private static double correlation(double along, double across, TurbulentCoherence air) {
        return air.strength() * Math.exp(-(along * along + across * across) / (air.scale() * air.scale()));
    }

    @Test
    void stillAirAndPathsAlongTheGroundStayInStep() {
        assertThat(new TurbulentCoherence(0, 1.1).at(8000, SOUND_SPEED, 1000, 50, 2))
                .isEqualTo(1.0);
        assertThat(TurbulentCoherence.MODERATE.at(8000, SOUND_SPEED, 1000, 50, 0))
                .isEqualTo(1.0);
        assertThat(TurbulentCoherence.MODERATE.at(8000, SOUND_SPEED, 1000, 50, 1e-4))
                .isCloseTo(1.0, within(1e-4));
    }

    /** Where the series takes over, nothing jumps. */
    @Test
    void theSeriesJoinsTheFormula() {
        double below = TurbulentCoherence.MODERATE.exponent(1e6, 0.99e-3 * 1.1);
        double above = TurbulentCoherence.MODERATE.exponent(1e6, 1.01e-3 * 1.1);
        assertThat(above / below).isCloseTo(Math.pow(1.01 / 0.99, 2), within(1e-6));
    }

    /** However small the eddies, heights and strengths, it is a number from 0 to 1, and 1 in still air. */
    @Test
    void itIsACoherenceForEverything() {
        double[] values = {Double.MIN_VALUE, 1e-300, 1e-9, 1e-3, 1, 30, 1e3, 1e6};
        for (double scale : values) {
            for (double strength : new double[] {0, Double.MIN_VALUE, 1e-8, 1e-3}) {
                TurbulentCoherence air = new TurbulentCoherence(strength, scale);
                for (double source : values) {
                    for (double receiver : values) {
                        double left = air.at(8000, SOUND_SPEED, 500, source, receiver);
                        assertThat(left)
                                .as("%s, %s and %s m", air, source, receiver)
                                .isBetween(0.0, 1.0);
                        assertThat(strength > 0 || left == 1.0).isTrue();
                    }
                }
            }
        }
    }
}
