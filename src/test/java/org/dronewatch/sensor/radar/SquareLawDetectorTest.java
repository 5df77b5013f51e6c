package org.dronewatch.sensor.radar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.dronewatch.drone.RadarSignature.Fluctuation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A detector at the ends of its range: without an echo, with hardly one, and with one that is hardly ever missed. */
class SquareLawDetectorTest {
    private static final double FALSE_ALARM = 1e-6;

    @ParameterizedTest
    @ValueSource(ints = {1, 10, 1000})
    void withoutAnEchoOnlyFalseAlarmsAreLeft(int pulses) {
        SquareLawDetector detector = new SquareLawDetector(FALSE_ALARM, pulses);
        for (Fluctuation fluctuation : Fluctuation.values()) {
            assertThat(detector.probability(Double.NEGATIVE_INFINITY, fluctuation))
                    .isEqualTo(FALSE_ALARM);
            assertThat(detector.required(FALSE_ALARM, fluctuation)).isEqualTo(Double.NEGATIVE_INFINITY);
        }
    }

    /**
     * The energy E of a faint echo, over all N pulses, adds one to their number with the probability E, whatever the
     * fluctuation: the probability rises by {@code E (Q(N + 1, T) - Q(N, T)) = E exp(-T) T^N / N!}.
     */
    @ParameterizedTest
    @ValueSource(ints = {1, 10, 1000})
    void aFaintEchoAddsInProportionToItsEnergy(int pulses) {
        SquareLawDetector detector = new SquareLawDetector(FALSE_ALARM, pulses);
        double threshold = thresholdOfSum(pulses);
        double logRise = -threshold;
        for (int k = 1; k <= pulses; k++) {
            logRise += Math.log(threshold / k);
        }
        double energy = 1e-5;
        for (Fluctuation fluctuation : Fluctuation.values()) {
            double found = detector.probability(10 * Math.log10(energy / pulses), fluctuation) - FALSE_ALARM;
            assertThat(found / (energy * Math.exp(logRise)))
                    .as("%s", fluctuation)
                    .isCloseTo(1, within(1e-3));
        }
    }

    /** Where the sum of unit exponentials exceeds with the probability of a false alarm, by halving. */
    private static double thresholdOfSum(int pulses) {
        double low = 0;
        double high = 100 + 3.0 * pulses;
        for (int i = 0; i < 100; i++) {
            double middle = 0.5 * (low + high);
            double tail = 0;
            double logTerm = -middle;
            for (int k = 0; k < pulses; k++) {
                tail += Math.exp(logTerm);
                logTerm += Math.log(middle / (k + 1));
            }
            low = tail > FALSE_ALARM ? middle : low;
            high = tail > FALSE_ALARM ? high : middle;
        }
        return low;
    }

    /**
     * One pulse of a target of Swerling's case 3 exceeds T with the probability {@code exp(-a) (1 + a S / (2 + S))},
     * where {@code a = 2 T / (2 + S)} (Mahafza, Radar Systems Analysis): at 60 dB it is missed four times in 10^10.
     */
    @ParameterizedTest
    @ValueSource(doubles = {30, 40, 50, 60})
    void aStrongEchoIsMissedAsRarelyAsTheClosedFormSays(double decibels) {
        SquareLawDetector detector = new SquareLawDetector(FALSE_ALARM, 1);
        double ratio = Math.pow(10, 0.1 * decibels);
        double a = -2 * Math.log(FALSE_ALARM) / (2 + ratio);
        double missed = -Math.expm1(-a) - Math.exp(-a) * a * ratio / (2 + ratio);
        assertThat((1 - detector.probability(decibels, Fluctuation.SWERLING_3)) / missed)
                .isCloseTo(1, within(1e-4));
    }

    /** Also at ratios where a search might begin or end. */
    @ParameterizedTest
    @CsvSource({"1, 1e-6", "10, 1e-6", "1000, 1e-6", "1, 0.01", "10, 1e-12"})
    void aProbabilityNeedsTheRatioThatHasIt(int pulses, double falseAlarm) {
        SquareLawDetector detector = new SquareLawDetector(falseAlarm, pulses);
        int found = 0;
        for (Fluctuation fluctuation : Fluctuation.values()) {
            for (int ratio = -28; ratio <= 60; ratio++) {
                double probability = detector.probability(ratio, fluctuation);
                if (probability > 1.01 * falseAlarm && probability < 1 - 1e-6) {
                    assertThat(detector.required(probability, fluctuation))
                            .as("%s, %d dB", fluctuation, ratio)
                            .isCloseTo(ratio, within(1e-7));
                    found++;
                }
            }
        }
        assertThat(found).isGreaterThan(100);
    }

    /** The least and the greatest limits of the settings. */
    @Test
    void allOfItsRangeCanBeReached() {
        for (int pulses : new int[] {1, SquareLawDetector.MAX_PULSES}) {
            SquareLawDetector detector = new SquareLawDetector(1e-12, pulses);
            for (Fluctuation fluctuation : Fluctuation.values()) {
                for (double probability : new double[] {2e-12, 0.5, 1 - 1e-9}) {
                    double ratio = detector.required(probability, fluctuation);
                    assertThat(detector.probability(ratio, fluctuation) / probability)
                            .isCloseTo(1, within(1e-9));
                }
            }
        }
    }
}
