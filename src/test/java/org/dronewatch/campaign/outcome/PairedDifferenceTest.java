package org.dronewatch.campaign.outcome;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.dronewatch.statistics.Proportion.Interval;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class PairedDifferenceTest {
    /** Two tails of the binomial distribution: 2 (1 + 12 + 66) / 2^12 for 10 against 2, and so on. */
    @ParameterizedTest
    @CsvSource({"10, 2, .0385742", "2, 10, .0385742", "15, 5, .0413895", "1, 0, 1", "6, 0, .03125", "5, 5, 1", "0, 0, 1"
    })
    void mcNemarsExactTest(int onlyA, int onlyB, double p) {
        assertThat(new PairedDifference(onlyA, onlyB, 100).pValue()).isCloseTo(p, within(5e-8));
    }

    @Test
    void theTestIsTheSumOfTheBinomialTails() {
        for (int n = 1; n < 40; n++) {
            for (int a = 0; a <= n; a++) {
                double tail = 0.0;
                double term = Math.pow(0.5, n);
                for (int k = 0; k <= Math.min(a, n - a); k++) {
                    tail += term;
                    term *= (n - k) / (k + 1.0);
                }
                assertThat(new PairedDifference(a, n - a, n).pValue())
                        .isCloseTo(Math.min(1.0, 2.0 * tail), within(1e-12));
            }
        }
    }

    @Test
    void equalVariantsDoNotDiffer() {
        PairedDifference same = new PairedDifference(0, 0, 1000);

        assertThat(same.difference()).isZero();
        assertThat(same.interval(0.95).contains(0.0)).isTrue();
        assertThat(same.interval(0.95).high()).isLessThan(0.003);
    }

    @Test
    void theIntervalContainsTheDifferenceAsOftenAsItSays() {
        long seed = 20260702;
        SplittableRandom random = new SplittableRandom(seed);
        int held = 0;
        for (int campaign = 0; campaign < 1000; campaign++) {
            double a = random.nextDouble(0.02, 0.3);
            double b = random.nextDouble(0.02, 0.3);
            int onlyA = 0;
            int onlyB = 0;
            for (int i = 0; i < 200; i++) {
                double u = random.nextDouble();
                onlyA += u < a ? 1 : 0;
                onlyB += u >= a && u < a + b ? 1 : 0;
            }
            Interval interval = new PairedDifference(onlyA, onlyB, 200).interval(0.95);
            held += interval.contains(a - b) ? 1 : 0;
        }
        assertThat(held).as("seed %d", seed).isBetween(930, 970);
    }

    @Test
    void discordantCasesAreCases() {
        assertThatThrownBy(() -> new PairedDifference(6, 5, 10)).hasMessage("6 and 5 discordant cases among 10");
    }
}
