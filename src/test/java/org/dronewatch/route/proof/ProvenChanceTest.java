package org.dronewatch.route.proof;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronewatch.statistics.Proportion;
import org.junit.jupiter.api.Test;

/** Predictions with and without an error of their own. */
class ProvenChanceTest {
    private static ProvenChance chance(double predicted, double error, int count) {
        return new ProvenChance(predicted, error, new Proportion(count, 1000));
    }

    @Test
    void whatIsImpossibleMustNotOccur() {
        assertThat(chance(0.0, 0.0, 0).agrees()).isTrue();
        assertThat(chance(0.0, 0.0, 1).agrees()).isFalse();
        assertThat(chance(1.0, 0.0, 999).agrees()).isFalse();
    }

    /** No trace has hit a microphone behind a house, but one in a thousand runs has one that does. */
    @Test
    void whatNoRayHasShownIsNotImpossible() {
        ProvenChance rare = chance(0.0, 0.001, 1);
        assertThat(rare.isInInterval()).isFalse();
        assertThat(rare.agrees()).isTrue();
        assertThat(chance(1.0, 0.001, 999).agrees()).isTrue();
        assertThat(chance(0.0, 0.001, 20).agrees()).isFalse();
        assertThat(chance(0.0, 0.001, 20).isPlausible(1.0 - 1e-6)).isFalse();
    }

    /** 300 of 1,000 is 20 percentage points and 14 standard deviations off; an error of 0.16 does not explain that. */
    @Test
    void theErrorOfThePredictionIsNoExcuse() {
        assertThat(chance(0.5, 0.0016, 300).agrees()).isFalse();
        assertThat(chance(0.34, 0.0, 300).agrees()).isFalse();
        assertThat(chance(0.34, 0.0016, 300).agrees()).isTrue();
    }

    /** Fewer than one case is expected. */
    @Test
    void aSingleCaseIsLessRareThanWilsonsIntervalImplies() {
        ProvenChance single = chance(1e-4, 0.0, 1);
        assertThat(single.isInInterval()).isFalse();
        assertThat(single.agrees()).isTrue();
    }
}
