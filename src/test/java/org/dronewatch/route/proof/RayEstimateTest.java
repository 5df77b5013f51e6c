package org.dronewatch.route.proof;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Explanation;
import org.dronewatch.sensor.Signal;
import org.junit.jupiter.api.Test;

/** Levels that may be on either side of a threshold of 10 dB, probabilities of the level model, and exact ones. */
class RayEstimateTest {
    private static Assessment level(double margin, double error) {
        return assessment(new Signal(margin >= 0.0 ? 1.0 : 0.0, 10.0 + margin, "dB", 10.0, error, 0.0));
    }

    private static Assessment assessment(Signal signal) {
        return new Assessment(signal, signal.isDetected() ? Explanation.DETECTED : Explanation.of(Cause.TOO_WEAK));
    }

    private static RayEstimate levels(double... margins) {
        RayEstimate all = RayEstimate.first(level(margins[0], 1.0));
        for (int i = 1; i < margins.length; i++) {
            all = all.and(RayEstimate.one(level(margins[i], 1.0)));
        }
        return all;
    }

    @Test
    void aLevelFarFromTheThresholdIsExact() {
        assertThat(RayEstimate.first(level(0.9, 0.1))).isEqualTo(RayEstimate.exact(1.0));
        assertThat(RayEstimate.first(level(-0.7, 0.1)).isRandom()).isTrue();
        assertThat(RayEstimate.exact(0.3).probability()).isEqualTo(0.3);
        assertThat(RayEstimate.exact(0.3).variance()).isZero();
    }

    /** One run of 1,000 in Monaco was 0.015 dB over the threshold with an error of 0.09, all others stated 0.005. */
    @Test
    void aRareRayMayRaiseALevelByMoreThanItsError() {
        assertThat(RayEstimate.first(level(-0.05, 0.005)).isRandom()).isTrue();
        assertThat(RayEstimate.first(level(-0.05, 0.0)).isRandom())
                .as("no random rays")
                .isFalse();
    }

    @Test
    void levelsAreCounted() {
        RayEstimate some = levels(-0.3, 0.1, -0.2, -0.4, 5.0);

        assertThat(some.count()).isEqualTo(5);
        assertThat(some.probability()).isCloseTo(0.4, within(1e-12));
        assertThat(some.variance()).isCloseTo(0.4 * 0.6, within(1e-12));
    }

    /** Of n levels, 1/(n + 2) more at most; far away, half the exponential tail. */
    @Test
    void whatHasNotBeenSeenIsNotImpossible() {
        assertThat(levels(-0.3, -0.1, -0.2).probability())
                .isCloseTo(0.5 * Math.exp(-Math.sqrt(6.0)), within(1e-9))
                .isLessThan(0.2);
        assertThat(levels(0.3, -0.0, 0.1).probability()).isBetween(0.8, 0.9);
        assertThat(levels(5.0, 5.1, 4.9).probability()).isBetween(0.999999, 1.0);
        assertThat(levels(-0.3).probability())
                .as("a single one is taken as it is")
                .isZero();
    }

    /** Each is the mean of 32 traces. */
    @Test
    void probabilitiesOfTheLevelModelAreMeans() {
        Assessment one = assessment(new Signal(0.25, 9.0, "dB", 10.0, 0.0, 0.05));
        RayEstimate two = RayEstimate.first(one).and(RayEstimate.one(one));

        assertThat(two.probability()).isCloseTo(0.25, within(1e-12));
        assertThat(two.variance()).isCloseTo(0.25 * 0.75 / 32.0, within(1e-12));
    }
}
