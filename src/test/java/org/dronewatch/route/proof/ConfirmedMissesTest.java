package org.dronewatch.route.proof;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.dronewatch.fusion.Confirmation;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ConfirmedMissesTest {
    private static final int LOOKS = 12;

    /** All sequences of hits and misses, each with its probability. */
    @ParameterizedTest
    @CsvSource({"1, 1", "2, 2", "2, 3", "3, 5", "1, 4", "5, 12"})
    void asAllSequencesOfHitsAndMisses(int hits, int of) {
        SplittableRandom random = new SplittableRandom(hits * 100L + of);
        double[] p = random.doubles(LOOKS).toArray();
        double[] expected = new double[LOOKS];
        for (int sequence = 0; sequence < 1 << LOOKS; sequence++) {
            double chance = 1.0;
            for (int look = 0; look < LOOKS; look++) {
                chance *= (sequence >> look & 1) == 1 ? p[look] : 1.0 - p[look];
            }
            boolean isConfirmed = false;
            for (int look = 0; look < LOOKS; look++) {
                int window = (sequence & (2 << look) - 1) >> Math.max(0, look - of + 1);
                isConfirmed |= Integer.bitCount(window) >= hits;
                expected[look] += isConfirmed ? 0.0 : chance;
            }
        }

        ConfirmedMisses chain = new ConfirmedMisses(new Confirmation(hits, of));
        for (int look = 0; look < LOOKS; look++) {
            assertThat(chain.after(p[look])).as("look %d", look).isCloseTo(expected[look], within(1e-12));
        }
    }
}
