package org.dronewatch.sensor.rf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.dronewatch.drone.Bursts;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Bursts and dwells that overlap just enough, or just not. */
class DwellTest {
    /** One burst of a fourth of a second in each second. */
    private static final Bursts QUARTER = Bursts.of(1).withDutyCycle(0.25);

    /** The burst has to begin within {@code time + 0.25 s - 2 overlap}. */
    @ParameterizedTest
    @CsvSource({
        "0.5, 0, 0.75",
        "0.5, 0.125, 0.5",
        "0.5, 0.25, 0.25",
        "0.5, 0.2500000000000001, 0",
        "0.5, 0.5, 0",
        "0.25, 0.25, 0",
        "0.25, 0.125, 0.25",
        "0.125, 0.125, 0.125",
        "0.75, 0, 1"
    })
    void aBurstMustLastAsLongAsTheOverlap(double time, double overlap, double probability) {
        assertThat(Dwell.of(time).withOverlap(overlap).probability(QUARTER, 1e6))
                .isEqualTo(probability);
    }

    /** A dwell as long as the burst and the overlap has no room; with a little less overlap it has twice as much. */
    @Test
    void theProbabilityVanishesWithoutAStep() {
        assertThat(Dwell.of(0.25).withOverlap(0.25 - 1e-12).probability(QUARTER, 1e6))
                .isCloseTo(2e-12, within(1e-15));
    }

    @Test
    void theOverlapMayFillTheDwell() {
        assertThat(Dwell.of(0.01).withOverlap(0.01).overlap()).isEqualTo(0.01);
        assertThatThrownBy(() -> Dwell.of(0.01).withOverlap(Math.nextUp(0.01)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("must be at most time 0.01 s");
    }

    /** A transmission without pauses is heard at once, however long the overlap, unless it hops elsewhere. */
    @Test
    void anEndlessTransmissionIsHeardUnlessItHops() {
        Dwell dwell = Dwell.of(0.5).withOverlap(0.5);
        assertThat(dwell.probability(Bursts.of(1000), 1e6)).isEqualTo(1.0);
        assertThat(dwell.probability(Bursts.of(1000).withChannels(4, 4e6), 4e6)).isEqualTo(1.0);
        assertThat(dwell.probability(Bursts.of(1000).withChannels(4, 4e6), 3e6)).isZero();
    }

    /** 4 channels in 8 MHz: one of them at least, all of them at most. */
    @ParameterizedTest
    @CsvSource({"1, 0.25", "2e6, 0.25", "4e6, 0.5", "8e6, 1", "1e10, 1"})
    void atLeastOneChannelIsHeard(double bandwidth, double share) {
        Bursts hops = Bursts.of(1).withDutyCycle(0.5).withChannels(4, 8e6);
        assertThat(Dwell.of(0.5).probability(hops, bandwidth)).isEqualTo(share);
    }

    /** Each dwell misses with 3/4, independently of the others. */
    @ParameterizedTest
    @CsvSource({"1, 0.25", "2, 0.4375", "3, 0.578125"})
    void moreDwellsMissTogetherOnly(int count, double probability) {
        Dwell dwell = Dwell.of(0.5).withOverlap(0.25).withCount(count);
        assertThat(dwell.probability(QUARTER, 1e6)).isCloseTo(probability, within(1e-15));
    }
}
