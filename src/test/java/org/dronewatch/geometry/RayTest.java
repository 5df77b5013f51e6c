package org.dronewatch.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import org.jogamp.vecmath.Point3d;
import org.jogamp.vecmath.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class RayTest {
    private static final Point3d ORIGIN = new Point3d(1, 2, 3);
    private static final Vector3d UP = new Vector3d(0, 0, 2);

    @Test
    void keepsWhatItWasGiven() {
        Ray ray = new Ray(ORIGIN, UP, 0.5, 4.0);

        assertThat(ray.origin()).isEqualTo(ORIGIN);
        assertThat(ray.direction()).isEqualTo(UP);
        assertThat(ray.tMin()).isEqualTo(0.5);
        assertThat(ray.tMax()).isEqualTo(4.0);
        assertThat(ray.pointAt(1.5)).isEqualTo(new Point3d(1, 2, 6));
        assertThat(new Ray(ORIGIN, UP).tMin()).isZero();
        assertThat(new Ray(ORIGIN, UP).tMax()).isInfinite();
    }

    @Test
    void cannotBeChangedFromOutside() {
        Point3d origin = new Point3d(ORIGIN);
        Ray ray = new Ray(origin, UP);
        origin.x = 99;
        ray.origin().y = 99;
        ray.direction().z = 99;

        assertThat(ray.origin()).isEqualTo(ORIGIN);
        assertThat(ray.direction()).isEqualTo(UP);
    }

    @Test
    void zerosOfEitherSignHaveTheInversePlusInfinity() {
        Vector3d inverse = new Ray(ORIGIN, new Vector3d(-0.0, 0.0, -4.0)).inverseDirection();

        assertThat(inverse).isEqualTo(new Vector3d(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, -0.25));
    }

    @Test
    void betweenTwoPointsEndsAtTheSecond() {
        Ray ray = Ray.between(ORIGIN, new Point3d(1, 5, 7));

        assertThat(ray.direction().epsilonEquals(new Vector3d(0, 0.6, 0.8), 1e-15))
                .isTrue();
        assertThat(ray.tMax()).isEqualTo(5.0);
    }

    @Test
    void betweenAPointAndItselfIsNoRay() {
        assertThatIllegalArgumentException().isThrownBy(() -> Ray.between(ORIGIN, ORIGIN));
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
    void refusesNumbersThatAreNotFinite(double bad) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Ray(new Point3d(0, bad, 0), UP))
                .withMessageContaining("origin");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Ray(ORIGIN, new Vector3d(0, bad, 1)))
                .withMessageContaining("direction");
    }

    @Test
    void refusesADirectionOfZero() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Ray(ORIGIN, new Vector3d(0, -0.0, 0)))
                .withMessageContaining("direction");
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.0, 2.0, Double.POSITIVE_INFINITY})
    void mayConsistOfOnePoint(double t) {
        Ray ray = new Ray(ORIGIN, UP, t, t);

        assertThat(ray.tMin()).isEqualTo(t);
        assertThat(ray.tMax()).isEqualTo(t);
    }

    @Test
    void showsItsOriginDirectionAndRange() {
        assertThat(new Ray(ORIGIN, UP, 0.5, 4.0))
                .hasToString("Ray[origin=(1.0, 2.0, 3.0), direction=(0.0, 0.0, 2.0), t=0.5..4.0]");
    }

    @ParameterizedTest
    @CsvSource({"-1, 1", "2, 1", "NaN, 1", "0, NaN"})
    void refusesARangeThatIsNone(double tMin, double tMax) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Ray(ORIGIN, UP, tMin, tMax))
                .withMessageContaining("range");
    }
}
