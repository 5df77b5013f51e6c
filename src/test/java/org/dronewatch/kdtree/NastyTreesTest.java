package org.dronewatch.kdtree;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.dronewatch.Thorough;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.parallel.Workers;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Trees of meshes whose triangles no plane parts well: how large they are, and that rays hit what they ought to. */
class NastyTreesTest {
    private static final int NO_LIMIT = Integer.MAX_VALUE;

    @Test
    void referencesAndNodesAreInProportionToTriangles() {
        NastyMeshes.all(3000, 90).forEach((name, mesh) -> {
            KDTree tree = KDTree.of(mesh);

            assertThat(tree.leafTriangles().length)
                    .as("references of %s", name)
                    .isBetween(mesh.triangleCount(), 16 * mesh.triangleCount());
            assertThat(tree.nodes().length).as("nodes of %s", name).isLessThan(5 * mesh.triangleCount());
        });
    }

    @ParameterizedTest
    @ValueSource(ints = {5000, 10_000})
    void aPolygonOfManyCornersHasATreeInProportion(int corners) {
        KDTree tree = KDTree.of(NastyMeshes.fan(corners));

        assertThat(tree.leafTriangles().length).isLessThanOrEqualTo(16 * (corners - 2));
        // The limit is there to be used: with a tenth of it, leaves would be several times as full.
        assertThat(tree.leafTriangles().length).isGreaterThan(10 * corners);
    }

    @Test
    void treesAreSound() {
        NastyMeshes.all(400, 91).forEach((name, mesh) -> TreeValidator.validate(name, KDTree.of(mesh)));
        TreeValidator.validate("large fan", KDTree.of(NastyMeshes.fan(2000)));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 5})
    void treesOfAnyLimitAreSoundAndWithinIt(int limit) {
        NastyMeshes.all(200, 92).forEach((name, mesh) -> {
            KDTree tree = new KDTreeBuilder(mesh, SahCost.DEFAULT, limit).build();
            assertThat(tree.leafTriangles().length).as(name).isLessThanOrEqualTo(limit * mesh.triangleCount());
            TreeValidator.validate(name + ", limit " + limit, tree);
        });
    }

    @ParameterizedTest
    @EnumSource
    void noTriangleIsLeftOut(Way way) {
        NastyMeshes.all(300, 93).forEach((name, mesh) -> {
            double[][] rays = new Rays(mesh, 94).any(600);
            way.assertSameAsExhaustive(KDTree.of(mesh), name + ", rays of seed 94", rays);
        });
    }

    @Thorough
    @ParameterizedTest
    @ValueSource(strings = {"hill.obj", "house.obj", "quadrotor.obj", "cathedral.obj"})
    void treesOfModelsAreThoseWithoutALimit(String model) {
        TriangleMesh mesh = Meshes.model(model);
        assertSame(KDTree.of(mesh), new KDTreeBuilder(mesh, SahCost.DEFAULT, NO_LIMIT).build());
    }

    @Test
    void theTreeIsTheSameForAnyNumberOfThreads() {
        for (TriangleMesh mesh : new TriangleMesh[] {NastyMeshes.fan(5000), besideAFan(Meshes.icosphere(3), 3000)}) {
            KDTree alone = KDTree.of(mesh);
            for (int threads = 2; threads <= 3; threads++) {
                try (Workers workers = new Workers(threads)) {
                    assertSame(workers.call(() -> KDTree.of(mesh)), alone);
                }
            }
        }
    }

    private static void assertSame(KDTree tree, KDTree expected) {
        assertThat(Arrays.equals(tree.nodes(), expected.nodes())).isTrue();
        assertThat(Arrays.equals(tree.leafTriangles(), expected.leafTriangles()))
                .isTrue();
        assertThat(Arrays.equals(
                        tree.triangles().numbers(), expected.triangles().numbers()))
                .isTrue();
        assertThat(tree.depth()).isEqualTo(expected.depth());
    }

    /** What shares a site with a polygon of many corners keeps its fine cells. */
    @Test
    void sliversCostNothingElsewhere() {
        TriangleMesh ball = Meshes.icosphere(3);
        TriangleMesh mesh = besideAFan(ball, 1000);
        KDTree limited = KDTree.of(mesh);
        KDTree unlimited = new KDTreeBuilder(mesh, SahCost.DEFAULT, NO_LIMIT).build();

        assertThat(limited.leafTriangles().length).isLessThan(unlimited.leafTriangles().length);
        assertThat(references(limited, ball.triangleCount()))
                .isEqualTo(references(unlimited, ball.triangleCount()))
                .isGreaterThan(2 * ball.triangleCount());
    }

    /** How many references the first triangles of a mesh have. */
    private static int references(KDTree tree, int first) {
        int[] numbers = tree.triangles().numbers();
        return (int) Arrays.stream(tree.leafTriangles())
                .filter(place -> numbers[place] < first)
                .count();
    }

    /** A mesh, and a fan 20 m beside it. */
    private static TriangleMesh besideAFan(TriangleMesh mesh, int polygonCorners) {
        TriangleMesh fan = NastyMeshes.fan(polygonCorners);
        int own = 9 * mesh.triangleCount();
        float[] corners = new float[own + 9 * fan.triangleCount()];
        for (int i = 0; i < corners.length; i++) {
            int k = i < own ? i : i - own;
            float coordinate = (i < own ? mesh : fan).coordinate(k / 9, k / 3 % 3, k % 3);
            corners[i] = i < own || k % 3 > 0 ? coordinate : coordinate + 20;
        }
        return TriangleMesh.of(corners, IntStream.range(0, corners.length / 3).toArray());
    }
}
