package org.dronewatch.fusion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What confirming looks does to the probability of one. */
class ConfirmationTest {

    /** The tail of the binomial distribution: 10 p^3 (1-p)^2 + 5 p^4 (1-p) + p^5. */
    @Test
    void threeOfFive() {
        Confirmation confirm = new Confirmation(3, 5);
        assertThat(confirm.probability(0.9)).isCloseTo(0.99144, within(1e-12));
        assertThat(confirm.probability(1e-3)).isCloseTo(9.985006e-9, within(1e-18));
        assertThat(new Confirmation(3, 4).probability(0.9)).isCloseTo(0.9477, within(1e-12));
        assertThat(confirm.onset(1e-3)).isCloseTo(6e-9 * Math.pow(0.999, 3), within(1e-20));
    }

    @Test
    void oneLookIsAsLikelyAsItIs() {
        assertThat(Confirmation.DEFAULT.probability(0.3)).isCloseTo(0.3, within(1e-15));
        assertThat(Confirmation.DEFAULT.onset(0.3)).isCloseTo(0.21, within(1e-15));
    }

    @Test
    void atTheEnds() {
        Confirmation most = new Confirmation(100, 100);
        Confirmation half = new Confirmation(50, 100);
        assertThat(most.probability(1.0)).isEqualTo(1.0);
        assertThat(most.probability(0.0)).isZero();
        assertThat(most.onset(0.0)).isZero();
        assertThat(most.onset(1.0)).isZero();
        // Half of the 100 or more: by symmetry (1 + C(100, 50) / 2^100) / 2, 0.0795892373871787614 (tables).
        assertThat(half.probability(0.5)).isCloseTo(0.5 * (1.0 + 0.0795892373871787614), within(1e-12));
    }

    /** Against brute force: every sequence of looks with its probability. */
    @ParameterizedTest
    @CsvSource({"1,1,.3", "1,4,.2", "2,3,.5", "3,5,.1", "3,5,.9", "4,4,.7", "5,8,.4", "6,10,.25"})
    void allSequences(int hits, int looks, double p) {
        double confirmed = 0.0;
        double fresh = 0.0;
        for (int sequence = 0; sequence < 1 << (looks + 1); sequence++) {
            int ones = Integer.bitCount(sequence);
            double chance = Math.pow(p, ones) * Math.pow(1 - p, looks + 1 - ones);
            boolean before = Integer.bitCount(sequence & (1 << looks) - 1) >= hits;
            boolean now = Integer.bitCount(sequence >> 1) >= hits;
            confirmed += now ? chance : 0.0;
            fresh += now && !before ? chance : 0.0;
        }
        Confirmation confirm = new Confirmation(hits, looks);
        assertThat(confirm.probability(p)).isCloseTo(confirmed, within(1e-13));
        assertThat(confirm.onset(p)).isCloseTo(fresh, within(1e-13));
    }
}
