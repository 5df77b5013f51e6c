package org.dronewatch.sound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvFileSource;

class BarrierTest {
    private static final double SPEED = 343.2;

    @ParameterizedTest
    @CsvFileSource(resources = "barrier.csv", numLinesToSkip = 1)
    void anIndependentImplementationAgrees(double frequency, double difference, double maekawa, double iso) {
        double wavelength = SPEED / frequency;

        assertThat(Barrier.maekawa(difference, wavelength)).isCloseTo(Math.min(25, maekawa), within(1e-9));
        assertThat(Barrier.iso9613(difference, 0.0, wavelength)).isCloseTo(Math.min(20, iso), within(1e-9));
    }

    @Test
    void whereTheSourceIsSeenWellAboveTheEdgeNothingIsTaken() {
        assertThat(Barrier.maekawa(-0.05, 1.0)).isCloseTo(0.0, within(1e-9));
        assertThat(Barrier.maekawa(-0.025, 1.0)).isBetween(0.1, 4.77);
        assertThat(Barrier.maekawa(-1.0, 1.0)).isZero();
        assertThat(Barrier.iso9613(-1.0, 0.0, 1.0)).isZero();
    }

    @Test
    void aSingleEdgeTakesAtMostTwentyDecibelsInTheStandard() {
        assertThat(Barrier.iso9613(10, 0.0, 0.05)).isEqualTo(20);
        assertThat(Barrier.fresnelNumber(0.5, 0.25)).isEqualTo(4);
    }

    @ParameterizedTest
    @CsvFileSource(resources = "several-edges.csv", numLinesToSkip = 1)
    void severalEdgesTakeMore(double frequency, double difference, double span, double iso, double cnossos) {
        double wavelength = SPEED / frequency;

        assertThat(Barrier.iso9613(difference, span, wavelength)).isCloseTo(iso, within(1e-9));
        assertThat(Barrier.cnossos(difference, span, wavelength)).isCloseTo(cnossos, within(1e-9));
    }

    /** The border of the shadow, and where edges cease to matter: N = -0.1, in ISO 9613-2 N = -0.2. */
    @Test
    void atTheBorderAllTake477AndNothingBeyondTheirReach() {
        for (double wavelength : new double[] {5.4, 0.3, 0.04}) {
            assertThat(Barrier.maekawa(0, wavelength)).isCloseTo(4.7712, within(1e-4));
            assertThat(Barrier.cnossos(0, 0, wavelength)).isCloseTo(4.7712, within(1e-4));
            assertThat(Barrier.iso9613(0, 0, wavelength)).isCloseTo(4.7712, within(1e-4));
            double reach = Barrier.MAEKAWA_REACH * wavelength;
            assertThat(Barrier.maekawa(-0.99 * reach, wavelength)).isGreaterThan(0);
            assertThat(Barrier.maekawa(-1.01 * reach, wavelength)).isZero();
            assertThat(Barrier.cnossos(-1.01 * reach, 0, wavelength)).isZero();
            double iso = Barrier.ISO_REACH * wavelength;
            assertThat(Barrier.iso9613(-0.99 * iso, 0, wavelength)).isGreaterThan(0);
            assertThat(Barrier.iso9613(-1.01 * iso, 0, wavelength)).isZero();
        }
    }
}
