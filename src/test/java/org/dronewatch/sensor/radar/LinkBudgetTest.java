package org.dronewatch.sensor.radar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.dronewatch.drone.RadarSignature.Fluctuation;
import org.dronewatch.sensor.radar.LinkBudget.DataSheet;
import org.dronewatch.sensor.radar.LinkBudget.Hardware;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The radar equation (Skolnik, Radar Handbook) against values that follow by hand, and its laws. */
class LinkBudgetTest {
    /**
     * 1 kW, 30 dBi, 1 us: a noise bandwidth of 1 MHz; at 10 GHz 0.01 m2 in 3 km give 11.45 dB. In decibels: power 30,
     * gains 60, wavelength squared -30.46, cross-section -20, (4 pi)^3 -32.98, r^4 -139.08, k T0 B 143.98.
     */
    private static final Hardware TEXTBOOK = new Hardware(1000, 30, 1e-6, 10e6, 0, 0);

    @Test
    void theEquationGivesItsValues() {
        assertThat(TEXTBOOK.signalToNoise(10e9, 0.01, 3000)).isCloseTo(11.45, within(0.005));
        assertThat(new Hardware(4, 33, 1e-6, 10e6, 0, 0).signalToNoise(16.5e9, 0.01, 8000))
                .isCloseTo(-27.9, within(0.05));
        assertThat(new Hardware(4, 33, 0.02, 10e6, 0, 0).signalToNoise(16.5e9, 0.01, 8000))
                .isCloseTo(15.1, within(0.05));
        assertThat(new Hardware(4, 33, 0.02, 10e6, 5, 2.5).signalToNoise(16.5e9, 0.01, 8000))
                .isCloseTo(new Hardware(4, 33, 0.02, 10e6, 0, 0).signalToNoise(16.5e9, 0.01, 8000) - 7.5, within(1e-9));
    }

    /** What is not stated is neither free of noise nor of losses. */
    @Test
    void unlessStatedAReceiverHasNoiseAndLosses() {
        assertThat(Hardware.of(4, 33, 0.02)).isEqualTo(new Hardware(4, 33, 0.02, 10e6, 5, 6));
        assertThat(TEXTBOOK.signalToNoise(10e9, 0.01, 3000)
                        - Hardware.of(1000, 30, 1e-6).signalToNoise(10e9, 0.01, 3000))
                .isCloseTo(11.0, within(1e-9));
    }

    /**
     * What 6 dB consist of, each part computed from its definition: the energy of all looks at a target that a Gaussian
     * beam passes, over that of as many at its peak within its half-power width, one way (Barton's beam-shape loss, in
     * two directions); the noise bandwidth of Hamming weighting (Harris 1978: 1.36 bins), in range and in speed; and
     * the loss of a threshold from 32 cells, whose probabilities have closed forms for Swerling's first case (Finn and
     * Johnson 1968).
     */
    @Test
    void theDefaultLossesAreThoseOfProcessing() {
        double passed = 0;
        double weights = 0;
        double squares = 0;
        for (int i = 0; i < 100_000; i++) {
            double offset = -5 + 1e-4 * (i + 0.5);
            passed += 1e-4 * Math.pow(0.5, 2 * Math.pow(2 * offset, 2));
            double weight = 0.54 - 0.46 * Math.cos(2 * Math.PI * (i + 0.5) / 100_000);
            weights += weight;
            squares += weight * weight;
        }
        double beam = -2 * 10 * Math.log10(passed);
        double hamming = 10 * Math.log10(100_000 * squares / (weights * weights));
        int cells = 32;
        double falseAlarm = 1e-6;
        double probability = 0.9;
        // A fraction of the sum of the cells is exceeded by noise with (1 + a)^-32, by an echo with (1 + a/(1 +
        // S))^-32.
        double scale = Math.pow(falseAlarm, -1.0 / cells) - 1;
        double estimated = scale / (Math.pow(probability, -1.0 / cells) - 1) - 1;
        double known = Math.log(falseAlarm) / Math.log(probability) - 1;
        double cfar = 10 * Math.log10(estimated / known);

        assertThat(beam).isCloseTo(2.47, within(0.005));
        assertThat(hamming).isCloseTo(1.34, within(0.005));
        assertThat(cfar).isCloseTo(0.97, within(0.005));
        assertThat(Hardware.of(4, 33, 0.02).losses()).isCloseTo(beam + 2 * hamming + cfar, within(0.2));
        assertThat(10 * Math.log10(known))
                .isCloseTo(Detectability.required(probability, falseAlarm, Fluctuation.SWERLING_1), within(1e-9));
    }

    @Test
    void anotherAntennaReceives() {
        Hardware one = new Hardware(4, 33, 0.02, 10e6, 0, 0);
        double difference =
                one.withReceiveGain(21.5).signalToNoise(16.5e9, 0.01, 8000) - one.signalToNoise(16.5e9, 0.01, 8000);
        assertThat(difference).isCloseTo(21.5 - 33, within(1e-9));
        assertThat(one.withReceiveGain(33).signalToNoise(16.5e9, 0.01, 8000))
                .isEqualTo(one.signalToNoise(16.5e9, 0.01, 8000));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> one.withReceiveGain(81))
                .withMessageContaining("receiveGain 81");
    }

    @Test
    void theEchoFallsWithTheFourthPowerOfTheRange() {
        double near = TEXTBOOK.signalToNoise(10e9, 0.01, 1000);
        assertThat(TEXTBOOK.signalToNoise(10e9, 0.01, 2000) - near).isCloseTo(-12.0412, within(1e-4));
        assertThat(TEXTBOOK.range(10e9, 0.001, 13) / TEXTBOOK.range(10e9, 0.01, 13))
                .isCloseTo(0.5623, within(5e-5));
        assertThat(TEXTBOOK.signalToNoise(10e9, 0.01, TEXTBOOK.range(10e9, 0.01, 13)))
                .isCloseTo(13, within(1e-9));
    }

    /** {@code c / (2 B t)}: 10 MHz and 20 ms give 749.5 m/s. */
    @Test
    void aFastEchoLeavesItsRangeCell() {
        assertThat(new Hardware(4, 33, 0.02, 10e6, 0, 0).migrationSpeed()).isCloseTo(749.5, within(0.05));
        assertThat(DataSheet.of(1000, 1).migrationSpeed()).isInfinite();
    }

    /** A walker of 1 m2 at 1050 m: a drone of 0.01 m2 is detected as surely at 332 m. */
    @Test
    void aDataSheetGivesTheGainOfTheLoop() {
        DataSheet sheet = DataSheet.of(1050, 1);
        assertThat(sheet.signalToNoise(10e9, 1, 1050)).isCloseTo(13.1835, within(1e-4));
        assertThat(sheet.range(10e9, 0.01, 13.18349)).isCloseTo(332, within(0.1));
        assertThat(new DataSheet(1050, 1, 0.9, 1e-6, Fluctuation.SWERLING_1).signalToNoise(10e9, 1, 1050))
                .isCloseTo(21.1436, within(1e-4));
    }

    /** What a data sheet promises is met whatever the number of pulses: their gain is part of the promise. */
    @ParameterizedTest
    @CsvSource({"STEADY, 1", "STEADY, 10", "SWERLING_1, 10", "SWERLING_4, 1000"})
    void aDataSheetIncludesTheGainOfItsPulses(Fluctuation fluctuation, int pulses) {
        double echo = new DataSheet(1050, 1, 0.9, 1e-6, fluctuation)
                .echo(10e9, pulses)
                .applyAsDouble(1, 1050);
        assertThat(new RadarDetection.Chance(1e-6, pulses).on(fluctuation).probability(echo))
                .isCloseTo(0.9, within(1e-9));
    }

    /** Blake's fluctuation loss at 90 % and one false alarm in a million: 21.1436 - 13.1835 dB, range times 0.63. */
    @Test
    void aFixedThresholdIsHigherForATargetThatFluctuates() {
        RadarDetection.Decision one = new RadarDetection.FixedThreshold(13.1835).on(Fluctuation.SWERLING_1);
        assertThat(one.evenThreshold()).isCloseTo(21.1436, within(1e-4));
        assertThat(one.probability(21.143)).isZero();
        assertThat(one.probability(21.144)).isEqualTo(1.0);
        assertThat(Math.pow(10.0, -(one.evenThreshold() - 13.1835) / 40.0)).isCloseTo(0.632, within(5e-4));
        assertThat(new RadarDetection.FixedThreshold(15.0)
                        .on(Fluctuation.STEADY)
                        .evenThreshold())
                .isEqualTo(15.0);
    }

    @Test
    void settingsHaveLimits() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Hardware(0, 30, 0.02, 10e6, 0, 0))
                .withMessageContaining("power 0 W must be 1e-9 to 1e9");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> DataSheet.of(1000, -1))
                .withMessageContaining("crossSection -1 m2");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new DataSheet(1000, 1, 1, 1e-6, Fluctuation.STEADY))
                .withMessageContaining("probability 1 must be 0.1 to 0.99");
    }
}
