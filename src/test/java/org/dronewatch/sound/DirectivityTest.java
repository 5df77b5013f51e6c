package org.dronewatch.sound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class DirectivityTest {

    /** Check values of the published formula: -4.9 dB in the rotors' plane, 1.6 at 45 degrees, 3.65 above and below. */
    @ParameterizedTest
    @CsvSource({"0, -4.9", "45, 1.6025", "-45, 1.6025", "90, 3.65", "-90, 3.65"})
    void rotorsSoundUpAndDown(double degrees, double gain) {
        double elevation = Math.toRadians(degrees);
        for (int band = 4; band < OctaveBands.COUNT; band++) {
            assertThat(Directivity.ROTOR.publishedGain(band, elevation)).isCloseTo(gain, within(1e-9));
        }
        assertThat(Directivity.ROTOR.publishedGain(3, elevation)).isCloseTo(gain / 2, within(1e-9));
        for (int band = 0; band < 3; band++) {
            assertThat(Directivity.ROTOR.publishedGain(band, elevation)).isZero();
        }
    }

    /** The power through a sphere around the source is the source's, summed here over rings of elevation. */
    @ParameterizedTest
    @EnumSource(Directivity.class)
    void directionsShareThePowerAndAddNone(Directivity directivity) {
        int rings = 1800;
        double step = Math.PI / rings;
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            double energy = 0;
            for (int ring = 0; ring < rings; ring++) {
                double elevation = -Math.PI / 2 + (ring + 0.5) * step;
                energy += Levels.toRatio(directivity.index(band, elevation)) * Math.cos(elevation) * step / 2;
            }
            assertThat(Levels.ofRatio(energy)).isCloseTo(0.0, within(1e-4));
        }
    }
}
