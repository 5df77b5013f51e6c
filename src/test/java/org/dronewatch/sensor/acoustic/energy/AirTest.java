package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.OctaveBands;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class AirTest {
    private static final double ROUNDING = 1e-12;
    private static final long SEED = 20261123;

    /** From air in which 8 kHz loses 0.05 dB/m to dry air in which it loses four times as much. */
    @ParameterizedTest
    @CsvSource({"20, 0.7", "-10, 0.5", "20, 0.1", "50, 1"})
    void whatIsLeftAfterAnyDistanceIsTheExponential(double celsius, double humidity) {
        Air air = new Air(new Atmosphere(273.15 + celsius, humidity, 101_325.0));
        SplittableRandom random = new SplittableRandom(SEED);
        for (int i = 0; i < 20_000; i++) {
            // Logarithmic, from a millimetre to 10 km: within the table, at its end and beyond it.
            double distance = Math.pow(10.0, -3.0 + 7.0 * random.nextDouble());
            double[] energies = new double[OctaveBands.COUNT];
            Arrays.fill(energies, 1.0);
            double[] absorbed = new double[OctaveBands.COUNT];
            air.attenuate(energies, distance, absorbed);
            for (int band = 0; band < energies.length; band++) {
                double left = air.left(band, distance);
                assertThat(energies[band])
                        .as("band %d after %s m, seed %d", band, distance, SEED)
                        .isCloseTo(left, within(ROUNDING * left));
                assertThat(absorbed[band])
                        .as("what the air takes from band %d over %s m, seed %d", band, distance, SEED)
                        .isEqualTo(1.0 - energies[band]);
            }
        }
    }

    @Test
    void nothingIsLostOnTheSpot() {
        Air air = new Air(Atmosphere.STANDARD);
        double[] energies = {1, 2, 3, 4, 5, 6, 7, 8};
        double[] absorbed = {8, 7, 6, 5, 4, 3, 2, 1};
        air.attenuate(energies, 0.0, absorbed);
        assertThat(absorbed).as("what was absorbed before").containsExactly(8, 7, 6, 5, 4, 3, 2, 1);
        assertThat(energies).containsExactly(1, 2, 3, 4, 5, 6, 7, 8);
    }
}
