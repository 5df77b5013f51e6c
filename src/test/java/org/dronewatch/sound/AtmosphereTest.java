package org.dronewatch.sound;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.aggregator.ArgumentsAccessor;
import org.junit.jupiter.params.provider.CsvFileSource;
import org.junit.jupiter.params.provider.CsvSource;

class AtmosphereTest {
    private static final int FIRST_BAND = 3;

    private static Atmosphere air(ArgumentsAccessor row) {
        return new Atmosphere(row.getDouble(0) + 273.15, row.getDouble(1) / 100, 1000 * row.getDouble(2));
    }

    /**
     * Densities of dry air at sea level and at 1500 m (ICAO standard atmosphere, Doc 7488: 1.2250 and 1.0581 kg/m3),
     * and of air at 20 degrees and 50 % (CIPM-2007, Picard and others, Metrologia 45, 149, 2008, with 400 ppm of CO2:
     * 1.1992). Real air is denser than an ideal gas by 0.04 %.
     */
    @ParameterizedTest
    @CsvSource({"15, 0, 101325, 1.2250", "5.25, 0, 84556, 1.0581", "20, 50, 101325, 1.1992"})
    void impedanceIsDensityTimesSpeed(double celsius, double percent, double pascal, double density) {
        Atmosphere air = new Atmosphere(celsius + 273.15, percent / 100, pascal);
        assertThat(air.impedance() / air.speedOfSound()).isCloseTo(density, within(6e-4));
    }

    /** Within a thousandth, or what the file's four decimals leave open. */
    @ParameterizedTest
    @CsvFileSource(resources = "iso9613-1.csv", numLinesToSkip = 1)
    void theAirAbsorbsAsTheStandardSays(ArgumentsAccessor row) {
        double[] losses = air(row).attenuations();
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            double expected = row.getDouble(FIRST_BAND + band);
            assertThat(1000 * losses[band])
                    .as("%d Hz", OctaveBands.nominal(band))
                    .isCloseTo(expected, within(Math.max(1e-3 * expected, 5e-5)));
        }
    }

    /**
     * Within the rounding of the printed digits (0.1 dB/km, whole ones above 100), but for the one cell that is known
     * to be rounded the wrong way: 15 degrees, 80 %, 1 kHz is 4.151 and printed as 4.1.
     */
    @ParameterizedTest
    @CsvFileSource(resources = "iso9613-2-table2.csv", numLinesToSkip = 1)
    void thePrintedTableAgrees(ArgumentsAccessor row) {
        double[] losses = air(row).attenuations();
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            double expected = row.getDouble(FIRST_BAND + band);
            boolean misprint = row.getDouble(0) == 15 && row.getDouble(1) == 80 && band == OctaveBands.ONE_KILOHERTZ;
            double rounding = (expected >= 100 ? 0.5 : 0.05) + (misprint ? 0.0015 : 1e-9);
            assertThat(1000 * losses[band])
                    .as("%d Hz", OctaveBands.nominal(band))
                    .isCloseTo(expected, within(rounding));
        }
    }

    @Test
    void soundIsFasterInWarmAir() {
        assertThat(Atmosphere.STANDARD.speedOfSound()).isCloseTo(343.2, within(1e-9));
        assertThat(Atmosphere.STANDARD.withTemperature(273.15).speedOfSound()).isCloseTo(331.3, within(0.05));
    }

    @Test
    void limitsAreNamed() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Atmosphere.STANDARD.withHumidity(-0.1))
                .withMessageContaining("humidity -0.1")
                .withMessageContaining("0 to 1");
        assertThatIllegalArgumentException().isThrownBy(() -> Atmosphere.STANDARD.withTemperature(20));
        assertThatIllegalArgumentException().isThrownBy(() -> Atmosphere.STANDARD.withPressure(1013.25));
    }
}
