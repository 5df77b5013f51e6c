package org.dronewatch.sound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class EmissionSettingsTest {
    private static final EmissionSettings QUADROTOR = EmissionSettings.ofClass("c1-quadrotor");

    @ParameterizedTest
    @CsvSource({
        "c1-quadrotor, 85",
        "c2-quadrotor-4kg, 97",
        "hexacopter, 100",
        "petrol-fixed-wing, 115",
        "gliding, 60",
    })
    void aKindIsAsLoudAsItsTableSays(String name, double level) {
        EmissionSettings emission = EmissionSettings.ofClass(name);

        assertThat(emission.power().aWeighted()).isCloseTo(level, within(1e-9));
        assertThat(emission.withAWeighted(80).power().aWeighted()).isCloseTo(80, within(1e-9));
        assertThat(emission.directivity()).isEqualTo(Directivity.OMNIDIRECTIONAL);
    }

    @Test
    void aMistypedKindIsAnsweredWithTheNearest() {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> EmissionSettings.ofClass("c1-quadcopter"))
                .withMessageContaining("c1-quadrotor");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> QUADROTOR.withPower(null))
                .withMessageContaining("power is missing");
    }

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
        EmissionSettings emission = QUADROTOR.withDirectivity(directivity);
        int rings = 1800;
        double step = Math.PI / rings;
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            double energy = 0;
            for (int ring = 0; ring < rings; ring++) {
                double elevation = -Math.PI / 2 + (ring + 0.5) * step;
                energy += Levels.toRatio(emission.level(band, elevation)) * Math.cos(elevation) * step / 2;
            }
            assertThat(Levels.ofRatio(energy)).isCloseTo(emission.power().level(band), within(1e-4));
        }
    }
}
