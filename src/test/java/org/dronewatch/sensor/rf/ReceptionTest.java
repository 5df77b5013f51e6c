package org.dronewatch.sensor.rf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What a look receives of a drone and its pilot, of which chance has to decide. */
class ReceptionTest {
    private static final double NOTHING = Double.NEGATIVE_INFINITY;

    @Test
    void aRatioThatIsJustReachedIsReached() {
        Reception drone = new Reception(6.0, NOTHING, 0.75, 0.0, 0.0);
        assertThat(drone.probability(6.0)).isEqualTo(0.75);
        assertThat(drone.probability(Math.nextUp(6.0))).isZero();
        Reception pilot = new Reception(NOTHING, 6.0, 0.75, 0.0, 0.0);
        assertThat(pilot.probability(6.0)).isEqualTo(0.75);
        assertThat(pilot.probability(Math.nextUp(6.0))).isZero();
    }

    /** Each of the two is intercepted in a fourth of all looks: at least one in 1 - 0.75^2. */
    @Test
    void droneAndPilotAreInterceptedIndependently() {
        Reception both = new Reception(6.0, 8.0, 0.25, 0.0, 0.0);
        assertThat(both.probability(6.0)).isEqualTo(0.4375);
        assertThat(both.probability(6.5)).isEqualTo(0.25);
        assertThat(both.probability(8.5)).isZero();
    }

    /** 10 dB, and 6 dB in a fourth of all looks, in which the noise is 4 dB higher. */
    @Test
    void othersTakeTheRiseOfTheNoiseInTheirShareOfLooks() {
        Reception seldom = new Reception(10.0, NOTHING, 1.0, 4.0, 0.25);
        assertThat(seldom.probability(6.0)).isEqualTo(1.0);
        assertThat(seldom.probability(6.000001)).isEqualTo(0.75);
        assertThat(seldom.probability(10.0)).isEqualTo(0.75);
        assertThat(seldom.probability(Math.nextUp(10.0))).isZero();
        Reception always = new Reception(10.0, NOTHING, 1.0, 4.0, 1.0);
        assertThat(always.probability(6.0)).isEqualTo(1.0);
        assertThat(always.probability(6.000001)).isZero();
    }

    @ParameterizedTest
    @CsvSource({"0.5, 10", "0.499999, 6", "0.75, 10", "0.25, 6", "0, 6", "1, 10"})
    void everyOtherLookIsEnoughForTheMedian(double undisturbed, double median) {
        double occupancy = 1.0 - undisturbed;
        assertThat(new Reception(10.0, NOTHING, 1.0, 4.0, occupancy).median()).isEqualTo(median);
        assertThat(new Reception(NOTHING, 10.0, 1.0, 4.0, occupancy).median()).isEqualTo(median);
    }

    @Test
    void whereFewerThanEveryOtherLookInterceptAnythingThereIsNoMedian() {
        assertThat(new Reception(10.0, NOTHING, 0.5, 0.0, 0.0).median()).isEqualTo(10.0);
        assertThat(new Reception(10.0, NOTHING, 0.499999, 0.0, 0.0).median()).isEqualTo(NOTHING);
        assertThat(new Reception(NOTHING, NOTHING, 1.0, 4.0, 0.5).median()).isEqualTo(NOTHING);
        // 1 - 0.6^2 is more than a half, and the weaker of the two is the one that so many looks reach.
        assertThat(new Reception(10.0, 5.0, 0.4, 0.0, 0.0).median()).isEqualTo(5.0);
    }

    /** Not even where the raised noise would bring the drone within rounding of its pilot. */
    @ParameterizedTest
    @CsvSource({"0", "3", "5", "4.9999999995", "100"})
    void aBandThatNobodyOccupiesHasNoEffect(double rise) {
        Reception one = new Reception(10.0, 5.0, 0.4, rise, 0.0);
        assertThat(one.median()).isEqualTo(5.0);
        assertThat(one.probability(10.0)).isCloseTo(0.4, within(1e-15));
    }

    /**
     * By brute force over who is intercepted and whether others transmit: the greatest value that looks with at least
     * half of the probability reach. All probabilities are multiples of 1/4, so their sums are exact.
     */
    @Test
    void agreesWithAllCasesTakenOneByOne() {
        long seed = 20_261_130L;
        System.out.println("seed " + seed);
        SplittableRandom random = new SplittableRandom(seed);
        for (int trial = 0; trial < 3_000; trial++) {
            Reception one = new Reception(
                    anyRatio(random),
                    anyRatio(random),
                    0.25 * random.nextInt(5),
                    random.nextInt(6),
                    0.25 * random.nextInt(5));
            double greatest = NOTHING;
            for (int ratio = -10; ratio <= 9; ratio++) {
                double share = share(one, ratio);
                assertThat(one.probability(ratio))
                        .as("seed %d: %s at %d", seed, one, ratio)
                        .isEqualTo(share);
                greatest = share >= 0.5 ? ratio : greatest;
            }
            assertThat(one.median()).as("seed %d: %s", seed, one).isEqualTo(greatest);
        }
    }

    private static double anyRatio(SplittableRandom random) {
        return random.nextInt(5) == 0 ? NOTHING : random.nextInt(-4, 9);
    }

    private static double share(Reception one, double ratio) {
        double share = 0.0;
        for (int outcome = 0; outcome < 8; outcome++) {
            boolean hasDrone = (outcome & 1) != 0;
            boolean hasPilot = (outcome & 2) != 0;
            boolean isDisturbed = (outcome & 4) != 0;
            double chance = (hasDrone ? one.interception() : 1.0 - one.interception())
                    * (hasPilot ? one.interception() : 1.0 - one.interception())
                    * (isDisturbed ? one.occupancy() : 1.0 - one.occupancy());
            double best = Math.max(hasDrone ? one.drone() : NOTHING, hasPilot ? one.pilot() : NOTHING);
            share += best - (isDisturbed ? one.rise() : 0.0) >= ratio ? chance : 0.0;
        }
        return share;
    }

    @ParameterizedTest
    @CsvSource({
        "1, 0, true",
        "1, 1, true",
        "1, 0.5, false",
        "1, 4.9e-324, false",
        "1, 0.9999999999999999, false",
        "0.9999999999999999, 0, false",
        "0, 0, false",
        "0.5, 1, false"
    })
    void itIsCertainWhereChanceHasNothingToDecide(double interception, double occupancy, boolean isCertain) {
        assertThat(new Reception(10.0, 5.0, interception, 3.0, occupancy).isCertain())
                .isEqualTo(isCertain);
    }
}
