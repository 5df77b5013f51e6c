package org.dronewatch.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class DiscriminationTest {
    @Test
    void theProbabilityFollowsTheTransferFunction() {
        assertThat(Discrimination.transfer(0.0)).isZero();
        assertThat(Discrimination.transfer(1.0)).isEqualTo(0.5);
        assertThat(Discrimination.transfer(1e9)).isEqualTo(1.0);
        for (double x : new double[] {1e-3, 0.2, 0.7, 1.5, 2.0, 3.0}) {
            double odds = Math.pow(x, 2.7 + 0.7 * x);
            assertThat(Discrimination.transfer(x)).as("%s", x).isCloseTo(odds / (1.0 + odds), within(1e-15));
        }
    }

    /** Not even by a rounding error, as odds / (1 + odds) does: bounds are those of the ends of a range. */
    @Test
    void itNeverFallsWhereMoreIsResolved() {
        double last = 0.0;
        for (int i = 1; i <= 2_000_000; i++) {
            double next = Discrimination.transfer(1e-5 * i);
            assertThat(next >= last).as("ratio %s", 1e-5 * i).isTrue();
            last = next;
        }
    }
}
