package org.dronewatch.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.dronewatch.LongForm;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Segments worked out by hand, and those of random triangles by what defines them. */
class CutTriangleTest {
    private static final Position ORIGIN = new Position(0, 0, 0);
    private static final Position UP = new Position(0, 0, 1);
    private static final double TOLERANCE = 0.5;

    /** One above the plane z = 0 at 1 m, two below it at 1 and 3 m. */
    private static final float[][] ONE_ABOVE = {{0, 0, 1}, {4, 0, -1}, {0, 6, -3}};

    /** A cutter of triangles whose corners are given one after the other. */
    private static CutTriangle cutter(double tolerance, float[]... corners) {
        return new CutTriangle((triangle, corner, axis) -> corners[3 * triangle + corner][axis], tolerance);
    }

    private static CutTriangle cutterAtHeights(double... heights) {
        float[][] corners = {{3, 1, (float) heights[0]}, {5, 1, (float) heights[1]}, {4, 7, (float) heights[2]}};
        return cutter(TOLERANCE, corners);
    }

    private static List<Position> ends(CutTriangle cut) {
        return List.of(end(cut.first()), end(cut.second()));
    }

    /** Without the sign of a zero. */
    private static Position end(double[] at) {
        return new Position(at[0] + 0.0, at[1] + 0.0, at[2] + 0.0);
    }

    @ParameterizedTest
    @CsvSource({"0, 1, 2", "1, 2, 0", "2, 0, 1", "0, 2, 1", "2, 1, 0", "1, 0, 2"})
    void theSidesOfACornerThatIsAloneAreCut(int first, int second, int third) {
        CutTriangle cut = cutter(1e-7, ONE_ABOVE[first], ONE_ABOVE[second], ONE_ABOVE[third]);

        for (Position normal : new Position[] {UP, UP.times(-1)}) {
            assertThat(cut.cut(0, ORIGIN, normal)).isTrue();
            assertThat(ends(cut)).containsExactlyInAnyOrder(new Position(2, 0, 0), new Position(0, 1.5, 0));
        }
    }

    @Test
    void theEndsAreRelativeToThePlanesOrigin() {
        CutTriangle cut = cutter(1e-7, ONE_ABOVE);

        assertThat(cut.cut(0, new Position(1, 2, 0), UP)).isTrue();
        assertThat(ends(cut)).containsExactlyInAnyOrder(new Position(1, -2, 0), new Position(-1, -0.5, 0));
        assertThat(cut.cut(0, new Position(1, 2, -2), UP)).isTrue();
        assertThat(ends(cut)).containsExactlyInAnyOrder(new Position(-1, 2.5, 0), new Position(1, 1, 0));
    }

    @Test
    void aTriangleOnOneSideOfThePlaneIsNotCut() {
        assertThat(cutterAtHeights(1, 2, 3).cut(0, ORIGIN, UP)).isFalse();
        assertThat(cutterAtHeights(-1, -2, -3).cut(0, ORIGIN, UP)).isFalse();
        assertThat(cutter(1e-7, ONE_ABOVE).cut(0, new Position(0, 0, 1.001), UP))
                .isFalse();
        assertThat(cutter(1e-7, ONE_ABOVE).cut(0, new Position(0, 0, -3.001), UP))
                .isFalse();
    }

    /** Corners on the plane count as above it, however many they are. */
    @ParameterizedTest
    @CsvSource({"0, 0, 0", "0, 0, 2", "0, 2, 2", "-0.0, 2, 0"})
    void aTriangleThatTouchesThePlaneFromAboveIsNotCut(double first, double second, double third) {
        assertThat(cutterAtHeights(first, second, third).cut(0, ORIGIN, UP)).isFalse();
        assertThat(cutterAtHeights(third, first, second).cut(0, ORIGIN, UP)).isFalse();
        assertThat(cutterAtHeights(second, third, first).cut(0, ORIGIN, UP)).isFalse();
    }

    @Test
    void aTriangleThatTouchesThePlaneFromBelowIsCutAtThatCorner() {
        CutTriangle cut = cutterAtHeights(-2, 0, -3);

        assertThat(cut.cut(0, ORIGIN, UP)).isTrue();
        assertThat(ends(cut)).containsExactly(new Position(5, 1, 0), new Position(5, 1, 0));
    }

    @Test
    void aTriangleThatHangsFromThePlaneIsCutAlongItsSide() {
        CutTriangle cut = cutterAtHeights(0, -2, 0);

        assertThat(cut.cut(0, ORIGIN, UP)).isTrue();
        assertThat(ends(cut)).containsExactlyInAnyOrder(new Position(3, 1, 0), new Position(4, 7, 0));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.0, -0.25, -0.49999997})
    void aCornerNearerToThePlaneThanTheToleranceLiesOnIt(double height) {
        assertThat(cutterAtHeights(height, 2, 2).cut(0, ORIGIN, UP)).isFalse();
    }

    @ParameterizedTest
    @ValueSource(doubles = {-0.5, -0.50000006, -1.0})
    void aCornerAsFarFromThePlaneAsTheToleranceDoesNotLieOnIt(double height) {
        assertThat(cutterAtHeights(height, 2, 2).cut(0, ORIGIN, UP)).isTrue();
    }

    /** By what defines the segment: a triangle is cut if its corners are on both sides, in points of two sides. */
    @Test
    void theEndsAreOnThePlaneAndOnTwoSidesOfTheTriangle() {
        long seed = LongForm.seed(40);
        SplittableRandom random = new SplittableRandom(seed);
        int cuts = 0;
        for (int i = 0; i < 3000; i++) {
            float[][] corners = {point(random), point(random), point(random)};
            Position origin = position(point(random));
            Position normal = position(point(random)).unit();
            CutTriangle cut = cutter(0.0, corners);
            boolean isAnyAbove = false;
            boolean isAnyBelow = false;
            for (float[] corner : corners) {
                boolean isAbove = position(corner).minus(origin).dot(normal) >= 0.0;
                isAnyAbove |= isAbove;
                isAnyBelow |= !isAbove;
            }
            String what = "triangle " + i + " of seed " + seed;

            assertThat(cut.cut(0, origin, normal)).as(what).isEqualTo(isAnyAbove && isAnyBelow);
            if (isAnyAbove && isAnyBelow) {
                cuts++;
                int sides = 0;
                boolean isAtCorner = false;
                for (Position at : ends(cut)) {
                    assertThat(at.dot(normal)).as(what).isCloseTo(0.0, within(1e-12));
                    sides |= side(corners, at.plus(origin));
                    isAtCorner |= Stream.of(corners)
                            .anyMatch(corner -> position(corner).distance(at.plus(origin)) < 1e-6);
                }
                // A corner belongs to two sides.
                assertThat(Integer.bitCount(sides)).as(what).isBetween(isAtCorner ? 1 : 2, 2);
            }
        }
        assertThat(cuts).isGreaterThan(500);
    }

    /** The side nearest to a point, which must lie on it, as one of three bits. */
    private static int side(float[][] corners, Position at) {
        int nearest = 0;
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < 3; k++) {
            Position one = position(corners[k]);
            Position other = position(corners[(k + 1) % 3]);
            double detour = one.distance(at) + at.distance(other) - one.distance(other);
            if (detour < least) {
                least = detour;
                nearest = 1 << k;
            }
        }
        assertThat(least).isLessThan(1e-12);
        return nearest;
    }

    @Test
    void trianglesThatShareASideAreCutThereInOnePointToTheLastBit() {
        long seed = LongForm.seed(41);
        SplittableRandom random = new SplittableRandom(seed);
        int shared = 0;
        for (int i = 0; i < 3000; i++) {
            float[] one = point(random);
            float[] other = point(random);
            Position origin = position(point(random));
            Position normal = position(point(random)).unit();
            if (position(one).minus(origin).dot(normal) > 0.0
                    == position(other).minus(origin).dot(normal) > 0.0) {
                continue;
            }
            shared++;
            CutTriangle cut = cutter(1e-7, one, other, point(random), point(random), other, one);
            assertThat(cut.cut(0, origin, normal)).isTrue();
            List<Position> first = ends(cut);
            assertThat(cut.cut(1, origin, normal)).isTrue();

            assertThat(ends(cut)).as("pair %d of seed %d", i, seed).containsAnyElementsOf(first);
        }
        assertThat(shared).isGreaterThan(500);
    }

    /** From any direction, and though the plane misses it by a fraction of the tolerance. */
    @Test
    void sidesThatEndInACornerOnThePlaneAreAllCutInThatCorner() {
        long seed = LongForm.seed(42);
        SplittableRandom random = new SplittableRandom(seed);
        int cuts = 0;
        for (int i = 0; i < 3000; i++) {
            float[] corner = point(random);
            Position normal = position(point(random)).unit();
            Position origin = position(corner).plus(normal.times(1e-8 * random.nextDouble(-1.0, 1.0)));
            Position at = position(corner).minus(origin);
            CutTriangle cut = cutter(1e-7, point(random), corner, point(random));
            if (cut.cut(0, origin, normal)) {
                cuts++;
                assertThat(ends(cut)).as("triangle %d of seed %d", i, seed).contains(at);
            }
        }
        assertThat(cuts).isGreaterThan(500);
    }

    @ParameterizedTest
    @CsvSource({"2, 0, 0, 1, 9, 9", "1, 2, 0, 1, 1, 9", "1, 1, 2, 1, 1, 1", "0, 0, 5e-324, -0.0, 0, 0"})
    void pointsAreOrderedByTheFirstCoordinateThatDiffers(
            double px, double py, double pz, double qx, double qy, double qz) {
        double[] p = {px, py, pz};
        double[] q = {qx, qy, qz};

        assertThat(CutTriangle.isAfter(p, q)).isTrue();
        assertThat(CutTriangle.isAfter(q, p)).isFalse();
        assertThat(CutTriangle.isAfter(p, p)).isFalse();
    }

    /** Between -1 and 1 m on each axis. */
    private static float[] point(SplittableRandom random) {
        float[] point = new float[3];
        for (int axis = 0; axis < 3; axis++) {
            point[axis] = (float) random.nextDouble(-1.0, 1.0);
        }
        return point;
    }

    private static Position position(float[] point) {
        return new Position(point[0], point[1], point[2]);
    }
}
