package org.dronewatch.sensor.radio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

/** Lines fitted to slopes, steps and ramps: the least squares of nine heights, by hand. */
class SurfaceLineTest {
    /** Ground along the diagonal x = y from (100, 100): heights by distance on the map, 10 km wide. */
    private static World alongDiagonal(double[] distances, double[] heights) {
        float[] corners = new float[6 * distances.length];
        int[] triangles = new int[6 * (distances.length - 1)];
        double half = Math.sqrt(0.5);
        for (int i = 0; i < distances.length; i++) {
            for (int side = 0; side < 2; side++) {
                double across = side == 0 ? 5000 : -5000;
                corners[6 * i + 3 * side] = (float) (100 + half * (distances[i] + across));
                corners[6 * i + 3 * side + 1] = (float) (100 + half * (distances[i] - across));
                corners[6 * i + 3 * side + 2] = (float) heights[i];
            }
            for (int k = 0; k < 6 && i > 0; k++) {
                triangles[6 * (i - 1) + k] = 2 * (i - 1) + new int[] {0, 1, 3, 0, 3, 2}[k];
            }
        }
        return World.of(TriangleMesh.of(corners, triangles));
    }

    private static final Position FROM = new Position(100, 100, 40);
    private static final Position TO = new Position(100 + 300, 100 + 400, 10);
    private static final Position DIAGONAL = new Position(100 + 400, 100 + 400, 10);
    private static final double WIDTH = 400 * Math.sqrt(2);

    /** On the plane z = 5 + 0.1 x - 0.2 y, a path to (0.6, 0.8) sinks by 0.1 m per metre; nothing deviates. */
    @Test
    void aPlaneIsItsOwnLine() {
        World world = World.of(TriangleMesh.of(
                new float[] {-1000, -1000, 105, 2000, -1000, 405, 2000, 2000, -195, -1000, 2000, -495},
                new int[] {0, 1, 2, 0, 2, 3}));
        SurfaceLine line = new SurfaceLine(world.newGround());
        assertThat(line.fit(FROM, TO, 500, 120, 70)).isTrue();
        assertThat(line.slope()).isCloseTo(0.06 - 0.16, within(1e-5));
        assertThat(line.height(0)).isCloseTo(5 + 10 - 20, within(1e-3));
        assertThat(line.height(500)).isCloseTo(5 + 40 - 100, within(1e-3));
        assertThat(line.uneven()).isCloseTo(0, within(1e-3));
    }

    /** Level ground with a step of 9 m between the third and the fourth of nine places, 10 m apart about 200 m. */
    @Test
    void aStepIsFittedByLeastSquares() {
        World world = alongDiagonal(new double[] {-500, 184.9, 185.1, 2000}, new double[] {0, 0, 9, 9});
        SurfaceLine line = new SurfaceLine(world.newGround());
        assertThat(line.fit(FROM, DIAGONAL, WIDTH, 200, 40)).isTrue();
        // Products with the places -40 ... 40: 9 (-10 + 0 + 10 + 20 + 30 + 40) = 810; squares 6000; mean 6.
        double slope = 810.0 / 6000;
        assertThat(line.slope()).isCloseTo(slope, within(1e-6));
        assertThat(line.height(200)).isCloseTo(6, within(1e-5));
        // Of the squares about the mean, 3 36 + 6 9 = 162, the slope explains its square times 6000.
        assertThat(line.uneven()).isCloseTo(Math.sqrt((162 - slope * slope * 6000) / 9), within(1e-5));
    }

    @Test
    void aPointIsLevelAndWithoutGroundThereIsNoLine() {
        World world = alongDiagonal(new double[] {-500, 200, 2000}, new double[] {0, 0, 180});
        SurfaceLine line = new SurfaceLine(world.newGround());
        assertThat(line.fit(FROM, DIAGONAL, WIDTH, 300, 0)).isTrue();
        assertThat(List.of(line.slope(), line.uneven())).allMatch(value -> value == 0);
        assertThat(line.height(1000)).isCloseTo(10, within(1e-4));
        assertThat(world.newGround().height(100, 100)).isNotEqualTo(OptionalDouble.empty());
        assertThat(line.fit(FROM, DIAGONAL, WIDTH, 1900, 150)).isFalse();
    }
}
