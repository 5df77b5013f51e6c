package org.dronewatch.sound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvFileSource;

class RefractionTest {

    @ParameterizedTest
    @CsvFileSource(resources = "refraction.csv", numLinesToSkip = 1)
    void wavesBendAndPassAsComputedIndependently(
            String from, String to, double incidence, Double behind, double transmitted) {
        Medium before = Media.get(from);
        Medium after = Media.get(to);
        double angle = Math.toRadians(incidence);

        assertThat(Refraction.transmitted(angle, before, after))
                .isCloseTo(transmitted, within(1e-9 * transmitted + 1e-15));
        if (behind == null) {
            assertThat(Refraction.angle(angle, before.speed(), after.speed())).isEmpty();
        } else {
            double degrees = Math.toDegrees(
                    Refraction.angle(angle, before.speed(), after.speed()).orElseThrow());
            assertThat(degrees).isCloseTo(behind, within(1e-9));
        }
    }

    @ParameterizedTest
    @CsvFileSource(resources = "refraction-normal.csv", numLinesToSkip = 1)
    void solidsTakeLittleFromTheAir(
            String name, double density, double speed, double transmitted, double loss, double critical) {
        Medium air = Media.get("air_20C");
        double share = Refraction.transmitted(0, air, new Medium(name, density, speed, "test"));

        assertThat(share).isCloseTo(transmitted, within(1e-9 * transmitted));
        assertThat(-Levels.ofRatio(share)).isCloseTo(loss, within(1e-9));
        assertThat(Math.toDegrees(Refraction.criticalAngle(air.speed(), speed).orElseThrow()))
                .isCloseTo(critical, within(1e-9));
    }

    @Test
    void theEndsOfTheRangeHold() {
        Medium air = Media.get("air_20C");
        assertThat(Refraction.transmitted(1.0, air, air)).isCloseTo(1.0, within(1e-12));
        assertThat(Refraction.transmitted(Math.PI / 2, Media.get("water_20C"), air))
                .isCloseTo(0.0, within(1e-12));
        assertThat(Refraction.criticalAngle(1482, 343.2)).isEmpty();
        assertThat(Refraction.criticalAngle(343.2, 343.2)).isEmpty();
    }

    /** Air's own rows against the formula of the standard and the ideal gas, to the digits that are printed. */
    @Test
    void theTableOfMediaIsSound() {
        int[] celsius = {0, 20, 30};
        for (int degrees : celsius) {
            Medium air = Media.get("air_" + degrees + "C");
            Atmosphere atmosphere = Atmosphere.STANDARD.withTemperature(degrees + 273.15);
            assertThat(air.speed()).isCloseTo(atmosphere.speedOfSound(), within(0.05));
            assertThat(air.density()).isCloseTo(101_325 / (287.058 * atmosphere.temperature()), within(5e-5));
        }
        assertThat(Media.names()).hasSize(14);
        for (String name : Media.names()) {
            assertThat(Media.get(name).source()).as(name).isNotBlank();
        }
    }

    @Test
    void whatIsNoMediumIsRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Medium("void", 0, 343, "test"))
                .withMessageContaining("density in kg/m3 of medium 'void' 0 must be above 0");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Medium("void", 1, -343, "test"))
                .withMessageContaining("-343 m/s must be above 0");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> Media.get("concret"))
                .withMessageContaining("unknown medium 'concret'")
                .withMessageContaining("concrete");
    }
}
