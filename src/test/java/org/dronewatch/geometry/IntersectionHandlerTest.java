package org.dronewatch.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import java.util.SplittableRandom;
import org.dronewatch.LongForm;
import org.jogamp.vecmath.Point3d;
import org.jogamp.vecmath.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class IntersectionHandlerTest {
    private static final Triangle TRIANGLE =
            new Triangle(new Position(0, 0, 1), new Position(4, 0, 1), new Position(0, 4, 1), 7, 0);
    private static final AABB BOX = new AABB(0, 0, 0, 1, 2, 3);
    private static final Point3d CENTER = new Point3d(10, 0, 0);

    private static Ray ray(double ox, double oy, double oz, double dx, double dy, double dz) {
        return new Ray(new Point3d(ox, oy, oz), new Vector3d(dx, dy, dz));
    }

    // Triangles.

    @ParameterizedTest
    @CsvSource({"0, 1", "3, -1"})
    void aTriangleIsHitFromBothSides(double z, double dz) {
        Hit hit = IntersectionHandler.rayTriangle(ray(1, 2, z, 0, 0, dz), TRIANGLE)
                .orElseThrow();

        assertThat(hit).isEqualTo(new Hit(Math.abs(1 - z), 7, 0.25, 0.5));
    }

    @ParameterizedTest
    @CsvSource({"0, 0", "4, 0", "0, 4", "2, 0", "0, 2", "2, 2"})
    void cornersAndEdgesBelongToATriangle(double x, double y) {
        assertThat(IntersectionHandler.rayTriangle(ray(x, y, 0, 0, 0, 1), TRIANGLE))
                .isPresent();
    }

    @ParameterizedTest
    @CsvSource({"-0.001, 1", "1, -0.001", "2.001, 2", "5, 0", "-1, -1"})
    void aRayBesideATriangleMisses(double x, double y) {
        assertThat(IntersectionHandler.rayTriangle(ray(x, y, 0, 0, 0, 1), TRIANGLE))
                .isEmpty();
    }

    @Test
    void aRayParallelToATriangleOrTurnedAwayMisses() {
        assertThat(IntersectionHandler.rayTriangle(ray(-1, 1, 1, 1, 0, 0), TRIANGLE))
                .isEmpty();
        assertThat(IntersectionHandler.rayTriangle(ray(-1, 1, 0, 1, 0, 0), TRIANGLE))
                .isEmpty();
        assertThat(IntersectionHandler.rayTriangle(ray(1, 1, 0, 0, 0, -1), TRIANGLE))
                .isEmpty();
    }

    @Test
    void aTriangleWithoutAreaIsNeverHit() {
        Triangle line = new Triangle(new Position(0, 0, 1), new Position(1, 1, 1), new Position(2, 2, 1), 0, 0);

        assertThat(IntersectionHandler.rayTriangle(ray(1, 1, 0, 0, 0, 1), line)).isEmpty();
    }

    @Test
    void aHitCountsWithinTheRaysRangeOnly() {
        Point3d origin = new Point3d(1, 1, 0);
        Vector3d direction = new Vector3d(0, 0, 0.5);

        assertThat(IntersectionHandler.rayTriangle(new Ray(origin, direction, 0, 2), TRIANGLE))
                .map(Hit::distance)
                .hasValue(2.0);
        assertThat(IntersectionHandler.rayTriangle(new Ray(origin, direction, 2, 9), TRIANGLE))
                .isPresent();
        assertThat(IntersectionHandler.rayTriangle(new Ray(origin, direction, 0, Math.nextDown(2.0)), TRIANGLE))
                .isEmpty();
        assertThat(IntersectionHandler.rayTriangle(new Ray(origin, direction, Math.nextUp(2.0), 9), TRIANGLE))
                .isEmpty();
    }

    @Test
    void weightsAndDistanceGiveTheSamePoint() {
        SplittableRandom random = new SplittableRandom(30);
        for (int i = 0; i < 20_000; i++) {
            double scale = Math.pow(10, 12 * random.nextDouble() - 6);
            Triangle triangle =
                    new Triangle(position(random, scale), position(random, scale), position(random, scale), i, 0);
            double u = random.nextDouble();
            double v = (1 - u) * random.nextDouble();
            Position target = triangle.a()
                    .times(1 - u - v)
                    .plus(triangle.b().times(u))
                    .plus(triangle.c().times(v));
            Position origin = position(random, 3 * scale);
            Vector3d direction = target.minus(origin).toVector3d();
            direction.scale(0.1 + 10 * random.nextDouble());
            double conditioning = Math.abs(triangle.areaNormal().dot(direction)) / direction.length() / scale / scale;
            if (conditioning < 1e-3 || u + v > 1 - 1e-9 || v < 1e-9 || u < 1e-9) {
                continue;
            }

            Ray ray = new Ray(origin.toPoint3d(), direction);
            Optional<Hit> hit = IntersectionHandler.rayTriangle(ray, triangle);

            String what = "triangle " + i + " of seed 30";
            assertThat(hit).as(what).isPresent();
            assertThat(hit.get().u()).as(what).isCloseTo(u, within(1e-10));
            assertThat(hit.get().v()).as(what).isCloseTo(v, within(1e-10));
            assertThat(Position.of(ray.pointAt(hit.get().distance())).distance(target))
                    .as(what)
                    .isLessThan(1e-10 * scale);
        }
    }

    private static Position position(SplittableRandom random, double scale) {
        return new Position(coordinate(random, scale), coordinate(random, scale), coordinate(random, scale));
    }

    private static double coordinate(SplittableRandom random, double scale) {
        return scale * (2 * random.nextDouble() - 1);
    }

    // Boxes.

    private static double[] box(Ray ray, AABB box) {
        double[] interval = {-7, -7};
        boolean meets = IntersectionHandler.rayBox(ray, box, interval);
        if (!meets) {
            assertThat(interval).as("a miss leaves the interval alone").containsExactly(-7, -7);
        }
        // Plus zero: an interval may begin or end at a zero of either sign.
        return meets ? new double[] {interval[0] + 0.0, interval[1] + 0.0} : new double[0];
    }

    @Test
    void aBoxIsMetAtItsSlabs() {
        assertThat(box(ray(-1, 1, 1, 1, 0, 0), BOX)).containsExactly(1, 2);
        assertThat(box(ray(4, 1, 1, -2, 0, 0), BOX)).containsExactly(1.5, 2);
        assertThat(box(ray(-1, -1, -1, 1, 1, 1), BOX)).containsExactly(1, 2);
        assertThat(box(ray(0.5, 1, 1, 0, 0, 1), BOX)).containsExactly(0, 2);
    }

    @Test
    void aBoxBesideOrBehindIsMissed() {
        assertThat(box(ray(-1, 3, 1, 1, 0, 0), BOX)).isEmpty();
        assertThat(box(ray(2, 1, 1, 1, 0, 0), BOX)).isEmpty();
        assertThat(box(ray(-1, 1.5, 1, 1, 1, 0), BOX)).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({"0.0, 0.0", "-0.0, 0.0", "0.0, -0.0", "-0.0, -0.0"})
    void aRayInsideAFaceOrEdgeIsInsideWhateverTheSignOfItsZeros(double dy, double dz) {
        for (double y : new double[] {0, 2}) {
            for (double z : new double[] {0, 1, 3}) {
                assertThat(box(ray(-1, y, z, 1, dy, dz), BOX)).containsExactly(1, 2);
            }
        }
        assertThat(box(ray(-1, Math.nextUp(2.0), 1, 1, dy, dz), BOX)).isEmpty();
        assertThat(box(ray(-1, -Double.MIN_VALUE, 1, 1, dy, dz), BOX)).isEmpty();
    }

    @Test
    void anOriginOnAFaceIsInside() {
        assertThat(box(ray(1, 1, 1, 1, 0, 0), BOX)).containsExactly(0, 0);
        assertThat(box(ray(1, 1, 1, -1, 0, 0), BOX)).containsExactly(0, 1);
        assertThat(box(ray(0, 0, 0, -1, -1, -1), BOX)).containsExactly(0, 0);
    }

    @Test
    void aFlatBoxIsMetFromBothSidesAndAlong() {
        AABB flat = new AABB(0, 0, 1, 1, 1, 1);

        assertThat(box(ray(0.5, 0.5, 0, 0, 0, 1), flat)).containsExactly(1, 1);
        assertThat(box(ray(0.5, 0.5, 2, 0, 0, -1), flat)).containsExactly(1, 1);
        assertThat(box(ray(-1, 0.5, 1, 1, 0, 0), flat)).containsExactly(1, 2);
    }

    @Test
    void aBoxIsMetWithinTheRaysRangeOnly() {
        Point3d origin = new Point3d(-1, 1, 1);
        Vector3d direction = new Vector3d(1, 0, 0);

        assertThat(box(new Ray(origin, direction, 1.25, 1.5), BOX)).containsExactly(1.25, 1.5);
        assertThat(box(new Ray(origin, direction, 0, 0.99), BOX)).isEmpty();
        assertThat(box(new Ray(origin, direction, 2.01, 3), BOX)).isEmpty();
        assertThat(box(new Ray(origin, direction, 2, 3), BOX)).containsExactly(2, 2);
    }

    @Test
    void randomRaysMeetABoxWhereTheirPointsAreInIt() {
        SplittableRandom random = new SplittableRandom(31);
        for (int i = 0; i < 5000; i++) {
            Ray ray =
                    new Ray(position(random, 4).toPoint3d(), position(random, 1).toVector3d());
            double[] interval = box(ray, BOX);
            for (int step = 0; step <= 100; step++) {
                double t = 0.1 * step;
                boolean inside = interval.length == 2 && t >= interval[0] && t <= interval[1];
                boolean nearBorder =
                        interval.length == 2 && (Math.abs(t - interval[0]) < 1e-9 || Math.abs(t - interval[1]) < 1e-9);
                assertThat(BOX.contains(ray.pointAt(t)) == inside || nearBorder)
                        .as("%s of seed 31 at %s", ray, t)
                        .isTrue();
            }
        }
    }

    // Spheres.

    @Test
    void aSphereIsMetAtItsNearSide() {
        assertThat(IntersectionHandler.raySphere(ray(0, 0, 0, 1, 0, 0), CENTER, 2))
                .hasValue(8);
        assertThat(IntersectionHandler.raySphere(ray(0, 0, 0, 4, 0, 0), CENTER, 2))
                .hasValue(2);
        assertThat(IntersectionHandler.raySphere(ray(0, 3, 0, 1, 0, 0), CENTER, 5))
                .hasValue(6);
    }

    @Test
    void insideASphereTheDistanceIsZero() {
        assertThat(IntersectionHandler.raySphere(ray(10, 0, 0, 0, 1, 0), CENTER, 2))
                .hasValue(0);
        assertThat(IntersectionHandler.raySphere(ray(11, 1, 0, 1, 0, 0), CENTER, 2))
                .hasValue(0);
        assertThat(IntersectionHandler.raySphere(ray(8, 0, 0, 1, 0, 0), CENTER, 2))
                .hasValue(0);
        assertThat(IntersectionHandler.raySphere(ray(12, 0, 0, 1, 0, 0), CENTER, 2))
                .hasValue(0);
        Ray later = new Ray(CENTER, new Vector3d(1, 0, 0), 1.5, 9);
        assertThat(IntersectionHandler.raySphere(later, CENTER, 2)).hasValue(1.5);
    }

    @Test
    void aTangentTouches() {
        assertThat(IntersectionHandler.raySphere(ray(0, 2, 0, 1, 0, 0), CENTER, 2))
                .hasValue(10);
        assertThat(IntersectionHandler.raySphere(ray(0, Math.nextUp(2.0), 0, 1, 0, 0), CENTER, 2))
                .isEmpty();
    }

    @Test
    void aSphereBehindOrOutOfRangeIsMissed() {
        assertThat(IntersectionHandler.raySphere(ray(13, 0, 0, 1, 0, 0), CENTER, 2))
                .isEmpty();
        Vector3d east = new Vector3d(1, 0, 0);
        assertThat(IntersectionHandler.raySphere(new Ray(new Point3d(), east, 0, 7.9), CENTER, 2))
                .isEmpty();
        assertThat(IntersectionHandler.raySphere(new Ray(new Point3d(), east, 12.1, 20), CENTER, 2))
                .isEmpty();
        assertThat(IntersectionHandler.raySphere(new Ray(new Point3d(), east, 0, 8), CENTER, 2))
                .hasValue(8);
    }

    @Test
    void aSmallSphereFarAwayIsMetExactly() {
        Point3d far = new Point3d(1e8, 0, 0);

        assertThat(IntersectionHandler.raySphere(ray(0, 0.0999, 0, 1, 0, 0), far, 0.1))
                .isPresent();
        assertThat(IntersectionHandler.raySphere(ray(0, 0.1001, 0, 1, 0, 0), far, 0.1))
                .isEmpty();
    }

    @ParameterizedTest
    @CsvSource({"0", "-1", "NaN"})
    void aSphereNeedsARadius(double radius) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> IntersectionHandler.raySphere(ray(0, 0, 0, 1, 0, 0), CENTER, radius))
                .withMessageContaining("radius");
    }

    private static double kernelSphere(Ray ray, Point3d center, double radius) {
        Point3d o = ray.origin();
        Vector3d d = ray.direction();
        return IntersectionHandler.raySphere(o.x, o.y, o.z, d.x, d.y, d.z, center.x, center.y, center.z, radius);
    }

    /** The sphere of radius 2 around (10, 0, 0), met by rays to the east. */
    @ParameterizedTest
    @CsvSource({
        "0, 0, 8",
        "-90, 0, 98",
        "8, 0, 0",
        "9, 0, 0",
        "10, 0, 0",
        "12, 0, 0",
        "12.000000000000002, 0, Infinity",
        "13, 0, Infinity",
        "0, 2, 10",
        "0, -2, 10",
        "10, 2, 0",
        "10.000000000000002, 2, Infinity",
        "0, 2.0000000000000004, Infinity",
        "0, 3, Infinity"
    })
    void theKernelMeetsASphereAtItsNearSideOrWhereItStarts(double x, double beside, double distance) {
        assertThat(kernelSphere(ray(x, beside, 0, 1, 0, 0), CENTER, 2)).isEqualTo(distance);
        assertThat(kernelSphere(ray(x, 0, beside, 1, 0, 0), CENTER, 2)).isEqualTo(distance);
    }

    @Test
    void theKernelMeetsASmallSphereFarAwayExactly() {
        Point3d far = new Point3d(1e8, 0, 0);

        assertThat(kernelSphere(ray(0, 0.0999, 0, 1, 0, 0), far, 0.1)).isCloseTo(1e8, within(0.1));
        assertThat(kernelSphere(ray(0, 0.1001, 0, 1, 0, 0), far, 0.1)).isInfinite();
    }

    @Test
    void theKernelMeetsSpheresWhereTheReferenceDoes() {
        long seed = LongForm.seed(32);
        SplittableRandom random = new SplittableRandom(seed);
        int met = 0;
        for (int i = 0; i < 5000; i++) {
            Position origin = position(random, 9);
            Position middle = position(random, 9);
            double radius = 0.1 + 5 * random.nextDouble();
            Position target = middle.plus(position(random, 1.5 * radius));
            Ray ray = new Ray(origin, target.minus(origin).unit());
            Point3d center = middle.toPoint3d();

            double expected = IntersectionHandler.raySphere(ray, center, radius).orElse(Double.POSITIVE_INFINITY);
            double found = kernelSphere(ray, center, radius);

            assertThat(found == expected || Math.abs(found - expected) < 1e-6)
                    .as(
                            "%s of seed %d, sphere of %s m around %s: %s, not %s",
                            ray, seed, radius, center, found, expected)
                    .isTrue();
            met += found > 0.0 && found < Double.POSITIVE_INFINITY ? 1 : 0;
        }
        assertThat(met).isGreaterThan(500);
    }
}
