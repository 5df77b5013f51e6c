package org.dronewatch.sensor.rf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ManMadeNoiseTest {
    /**
     * By hand from ITU-R P.372-17 with lg 0.3 = -0.5229 and lg 250 = 2.3979, and from P.372-8 with lg 900 = 2.9542; the
     * lines of quiet rural areas end below 0 dB, the noise of the ground.
     */
    @ParameterizedTest
    @CsvSource({
        "CITY, 0.3e6, 91.2837",
        "CITY, 250e6, 10.3771",
        "BUSINESS, 0.3e6, 91.2837",
        "BUSINESS, 900e6, 7.9628",
        "RESIDENTIAL, 0.3e6, 86.9837",
        "RESIDENTIAL, 250e6, 6.0771",
        "RURAL, 0.3e6, 81.6837",
        "RURAL, 250e6, 0.7771",
        "QUIET_RURAL, 0.3e6, 68.5543",
        "QUIET_RURAL, 250e6, 0"
    })
    void theFiguresIncludeTheEdgesOfTheirRange(ManMadeNoise noise, double frequency, double decibels) {
        assertThat(10.0 * Math.log10(noise.ratio(frequency))).isCloseTo(decibels, within(1e-4));
        double outside = frequency < 1e6 ? Math.nextDown(frequency) : Math.nextUp(frequency);
        assertThat(noise.ratio(outside)).isEqualTo(1.0);
    }
}
