package org.dronewatch.analysis.cell;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.dronewatch.LongForm;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The scale rises, and a probability is near the one that its step stands for. */
class ProbabilityStepTest {
    @Test
    void onlyZeroAndOneAreKeptAsZeroAndOne() {
        assertThat(ProbabilityStep.of(0.0)).isZero();
        assertThat(ProbabilityStep.of(Double.MIN_VALUE)).isEqualTo(1);
        assertThat(ProbabilityStep.of(Math.nextDown(1.0))).isEqualTo(254);
        assertThat(ProbabilityStep.of(1.0)).isEqualTo(255);
        assertThat(ProbabilityStep.probability(0)).isZero();
        assertThat(ProbabilityStep.probability(255)).isEqualTo(1.0);
    }

    @Test
    void eachStepKeepsItself() {
        for (int step = 0; step <= ProbabilityStep.CERTAIN; step++) {
            assertThat(ProbabilityStep.of(ProbabilityStep.probability(step))).isEqualTo(step);
        }
        assertThat(ProbabilityStep.probability(130)).as("multiples of 1/250").isEqualTo(0.5);
        assertThat(ProbabilityStep.probability(6)).isEqualTo(0.004);
        assertThat(ProbabilityStep.probability(5)).isEqualTo(0.001);
        assertThat(ProbabilityStep.probability(1)).isEqualTo(1.0 / 256_000);
    }

    /** From the least probability of a step to that of the next. */
    @Test
    void stepsBeginWhereTheyAreStatedTo() {
        for (int step = 2; step <= ProbabilityStep.CERTAIN; step++) {
            double least = ProbabilityStep.least(step);
            assertThat(least).as("step %d", step).isGreaterThan(ProbabilityStep.probability(step - 1));
            assertThat(ProbabilityStep.of(least * (1.0 + 1e-12)))
                    .as("step %d", step)
                    .isEqualTo(step);
            assertThat(ProbabilityStep.of(least * (1.0 - 1e-12)))
                    .as("step %d", step)
                    .isEqualTo(step - 1);
        }
        assertThat(ProbabilityStep.least(1)).isZero();
    }

    /** Up to the first multiple of 1/250; between others, rounding decides. */
    @ParameterizedTest
    @ValueSource(ints = {2, 3, 4, 5, 6})
    void theLeastProbabilityOfASmallStepBelongsToIt(int step) {
        double least = ProbabilityStep.least(step);

        assertThat(ProbabilityStep.of(least)).isEqualTo(step);
        assertThat(ProbabilityStep.of(Math.nextDown(least))).isEqualTo(step - 1);
    }

    @Test
    void probabilitiesAreKeptToHalfAStepOrAFactorOfTwo() {
        long seed = LongForm.seed(250);
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < 100_000; i++) {
            double probability = i % 2 == 0 ? random.nextDouble() : Math.pow(10.0, -5.7 * random.nextDouble());
            double kept = ProbabilityStep.probability(ProbabilityStep.of(probability));
            boolean isNear = probability > 0.002
                    ? Math.abs(kept - probability) <= (probability > 0.998 ? 0.004 : 0.002) + 1e-12
                    : kept <= 2.0 * probability + 1e-15 && probability <= 2.0 * kept + 1e-15;
            assertThat(isNear)
                    .as("seed %d: %s is kept as %s", seed, probability, kept)
                    .isTrue();
        }
    }

    @Test
    void resultsStateNoSmallerProbabilitiesThanOneIn250() {
        for (int step = 1; step <= ProbabilityStep.CERTAIN; step++) {
            assertThat(ProbabilityStep.stated(step)).isEqualTo(Math.max(0.004, ProbabilityStep.probability(step)));
        }
        assertThat(ProbabilityStep.stated(0)).isZero();
    }

    @Test
    void aCellIsCoveredFromTheNeededProbabilityOn() {
        assertThat(ProbabilityStep.probability(ProbabilityStep.toCover(0.008))).isEqualTo(0.008);
        assertThat(ProbabilityStep.probability(ProbabilityStep.toCover(0.5))).isEqualTo(0.5);
        assertThat(ProbabilityStep.probability(ProbabilityStep.toCover(0.501)))
                .as("rounded up")
                .isEqualTo(0.504);
        assertThat(ProbabilityStep.toCover(1.0)).isEqualTo(ProbabilityStep.CERTAIN);
    }
}
