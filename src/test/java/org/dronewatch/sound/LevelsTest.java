package org.dronewatch.sound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class LevelsTest {

    @Test
    void soundsAddAsEnergies() {
        assertThat(Levels.sum(60, 60)).isCloseTo(63.0103, within(5e-5));
        assertThat(Levels.sum(60, 50)).isCloseTo(60.4139, within(5e-5));
        assertThat(Levels.sum(60, 57, 54)).isCloseTo(62.4363, within(5e-5));
        assertThat(Levels.sum()).isEqualTo(Double.NEGATIVE_INFINITY);
    }

    @Test
    void ratiosAndLevelsAreEachOthersInverse() {
        for (double level = -80; level <= 140; level += 7.3) {
            assertThat(Levels.ofRatio(Levels.toRatio(level))).isCloseTo(level, within(1e-9));
        }
    }

    @Test
    void spreadingTakesSixDecibelsADoubling() {
        assertThat(Levels.sphericalSpreading(1)).isCloseTo(10.992, within(5e-4));
        assertThat(Levels.sphericalSpreading(20) - Levels.sphericalSpreading(10))
                .isCloseTo(6.0206, within(5e-5));
        assertThat(100 - Levels.sphericalSpreading(1000)).isCloseTo(29.008, within(5e-4));
    }

    @Test
    void theBandsAreThoseOfTheStandard() {
        double[] midbands = {63.0957, 125.8925, 251.1886, 501.1872, 1000, 1995.2623, 3981.0717, 7943.2823};
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            assertThat(OctaveBands.midband(band)).isCloseTo(midbands[band], within(1e-4));
            assertThat((double) OctaveBands.nominal(band)).isCloseTo(midbands[band], within(0.01 * midbands[band]));
        }
    }
}
