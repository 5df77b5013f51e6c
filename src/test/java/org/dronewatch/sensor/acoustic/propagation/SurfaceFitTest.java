package org.dronewatch.sensor.acoustic.propagation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import java.util.function.DoubleBinaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SurfaceFitTest {
    private static final double FROM = 900;
    private static final double TO = 940;
    private static final double HALF = 3;

    private static SurfaceFit fit(DoubleBinaryOperator height) {
        SurfaceFit fit = new SurfaceFit(100);
        SplittableRandom random = new SplittableRandom(5);
        for (int i = 0; i < 100; i++) {
            double u = random.nextDouble(FROM, TO);
            double v = random.nextDouble(-HALF, HALF);
            fit.add(u, v, height.applyAsDouble(u, v));
        }
        assertThat(fit.fit(FROM, TO, 0, HALF)).isTrue();
        return fit;
    }

    /** Points of a plane or of a convex parabola lie on the fitted surface. */
    @ParameterizedTest
    @ValueSource(doubles = {0, -1e-3, -0.02})
    void surfacesOfItsKindAreFittedExactly(double bend) {
        SurfaceFit fit = fit((u, v) -> 100 + 0.2 * (u - 915) - 0.3 * v + bend * (u - 915) * (u - 915));
        assertThat(fit.z(910, 1)).isCloseTo(100 - 1 - 0.3 + 25 * bend, within(1e-9));
        assertThat(fit.slopeU(930)).isCloseTo(0.2 + 30 * bend, within(1e-9));
        assertThat(fit.slopeV()).isCloseTo(-0.3, within(1e-9));
        assertThat(fit.standardDeviation()).isLessThan(1e-9);
    }

    /** The mean of the square of {@code x^2 - 1/3} over -1 to 1 is 4/45. */
    @Test
    void aHollowIsFittedByAPlane() {
        double depth = 2;
        SurfaceFit fit = new SurfaceFit(3 * 401);
        for (int i = -200; i <= 200; i++) {
            for (int j = -1; j <= 1; j++) {
                double x = i / 200.0;
                fit.add(920 + 20 * x, j * HALF, depth * x * x);
            }
        }
        assertThat(fit.fit(FROM, TO, 0, HALF)).isTrue();
        assertThat(fit.slopeU(905)).isCloseTo(0, within(1e-9)).isCloseTo(fit.slopeU(935), within(1e-12));
        assertThat(fit.standardDeviation()).isCloseTo(depth * Math.sqrt(4.0 / 45), within(0.01));
    }

    @Test
    void pointsOnOneLineHaveNoPlane() {
        SurfaceFit fit = new SurfaceFit(10);
        for (int i = 0; i < 10; i++) {
            fit.add(FROM + 4 * i, 0.1 * i, 5);
        }
        assertThat(fit.fit(FROM, TO, 0, HALF)).isFalse();
    }
}
