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

    /**
     * As the first edge and the last come together, C3 of ISO 9613-2 (7.4, equation 15) becomes 1, that of one edge:
     * what remains is the limit, which the standard sets at 20 dB for one edge and at 25 dB for two (7.4).
     */
    @Test
    void edgesThatComeTogetherAreOneButForTheStandardsLimit() {
        for (double difference : new double[] {0.0, 0.01, 0.1, 0.5}) {
            double one = Barrier.iso9613(difference, 0.0, 0.7);
            assertThat(Barrier.iso9613(difference, 1e-2, 0.7)).isCloseTo(one, within(1e-4));
            assertThat(Barrier.iso9613(difference, 1e-9, 0.7)).isCloseTo(one, within(1e-9));
        }
        assertThat(Barrier.iso9613(10, 0.0, 0.1)).isEqualTo(20);
        assertThat(Barrier.iso9613(10, 1e-9, 0.1)).isEqualTo(25);
    }

    /**
     * CNOSSOS-EU counts edges up to 0.3 m apart as one (Directive (EU) 2015/996, 2.5.6: C'' = 1 for e of less than
     * 0.3 m): there the method itself has a step, of 2.5 dB at 8 kHz and less below.
     */
    @Test
    void cnossosHasAStepWhereEdgesBecomeOne() {
        double before = 0;
        for (double frequency : new double[] {63, 250, 1000, 4000, 7943}) {
            double wavelength = SPEED / frequency;
            double difference = 3 * wavelength;
            double step =
                    Barrier.cnossos(difference, 0.3 + 1e-9, wavelength) - Barrier.cnossos(difference, 0.3, wavelength);
            double square = Math.pow(5 * wavelength / 0.3, 2);
            double factor = (1 + square) / (1.0 / 3 + square);
            assertThat(step).isCloseTo(10 * Math.log10((3 + 120 * factor) / 123), within(1e-6));
            assertThat(step).isBetween(before, 2.5);
            before = step;
        }
        assertThat(before).isGreaterThan(2.4);
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
