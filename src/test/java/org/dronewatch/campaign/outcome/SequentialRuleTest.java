package org.dronewatch.campaign.outcome;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.SplittableRandom;
import org.dronewatch.statistics.Proportion;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class SequentialRuleTest {
    /** Okamoto's numbers, ln(2/d) / (2 h^2), rounded up. */
    @ParameterizedTest
    @CsvSource({".05, .95, 738", ".01, .95, 18445", ".05, .99, 1060", ".5, .95, 8"})
    void thereIsALargestNumberOfCases(double halfWidth, double confidence, int most) {
        SequentialRule rule = new SequentialRule(halfWidth, confidence);

        assertThat(rule.most()).isEqualTo(most);
        for (double share = 0.0; share <= 1.0; share += 0.125) {
            assertThat(rule.stops(share, most)).isTrue();
        }
    }

    /** Where the share is p throughout: 2 ln(2/d) / h^2 (1/4 - (|p - 1/2| - 2h/3)^2), rounded up. */
    @ParameterizedTest
    @CsvSource({".9, 7031", ".99, 1210", ".1, 7031", ".01, 1210"})
    void theNumberOfCasesFollowsFromTheShare(double share, int cases) {
        SequentialRule rule = SequentialRule.of(0.01);

        assertThat(rule.stops(share, cases)).isTrue();
        assertThat(rule.stops(share, cases - 1)).isFalse();
    }

    /** Exactly, by the probabilities of all counts after each case that has not stopped. */
    @ParameterizedTest
    @ValueSource(doubles = {0.005, 0.03, 0.1, 0.27, 0.5, 0.65, 0.8, 0.93, 0.99, 0.999})
    void theIntervalContainsTheProbabilityAsOftenAsItSays(double p) {
        SequentialRule rule = SequentialRule.of(0.05);
        double[] running = {1.0};
        double held = 0.0;
        double stopped = 0.0;
        for (int n = 1; n <= rule.most(); n++) {
            double[] next = new double[n + 1];
            for (int k = 0; k < n; k++) {
                next[k] += running[k] * (1.0 - p);
                next[k + 1] += running[k] * p;
            }
            for (int k = 0; k <= n; k++) {
                Proportion proportion = new Proportion(k, n);
                if (rule.stops(proportion)) {
                    stopped += next[k];
                    held += rule.interval(proportion).contains(p) ? next[k] : 0.0;
                    next[k] = 0.0;
                }
            }
            running = next;
        }
        assertThat(stopped).isGreaterThan(1.0 - 1e-9);
        assertThat(held).isGreaterThanOrEqualTo(0.95);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.02, 0.3, 0.6, 0.9, 0.985})
    void overAThousandCampaignsTheIntervalHolds(double p) {
        long seed = 20260703;
        SplittableRandom random = new SplittableRandom(seed);
        SequentialRule rule = SequentialRule.of(0.05);
        int held = 0;
        for (int campaign = 0; campaign < 1000; campaign++) {
            Proportion proportion = new Proportion(0, 0);
            while (!rule.stops(proportion)) {
                proportion =
                        new Proportion(proportion.count() + (random.nextDouble() < p ? 1 : 0), proportion.of() + 1);
            }
            held += rule.interval(proportion).contains(p) ? 1 : 0;
        }
        assertThat(held).as("seed %d", seed).isGreaterThanOrEqualTo(940);
    }

    @Test
    void itNeedsAPrecisionThatAMillionCasesCanGive() {
        assertThat(new SequentialRule(0.002, 0.999).most()).isLessThan(1_000_000);
        assertThatThrownBy(() -> SequentialRule.of(0.001)).hasMessage("halfWidth 0.001 must be 0.002 to 0.5");
        assertThatThrownBy(() -> new SequentialRule(0.1, 1.0)).hasMessage("confidence 1 must be 0.5 to 0.999");
    }
}
