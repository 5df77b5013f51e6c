package org.dronewatch.analysis.cell;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.IntStream;
import org.dronewatch.sensor.Cause;
import org.junit.jupiter.api.Test;

/** A step, a cause and a margin share three bytes without disturbing each other. */
class CellCodeTest {
    private static final int[] MARGINS = {
        MarginCode.NOTHING,
        MarginCode.NO_SIGNAL,
        MarginCode.of(-51.1),
        MarginCode.of(0.0),
        MarginCode.of(12.3),
        MarginCode.of(51.1),
        MarginCode.atLeast(-51.0),
        MarginCode.atLeast(99.0),
        MarginCode.atMost(-99.0),
        MarginCode.atMost(51.0)
    };

    @Test
    void partsAreReadAsTheyWereWritten() {
        for (int step = 0; step <= ProbabilityStep.CERTAIN; step += 5) {
            for (Cause cause : Cause.values()) {
                for (int margin : MARGINS) {
                    int code = CellCode.of(step, cause, margin);
                    assertThat(code).isBetween(0, (1 << 8 * CellCode.BYTES) - 1);
                    assertThat(CellCode.step(code)).isEqualTo(step);
                    assertThat(CellCode.cause(code)).isEqualTo(cause);
                    assertThat(CellCode.margin(code)).isEqualTo(MarginCode.margin(margin));
                    assertThat(CellCode.isPossible(code)).isTrue();
                }
            }
        }
    }

    @Test
    void numbersOfMoreThanThreeBytesAreNotPossible() {
        int largest = CellCode.of(255, Cause.DETECTED, MarginCode.atMost(51.0));

        assertThat(CellCode.isPossible(largest)).isTrue();
        for (int bit = 8 * CellCode.BYTES; bit < 31; bit++) {
            assertThat(CellCode.isPossible(largest | 1 << bit))
                    .as("bit %d", bit)
                    .isFalse();
            assertThat(CellCode.isPossible(1 << bit)).as("bit %d", bit).isFalse();
        }
    }

    /** The second byte holds the cause in its lower half: the sixteen numbers there are more than the causes. */
    @Test
    void numbersWithACauseThatThereIsNotAreNotPossible() {
        int other = CellCode.of(7, Cause.values()[0], MarginCode.of(3.0));
        int[] possible = IntStream.range(0, 16)
                .filter(cause -> CellCode.isPossible(other | cause << 8))
                .toArray();

        assertThat(possible)
                .containsExactly(IntStream.range(0, Cause.values().length).toArray());
    }

    @Test
    void numbersWithAMarginThatThereIsNotAreNotPossible() {
        for (int impossible : new int[] {2, 1023, 2047, 3071, 4095}) {
            assertThat(CellCode.isPossible(CellCode.of(7, Cause.TOO_WEAK, impossible)))
                    .as("margin %d", impossible)
                    .isFalse();
        }
    }
}
