package org.dronewatch.sensor.radio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The reflection from a sphere against rays that are traced to a circle. */
class RoundEarthTest {
    private static final double EPSILON = 1e-6;

    /** At the reflection, the heights over the tangent are as the distances: the angles are equal. */
    @ParameterizedTest
    @CsvSource({"10, 30, 3000", "30, 10, 3000", "10, 10, 8000", "5, 100, 20000", "1000, 2, 900"})
    void theAnglesAreEqual(double one, double other, double distance) {
        double before = RoundEarth.reflection(one, other, distance);
        double beyond = distance - before;
        assertThat(before).isBetween(0.0, distance);
        double first = (one - RoundEarth.drop(before)) / before;
        assertThat((other - RoundEarth.drop(beyond)) / beyond).isCloseTo(first, within(1e-9 * Math.abs(first)));
    }

    /** 8 km away the surface lies 3.767 m lower, 1 km away 0.059 m. */
    @Test
    void theSurfaceDrops() {
        assertThat(RoundEarth.drop(8000)).isCloseTo(3.767, within(5e-4));
        assertThat(RoundEarth.drop(1000)).isCloseTo(0.059, within(5e-4));
    }

    /**
     * Two rays a millionth of a radian apart, traced to the circle and back up: how far they are apart at the other
     * end.
     */
    @ParameterizedTest
    @CsvSource({"10, 0.005, 3000", "10, 0.013, 2000", "30, 0.004, 9000"})
    void itSpreadsAsTracedRaysDo(double height, double grazing, double beyond) {
        double[] ray = reflect(height, grazing, beyond);
        double[] next = reflect(height, grazing + EPSILON, beyond);
        double apart = Math.abs(-(next[0] - ray[0]) * Math.sin(ray[2]) + (next[1] - ray[1]) * Math.cos(ray[2]));
        double onPlane = (ray[3] + beyond) * EPSILON;
        double expected = Math.sqrt(onPlane / apart);
        assertThat(RoundEarth.divergence(ray[3], beyond, Math.sin(ray[4]))).isCloseTo(expected, within(2e-4));
        assertThat(expected).isLessThan(0.999);
    }

    /**
     * End of a ray reflected by the circle, x and y, its direction, the way to the circle, and the grazing angle there.
     */
    private static double[] reflect(double height, double downwards, double beyond) {
        double radius = RoundEarth.RADIUS;
        double dx = Math.cos(downwards);
        double dy = -Math.sin(downwards);
        // |(0, h + R) + t d|^2 = R^2, the nearer root without cancellation.
        double b = dy * (height + radius);
        double c = height * (height + 2 * radius);
        double way = c / (-b + Math.sqrt(b * b - c));
        double x = way * dx;
        double y = height + way * dy;
        double normal = Math.atan2(x, y + radius);
        double direction = 2 * -normal + downwards;
        double grazing = downwards - normal;
        return new double[] {x + beyond * Math.cos(direction), y + beyond * Math.sin(direction), direction, way, grazing
        };
    }
}
