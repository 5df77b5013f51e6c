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

        assertThat(Barrier.maekawa(difference, wavelength)).isCloseTo(maekawa, within(1e-9));
        assertThat(Barrier.iso9613(difference, wavelength)).isCloseTo(Math.min(20, iso), within(1e-9));
    }

    @Test
    void whereTheSourceIsSeenWellAboveTheEdgeNothingIsTaken() {
        assertThat(Barrier.maekawa(-0.05, 1.0)).isCloseTo(0.0, within(1e-9));
        assertThat(Barrier.maekawa(-0.025, 1.0)).isBetween(0.1, 4.77);
        assertThat(Barrier.maekawa(-1.0, 1.0)).isZero();
        assertThat(Barrier.iso9613(-1.0, 1.0)).isZero();
    }

    @Test
    void aSingleEdgeTakesAtMostTwentyDecibelsInTheStandard() {
        assertThat(Barrier.iso9613(10, 0.05)).isEqualTo(20);
        assertThat(Barrier.fresnelNumber(0.5, 0.25)).isEqualTo(4);
    }
}
