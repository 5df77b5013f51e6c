package org.dronewatch.analysis.cell;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The heights of a search for routes reach from close to the ground to the drone's ceiling. */
class RouteHeightsTest {
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "500|2 5 10 20 30 45 60 90 120 150 250 500",
                "120|2 5 10 20 30 45 60 90 120",
                "100|2 5 10 20 30 45 60 90 100",
                "95|2 5 10 20 30 45 60 95",
                "3|2 3",
                "2|2",
                "1|1",
                "400|2 5 10 20 30 45 60 90 120 150 250 400",
                "20000|2 5 10 20 30 45 60 90 120 150 250 500 1000 2000 4000 8000 10000",
            })
    void reachFromTheGroundToTheCeiling(double ceiling, String heights) {
        assertThat(RouteHeights.upTo(ceiling))
                .isEqualTo(
                        Arrays.stream(heights.split(" ")).map(Double::valueOf).toList());
    }

    @ParameterizedTest
    @ValueSource(
            doubles = {0.001, 1.9, 2.0005, 2.1, 10.0004, 120.0000001, 151, 164, 166, 251, 276, 549, 551, 9999, 10_001})
    void areHeightsOfAGridWithoutWideGaps(double ceiling) {
        List<Double> heights = RouteHeights.upTo(ceiling);

        assertThat(FieldGrid.checkedHeights(heights)).hasSizeBetween(1, 17);
        assertThat(heights.get(heights.size() - 1)).isEqualTo(Math.min(ceiling, FieldGrid.HIGHEST));
        for (int i = 1; i < heights.size(); i++) {
            double below = heights.get(i - 1);
            assertThat(heights.get(i)).isLessThanOrEqualTo(below < 150 ? 2.5 * below : 2.2 * below);
        }
    }

    @Test
    void aSlightlyHigherCeilingTakesThePlaceOfAHeight() {
        assertThat(RouteHeights.upTo(130.0)).endsWith(90.0, 130.0);
        assertThat(RouteHeights.upTo(132.0)).endsWith(90.0, 120.0, 132.0);
    }
}
