package org.dronewatch.sensor.thermal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SpotConfirmationTest {
    private static final double[] MARKS = {0, 1e-6, 0.05, 0.2, 0.38, 0.5, 0.8, 0.97, 1};

    /** Every sequence of marks in turn, weighted by its probability. */
    private static double counted(int windows, int hits, int frames, double mark) {
        int length = frames + windows - 1;
        double sum = 0.0;
        for (int marks = 0; marks < 1 << length; marks++) {
            boolean isConfirmed = false;
            for (int window = 0; window < windows; window++) {
                isConfirmed |= Integer.bitCount(marks >> window & (1 << frames) - 1) >= hits;
            }
            int count = Integer.bitCount(marks);
            sum += isConfirmed ? Math.pow(mark, count) * Math.pow(1.0 - mark, length - count) : 0.0;
        }
        return sum;
    }

    @ParameterizedTest
    @CsvSource({
        "1, 1, 1",
        "5, 1, 1",
        "5, 1, 3",
        "6, 2, 3",
        "1, 3, 5",
        "5, 3, 5",
        "8, 3, 5",
        "7, 5, 5",
        "3, 8, 10",
        "5, 6, 12"
    })
    void followsEverySequence(int windows, int hits, int frames) {
        for (double mark : MARKS) {
            assertThat(SpotConfirmation.inOneOf(windows, hits, frames, mark))
                    .as("p = %s", mark)
                    .isCloseTo(counted(windows, hits, frames, mark), within(1e-12));
        }
    }

    @Test
    void singleFramesFollowTheClosedForm() {
        for (double mark : MARKS) {
            assertThat(SpotConfirmation.inOneOf(25, 1, 1, mark))
                    .isCloseTo(1.0 - Math.pow(1.0 - mark, 25), within(1e-12));
            assertThat(SpotConfirmation.byPairs(25, 1, 1, mark))
                    .isCloseTo(1.0 - Math.pow(1.0 - mark, 25), within(1e-12));
        }
    }

    /** The rules that are too long to be followed: exact for two frames, and never far below for more. */
    @ParameterizedTest
    @CsvSource({"1, 1", "1, 3", "2, 3", "3, 5", "5, 5", "4, 8", "6, 12", "12, 12"})
    void pairsOfFramesTellMostOfIt(int hits, int frames) {
        for (double mark : MARKS) {
            for (int windows : new int[] {1, 2}) {
                assertThat(SpotConfirmation.byPairs(windows, hits, frames, mark))
                        .isCloseTo(SpotConfirmation.bySequences(windows, hits, frames, mark), within(1e-12));
            }
            for (int windows : new int[] {3, 10, 50}) {
                double exact = SpotConfirmation.bySequences(windows, hits, frames, mark);
                assertThat(SpotConfirmation.byPairs(windows, hits, frames, mark))
                        .as("%d windows, p = %s", windows, mark)
                        .isBetween(exact - 0.1, exact + 0.1);
            }
        }
        assertThat(SpotConfirmation.inOneOf(1, 25, 50, 0.5))
                .isCloseTo(PointTargets.DEFAULT.withConfirmation(25, 50).probability(0.5), within(1e-12));
    }
}
