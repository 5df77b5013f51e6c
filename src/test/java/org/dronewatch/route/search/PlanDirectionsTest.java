package org.dronewatch.route.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class PlanDirectionsTest {
    /** Published factors by which grids are too long: 1.0824, 1.0275, 1.0131. */
    @Test
    void stretchOfTheDirections() {
        assertThat(PlanDirections.of(8).stretch()).isCloseTo(1.0824, within(5e-5));
        assertThat(PlanDirections.of(16).stretch()).isCloseTo(1.0275, within(5e-5));
        assertThat(PlanDirections.of(32).stretch()).isCloseTo(1.0131, within(5e-5));
        assertThat(PlanDirections.of(48).stretch()).isCloseTo(1.0034, within(5e-5));
        for (int count : new int[] {8, 16, 32, 48}) {
            assertThat(PlanDirections.of(count).count()).isEqualTo(count);
        }
    }
}
