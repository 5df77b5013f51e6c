package org.dronewatch.world;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** When a point seems to be inside a wall or under the ground. */
class SurroundingsTest {
    /** The side of a level square from the origin on, m; it faces up. */
    private static final float SIDE = 100;

    private static final World GROUND = World.of(TriangleMesh.of(
            new float[] {0, 0, 0, SIDE, 0, 0, SIDE, SIDE, 0, 0, SIDE, 0}, new int[] {0, 1, 2, 0, 2, 3}));

    /** The same square, which faces down: the soffit of something that has no other side. */
    private static final World SOFFIT = World.of(TriangleMesh.of(
            new float[] {0, 0, 0, SIDE, 0, 0, SIDE, SIDE, 0, 0, SIDE, 0}, new int[] {0, 2, 1, 0, 3, 2}));

    /** A cube of 2 m about the origin, closed. */
    private static final World CUBE = World.of(TriangleMesh.of(
            new float[] {-1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1},
            new int[] {
                0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4,
                7
            }));

    @ParameterizedTest
    @CsvSource({
        "50, 50, -1, true", // nine rays upwards meet the ground from behind
        "50, 0.01, -1, true", // six at its side
        "0.01, 0.01, -1, true", // four at its corner
        "50, 50, 1, false",
        "-50, 50, -1, false", // beside it, two rays meet its far side
        "-1000, -1000, 1, false",
    })
    void underAGroundItsBackIsSeen(double x, double y, double z, boolean isInside) {
        assertThat(GROUND.isInsideWall(new Position(x, y, z))).isEqualTo(isInside);
    }

    /** High above, one ray of 26 meets it, from behind. */
    @ParameterizedTest
    @CsvSource({"50, 50, 1, true", "50, 50, 300, false", "50, 50, 99, false"})
    void oneRayIsNoMajority(double x, double y, double z, boolean isInside) {
        assertThat(SOFFIT.isInsideWall(new Position(x, y, z))).isEqualTo(isInside);
    }

    @ParameterizedTest
    @CsvSource({"0, 0, 0, true", "0.9, -0.9, 0.9, true", "0, 0, 3, false", "3, 3, 3, false", "1.1, 0, 0, false"})
    void inAClosedBodyAllRaysMeetIt(double x, double y, double z, boolean isInside) {
        assertThat(CUBE.isInsideWall(new Position(x, y, z))).isEqualTo(isInside);
    }

    /** Half of the rays from there go through the body, but what is mounted on a wall is outside. */
    @ParameterizedTest
    @CsvSource({"1, 0, 0", "-1, 0.2, 0.3", "0, 0, 1", "0.3, -1, -0.9", "1, 1, 0.2", "-1, -1, 1"})
    void aPointOnAClosedBodyIsInFrontOfIt(double x, double y, double z) {
        assertThat(CUBE.isInsideWall(new Position(x, y, z))).isFalse();
        assertThat(CUBE.isInsideWall(new Position(0.999 * x, 0.999 * y, 0.999 * z)))
                .isTrue();
    }
}
