package org.dronewatch.statistics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.dronewatch.statistics.Proportion.Interval;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ProportionTest {
    /** By the closed form (k + z^2/2 -+ z sqrt(k (n - k)/n + z^2/4)) / (n + z^2), z = 1.959963985. */
    @ParameterizedTest
    @CsvSource({
        "0, 10, 0, .277533",
        "1, 10, .017876, .404150",
        "5, 10, .236593, .763407",
        "95, 100, .888250, .978456",
        "29, 30, .833296, .994091",
        "0, 300, 0, .012643",
        "10, 10, .722467, 1"
    })
    void wilsonsInterval(int count, int of, double low, double high) {
        Interval interval = new Proportion(count, of).wilson(0.95);

        assertThat(interval.low()).isCloseTo(low, within(5e-7));
        assertThat(interval.high()).isCloseTo(high, within(5e-7));
    }

    /** Clopper and Pearson's interval: for 1 of 10 cases .002529 to .445016. */
    @ParameterizedTest
    @CsvSource({"1, 10, .002529, .445016", "0, 300, 0, .012221", "300, 300, .987779, 1"})
    void exactInterval(int count, int of, double low, double high) {
        Proportion cases = new Proportion(count, of);

        assertThat(cases.isPlausible(low + 1e-6, 0.95)).isTrue();
        assertThat(cases.isPlausible(high - 1e-6, 0.95)).isTrue();
        assertThat(count > 0 && cases.isPlausible(low - 1e-6, 0.95)).isFalse();
        assertThat(count < of && cases.isPlausible(high + 1e-6, 0.95)).isFalse();
    }

    /** One of a thousand, where 0.07 are expected, happens in 7 of 100 campaigns: too rarely by Wilson's interval. */
    @Test
    void theExactIntervalContainsTheProbabilityAtLeastAsOftenAsItSays() {
        for (double p : new double[] {1e-6, 7e-5, 1e-3, 0.02, 0.3, 0.5}) {
            double exact = 0.0;
            double wilson = 0.0;
            double chance = Math.pow(1.0 - p, 1000);
            for (int k = 0; k <= 1000; k++) {
                exact += new Proportion(k, 1000).isPlausible(p, 0.99) ? chance : 0.0;
                wilson += new Proportion(k, 1000).wilson(0.99).contains(p) ? chance : 0.0;
                chance *= (1000.0 - k) / (k + 1.0) * p / (1.0 - p);
            }
            assertThat(exact).as("p = %s", p).isGreaterThan(0.99);
            assertThat(wilson < 0.94).isEqualTo(p == 7e-5);
        }
    }

    @Test
    void anIntervalContainsItsBounds() {
        Interval interval = new Interval(0.25, 0.75);

        assertThat(interval.contains(0.25)).isTrue();
        assertThat(interval.contains(0.75)).isTrue();
        assertThat(interval.contains(Math.nextDown(0.25))).isFalse();
        assertThat(interval.contains(Math.nextUp(0.75))).isFalse();
    }

    @Test
    void withoutCasesNothingIsKnown() {
        assertThat(new Proportion(0, 0).wilson(0.95)).isEqualTo(new Interval(0.0, 1.0));
        assertThat(new Proportion(0, 0).share()).isNaN();
    }

    @Test
    void thereAreNotMoreCasesWithAnOutcomeThanCases() {
        assertThatThrownBy(() -> new Proportion(3, 2)).hasMessage("3 of 2 cases: must be 0 to 2");
        assertThatThrownBy(() -> new Proportion(-1, 2)).hasMessageContaining("-1 of 2");
    }

    /** Exactly: the probabilities of all counts whose interval contains p, for p over (0, 1). */
    @Test
    void theIntervalContainsTheProbabilityAsOftenAsItSays() {
        double sum = 0.0;
        int steps = 198;
        for (int i = 1; i <= steps; i++) {
            double p = i / (steps + 1.0);
            double held = 0.0;
            double chance = Math.pow(1.0 - p, 100);
            for (int k = 0; k <= 100; k++) {
                held += new Proportion(k, 100).wilson(0.95).contains(p) ? chance : 0.0;
                chance *= (100.0 - k) / (k + 1.0) * p / (1.0 - p);
            }
            assertThat(held).as("p = %s", p).isBetween(0.83, 0.99);
            sum += held;
        }
        assertThat(sum / steps).isBetween(0.945, 0.955);
    }

    @Test
    void overAThousandCampaigns95PercentIntervalsHold() {
        long seed = 20260701;
        SplittableRandom random = new SplittableRandom(seed);
        int held = 0;
        for (int campaign = 0; campaign < 1000; campaign++) {
            double p = random.nextDouble(0.05, 0.95);
            int count = 0;
            for (int i = 0; i < 300; i++) {
                count += random.nextDouble() < p ? 1 : 0;
            }
            held += new Proportion(count, 300).wilson(0.95).contains(p) ? 1 : 0;
        }
        assertThat(held).as("seed %d", seed).isBetween(930, 970);
    }
}
