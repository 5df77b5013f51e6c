package org.dronewatch.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.NavigableMap;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.concurrent.ThreadLocalRandom;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.mesh.io.ModelRole;
import org.junit.jupiter.api.Test;

/** The ground under a place is neither a roof nor a canopy, nor the bottom of a slab. */
class GroundLevelTest {
    private static final TriangleMesh GROUND = level(-100, 100, 0, true);
    private static final TriangleMesh HOUSE = box(10, 30, 0, 25);

    @Test
    void overAHouseTheGroundOnWhichItStandsCounts() {
        // In either order: the house's underside lies in the plane of the ground.
        for (List<TriangleMesh> order : List.of(List.of(GROUND, HOUSE), List.of(HOUSE, GROUND))) {
            GroundLevel ground = new GroundLevel(World.of(World.merge(order)));
            for (double x = 5; x < 35; x += 0.25) {
                assertThat(ground.height(new Position(x, 3, 27)))
                        .as("x %.2f", x)
                        .isEqualTo(27);
            }
        }
    }

    @Test
    void underACanopyAndOnAnUpperFloorTheSameGroundCounts() {
        TriangleMesh canopy = level(-20, 20, 6, true);
        TriangleMesh upsideDown = level(-20, 20, 3, false);
        GroundLevel ground = new GroundLevel(World.of(World.merge(List.of(canopy, upsideDown, GROUND))));

        for (double z : new double[] {0, 1.5, 3, 4.5, 6, 7.5}) {
            assertThat(ground.height(new Position(1, 2, z))).isEqualTo(z);
        }
    }

    @Test
    void onASlabItsTopCounts() {
        GroundLevel ground = new GroundLevel(World.of(box(-50, 50, -4, 0)));

        assertThat(ground.height(new Position(1, 2, 1.5))).isEqualTo(1.5);
        assertThat(ground.height(new Position(1, 2, -1))).isEqualTo(3);
    }

    /** A room as a box seen from inside or from outside: its floor counts, never its ceiling. */
    @Test
    void inARoomItsFloorCounts() {
        GroundLevel outward = new GroundLevel(World.of(box(0, 10, 2, 6)));
        TriangleMesh inward = World.merge(List.of(level(0, 10, 2, true), level(0, 10, 6, false)));

        assertThat(outward.height(new Position(5, 5, 3.5))).isEqualTo(1.5);
        assertThat(new GroundLevel(World.of(inward)).height(new Position(5, 5, 3.5)))
                .isEqualTo(1.5);
    }

    @Test
    void statedTerrainCountsUnderEverythingElse() {
        TriangleMesh cellar = level(-5, 5, -3, true);
        World site = sited(List.of(level(-40, 40, 0, true), cellar, box(-5, 5, 0, 9), box(50, 60, 1, 12)));
        GroundLevel ground = new GroundLevel(site);

        assertThat(ground.height(new Position(1, 2, 10.5))).isEqualTo(10.5);
        assertThat(ground.height(new Position(1, 2, -2))).as("in the cellar").isZero();
        // The house where the terrain has a hole stands on its underside.
        assertThat(ground.height(new Position(55, 55, 13))).isEqualTo(12);
        assertThat(ground.height(new Position(75, 75, 13))).as("nothing below").isEqualTo(13);
        assertThat(ground.height(new Position(75, 75, -13))).isZero();
    }

    /** On a hill it is the height over what is straight below, on the edges of its triangles, too. */
    @Test
    void onAHillItIsTheHeightOverTheSurfaceBelow() {
        long seed = ThreadLocalRandom.current().nextLong();
        SplittableRandom random = new SplittableRandom(seed);
        World world = World.of(hill(12));
        GroundLevel ground = new GroundLevel(world);
        Ground below = world.newGround();
        for (int i = 0; i < 500; i++) {
            boolean isOnEdges = i % 2 == 0;
            double x = isOnEdges ? random.nextInt(1, 12) * 0.7 : random.nextDouble(0, 8.4);
            double y = i % 4 == 0 ? random.nextInt(1, 12) * 0.7 : random.nextDouble(0, 8.4);
            double surface = below.height(x, y).orElseThrow();
            assertThat(ground.height(new Position(x, y, surface + 1.5)))
                    .as("seed %d, (%s, %s)", seed, x, y)
                    .isCloseTo(1.5, within(1e-6));
        }
    }

    private static TriangleMesh hill(int cells) {
        float[] vertices = new float[3 * (cells + 1) * (cells + 1)];
        for (int i = 0; i < vertices.length / 3; i++) {
            vertices[3 * i] = 0.7F * (i % (cells + 1));
            vertices[3 * i + 1] = 0.7F * (i / (cells + 1));
            vertices[3 * i + 2] = (float) Math.sin(1.3 * i);
        }
        List<Integer> corners = new ArrayList<>();
        for (int i = 0; i < cells * cells; i++) {
            int at = i / cells * (cells + 1) + i % cells;
            corners.addAll(List.of(at, at + 1, at + cells + 2, at, at + cells + 2, at + cells + 1));
        }
        return TriangleMesh.of(
                vertices, corners.stream().mapToInt(Integer::intValue).toArray());
    }

    /** A world whose first mesh is terrain, and whose others are buildings. */
    private static World sited(List<TriangleMesh> meshes) {
        NavigableMap<Integer, SiteModel> models = new TreeMap<>();
        models.put(0, new SiteModel("terrain.obj", ModelRole.TERRAIN));
        models.put(meshes.get(0).triangleCount(), new SiteModel("houses.obj", ModelRole.BUILDING));
        return World.of(World.merge(meshes)).withModels(models);
    }

    private static TriangleMesh level(double low, double high, double z, boolean facesUp) {
        float from = (float) low;
        float to = (float) high;
        float[] vertices = {from, from, (float) z, to, from, (float) z, to, to, (float) z, from, to, (float) z};
        return TriangleMesh.of(vertices, facesUp ? new int[] {0, 1, 2, 0, 2, 3} : new int[] {0, 2, 1, 0, 3, 2});
    }

    /** A box from (low, low) to (high, high) with its faces outward, without walls, which no vertical meets. */
    private static TriangleMesh box(double low, double high, double bottom, double top) {
        return World.merge(List.of(level(low, high, bottom, false), level(low, high, top, true)));
    }
}
