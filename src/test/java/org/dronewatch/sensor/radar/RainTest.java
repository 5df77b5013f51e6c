package org.dronewatch.sensor.radar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.dronewatch.sensor.radar.Rain.Polarisation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** ITU-R P.838-3 against the ITU's own validation examples (CG-3M3J-13-ValEx rev. 5.1, sheet P838-3). */
class RainTest {
    @ParameterizedTest
    @CsvSource({
        "14.25, 31.07699124, 26.48052, 1.58130839",
        "14.25, 40.232036, 33.936232, 2.061732",
        "29, 31.076991, 26.480520, 5.021802"
    })
    void theValidationExamplesAreMet(double gigahertz, double elevation, double rate, double loss) {
        double attenuation =
                Rain.attenuation(1e9 * gigahertz, rate, Math.toRadians(elevation), Polarisation.HORIZONTAL);
        assertThat(1000 * attenuation).isCloseTo(loss, within(1e-6));
    }

    /** Values computed independently, dB/km. */
    @ParameterizedTest
    @CsvSource({
        "10, 4, .0695",
        "10, 25, .6959",
        "10, 50, 1.663",
        "16.5, 4, .263",
        "16.5, 50, 4.246",
        "24, 25, 3.680",
        "35, 50, 11.620"
    })
    void levelPathsAgree(double gigahertz, double rate, double loss) {
        assertThat(1000 * Rain.attenuation(1e9 * gigahertz, rate, 0, Polarisation.HORIZONTAL))
                .isCloseTo(loss, within(6e-4 * Math.max(1, loss)));
    }

    @Test
    void uprightWavesSufferLessAndCirclesLieBetween() {
        double level = Rain.attenuation(16.5e9, 25, 0, Polarisation.HORIZONTAL);
        double upright = Rain.attenuation(16.5e9, 25, 0, Polarisation.VERTICAL);
        double circle = Rain.attenuation(16.5e9, 25, 0, Polarisation.CIRCULAR);
        assertThat(upright).isLessThan(circle);
        assertThat(circle).isLessThan(level);
        assertThat(Rain.attenuation(16.5e9, 0, 0, Polarisation.VERTICAL)).isZero();
    }

    @Test
    void outsideItsFrequenciesNothingIsKnown() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Rain.attenuation(0.5e9, 5, 0, Polarisation.VERTICAL))
                .withMessageContaining("frequency 500000000 Hz must be 1000000000 to 1.0E12");
    }
}
