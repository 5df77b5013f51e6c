package org.dronewatch.sensor.radar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.dronewatch.drone.RadarSignature.Fluctuation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Signal-to-noise ratios and probabilities against published values, closed forms and a simulated detector. */
class DetectabilityTest {
    private static final long SEED = 20_261_121;
    private static final int LOOKS = 200_000;

    /** Steady: 13.18349005679 as the documentation of {@code sdr.min_snr} (M. Hostetter) prints; the others closed forms. */
    @ParameterizedTest
    @CsvSource({"STEADY, 13.18349005679, 1e-9", "SWERLING_1, 21.1436, 5e-5", "SWERLING_3, 17.296, 5e-4"})
    void nineOfTenLooksAtOneFalseAlarmInAMillion(Fluctuation fluctuation, double ratio, double tolerance) {
        assertThat(Detectability.required(0.9, 1e-6, fluctuation)).isCloseTo(ratio, within(tolerance));
    }

    @ParameterizedTest
    @CsvSource({
        "0.9, 1e-6, 1, 13.115",
        "0.9, 1e-6, 10, 4.990",
        "0.5, 1e-6, 1, 11.232",
        "0.9, 1e-4, 1, 11.674",
        "0.9, 1e-3, 1, 10.723"
    })
    void albersheimsEquationGivesItsValues(double probability, double falseAlarm, int pulses, double ratio) {
        assertThat(Detectability.albersheim(probability, falseAlarm, pulses)).isCloseTo(ratio, within(6e-4));
    }

    @ParameterizedTest
    @CsvSource({"STEADY, 1, 13.12", "SWERLING_1, 1, 21.35", "SWERLING_3, 1, 17.23", "SWERLING_1, 10, 13.58"})
    void shnidmansEquationGivesItsValues(Fluctuation fluctuation, int pulses, double ratio) {
        assertThat(Detectability.shnidman(0.9, 1e-6, fluctuation, pulses)).isCloseTo(ratio, within(6e-3));
    }

    @ParameterizedTest
    @CsvSource({
        "15, STEADY, 0.9972",
        "15, SWERLING_1, 0.6548",
        "15, SWERLING_3, 0.7794",
        "13, STEADY, 0.8744",
        "13, SWERLING_1, 0.5172",
        "13, SWERLING_3, 0.6090"
    })
    void aRatioGivesItsProbability(double ratio, Fluctuation fluctuation, double probability) {
        assertThat(Detectability.probability(ratio, 1e-6, fluctuation)).isCloseTo(probability, within(6e-5));
    }

    @ParameterizedTest
    @CsvSource({"STEADY", "SWERLING_1", "SWERLING_3"})
    void ratioAndProbabilityAreEachOthersInverse(Fluctuation fluctuation) {
        for (double falseAlarm : new double[] {1e-12, 1e-6, 1e-2}) {
            assertThat(Detectability.probability(-60, falseAlarm, fluctuation)).isCloseTo(falseAlarm, within(1e-6));
            double before = Double.NEGATIVE_INFINITY;
            for (double probability : new double[] {0.02, 0.1, 0.5, 0.9, 0.99, 0.999999}) {
                double ratio = Detectability.required(probability, falseAlarm, fluctuation);
                assertThat(ratio).isGreaterThan(before);
                assertThat(Detectability.probability(ratio, falseAlarm, fluctuation))
                        .isCloseTo(probability, within(1e-9));
                before = ratio;
            }
        }
        assertThat(Detectability.required(1e-7, 1e-6, fluctuation)).isEqualTo(Double.NEGATIVE_INFINITY);
        assertThat(Detectability.probability(90, 1e-6, fluctuation)).isCloseTo(1.0, within(1e-4));
    }

    /**
     * A square-law detector with noise and targets drawn from their distributions, one look and four pulses summed. The
     * ratio is as exact as its authors say: Albersheim to 0.2 dB, Shnidman to 0.5 dB.
     */
    @ParameterizedTest
    @CsvSource({
        "STEADY, 1, 0.01",
        "SWERLING_1, 1, 0.01",
        "SWERLING_3, 1, 0.01",
        "STEADY, 4, 0.2",
        "SWERLING_1, 4, 0.5",
        "SWERLING_3, 4, 0.5"
    })
    void aSimulatedDetectorAgrees(Fluctuation fluctuation, int pulses, double decibels) {
        double falseAlarm = 1e-3;
        double chance = 4 * Math.sqrt(0.25 / LOOKS);
        for (double probability : new double[] {0.3, 0.6, 0.85}) {
            double ratio = Detectability.required(probability, falseAlarm, fluctuation, pulses);
            assertThat(simulated(ratio - decibels, falseAlarm, fluctuation, pulses))
                    .as("seed %d, probability %f", SEED, probability)
                    .isLessThan(probability + chance);
            assertThat(simulated(ratio + decibels, falseAlarm, fluctuation, pulses))
                    .as("seed %d, probability %f", SEED, probability)
                    .isGreaterThan(probability - chance);
        }
    }

    private static double simulated(double decibels, double falseAlarm, Fluctuation fluctuation, int pulses) {
        double ratio = Math.pow(10, 0.1 * decibels);
        double threshold = thresholdOfSum(falseAlarm, pulses);
        SplittableRandom random = new SplittableRandom(SEED);
        int detected = 0;
        for (int look = 0; look < LOOKS; look++) {
            double amplitude = Math.sqrt(ratio * strength(fluctuation, random));
            double sum = 0;
            for (int pulse = 0; pulse < pulses; pulse++) {
                double real = amplitude + random.nextGaussian() / Math.sqrt(2);
                double imaginary = random.nextGaussian() / Math.sqrt(2);
                sum += real * real + imaginary * imaginary;
            }
            detected += sum > threshold ? 1 : 0;
        }
        return (double) detected / LOOKS;
    }

    private static double strength(Fluctuation fluctuation, SplittableRandom random) {
        return switch (fluctuation) {
            case STEADY -> 1.0;
            case SWERLING_1 -> random.nextExponential();
            case SWERLING_3 -> 0.5 * (random.nextExponential() + random.nextExponential());
        };
    }

    /** Where the sum of unit exponentials exceeds with a probability: the tail of the Erlang distribution, halved in. */
    private static double thresholdOfSum(double probability, int pulses) {
        double low = 0;
        double high = 100;
        for (int i = 0; i < 100; i++) {
            double middle = 0.5 * (low + high);
            double tail = 0;
            double term = Math.exp(-middle);
            for (int k = 0; k < pulses; k++) {
                tail += term;
                term *= middle / (k + 1);
            }
            low = tail > probability ? middle : low;
            high = tail > probability ? high : middle;
        }
        return low;
    }

    @Test
    void summingPulsesHelpsAlwaysAndWithoutAStep() {
        for (Fluctuation fluctuation : Fluctuation.values()) {
            double before = Double.NEGATIVE_INFINITY;
            for (double probability = 0.005; probability < 0.9995; probability += 0.001) {
                double summed = Detectability.required(probability, 1e-6, fluctuation, 10);
                assertThat(summed).isLessThan(Detectability.required(probability, 1e-6, fluctuation) - 4);
                assertThat(summed).as("%s %f", fluctuation, probability).isGreaterThan(before);
                before = summed;
            }
        }
    }
}
