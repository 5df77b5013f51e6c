package org.dronewatch.models;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class HillTerrainTest {
    private static final HillTerrain TERRAIN = new HillTerrain();

    @Test
    void itReallyHidesThings() {
        assertThat(new Viewshed(TERRAIN).hiddenFraction(12, 700)).isBetween(0.25, 0.60);
    }

    @Test
    void aLevelWayFromTheNorthIsClear() {
        assertThat(new Viewshed(TERRAIN).clearanceOnApproachFromNorth(12, 300)).isGreaterThan(10.0);
    }

    @Test
    void theTopIsLevelEnoughForAHouse() {
        for (double x = -12; x <= 12; x += 1.5) {
            for (double y = -8; y <= 8; y += 2) {
                assertThat(TERRAIN.groundHeight(x, y)).isCloseTo(HillTerrain.TOP_METRES, within(0.2));
            }
        }
    }

    @Test
    void slopesAreThoseOfLand() {
        assertThat(TERRAIN.steepestDegrees()).isBetween(20.0, 45.0);
    }

    /** Points of the mesh's own triangles must lie on the ground that the height function gives. */
    @Test
    void theHeightFunctionFollowsTheMesh() {
        long seed = 99;
        SplittableRandom random = new SplittableRandom(seed);
        Mesh mesh = TERRAIN.mesh();
        int[] triangles = mesh.triangles();
        for (int n = 0; n < 20_000; n++) {
            int i = 3 * random.nextInt(triangles.length / 3);
            double u = random.nextDouble();
            double v = random.nextDouble() * (1 - u);
            Point a = mesh.vertices().get(triangles[i]);
            Point b = mesh.vertices().get(triangles[i + 1]).minus(a);
            Point c = mesh.vertices().get(triangles[i + 2]).minus(a);
            Point p = a.plus(b.times(u)).plus(c.times(v));
            assertThat(TERRAIN.groundHeight(p.x(), -p.z()))
                    .as("at %s, seed %d", p, seed)
                    .isCloseTo(p.y(), within(1e-3));
        }
    }

    @Test
    void thereIsNothingBeyondTheEdge() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> TERRAIN.groundHeight(751, 0))
                .withMessageContaining("751");
        assertThatIllegalArgumentException().isThrownBy(() -> TERRAIN.groundHeight(0, Double.NaN));
    }
}
