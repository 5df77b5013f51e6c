package org.dronewatch.raster;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.util.SplittableRandom;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.Meshes;
import org.dronewatch.parallel.VectorInstructions;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What a descent meets, and when it gives a tile up. What it shows is compared in {@link RasterModeTest}. */
class TileDescentTest {
    private static final long SEED = 271;

    private final PixelGrid grid = new PixelGrid();
    private final TileBuffer pixels = new TileBuffer(grid, TileTracer.WIDTH, TileTracer.HEIGHT);

    /** Each of these triangles lies in many leaves. */
    @ParameterizedTest
    @EnumSource(RasterMode.class)
    void meetsATriangleOnce(RasterMode mode) {
        TriangleMesh mesh = Meshes.soup(600, 0.5, 262);
        KDTree tree = KDTree.of(mesh);
        assertThat(tree.leafTriangles().length).as("entries of leaves").isGreaterThan(10 * mesh.triangleCount());
        LeafRasteriser leaves = leaves(tree, mode);
        TileDescent descent = new TileDescent(tree, grid, pixels, leaves, mode.nodesAtOnce());
        SplittableRandom random = new SplittableRandom(SEED);
        for (int i = 0; i < 20; i++) {
            begin(PinholeView.random(mesh, random, i, TileTracer.WIDTH));
            assertThat(descent.rasterise(Integer.MAX_VALUE)).isTrue();
            assertThat(leaves.met()).as("view %d, seed %d", i, SEED).isLessThanOrEqualTo(mesh.triangleCount());
        }
    }

    @ParameterizedTest
    @EnumSource(RasterMode.class)
    void givesUpWhereMoreTrianglesThanTheLimitAreMet(RasterMode mode) {
        TriangleMesh mesh = Meshes.icosphere(4);
        KDTree tree = KDTree.of(mesh);
        LeafRasteriser leaves = leaves(tree, mode);
        TileDescent descent = new TileDescent(tree, grid, pixels, leaves, mode.nodesAtOnce());
        SplittableRandom random = new SplittableRandom(SEED);
        int views = 0;
        for (int i = 0; i < 20; i++) {
            PinholeView view = PinholeView.random(mesh, random, i, TileTracer.WIDTH);
            begin(view);
            assertThat(descent.rasterise(Integer.MAX_VALUE)).isTrue();
            int met = leaves.met();
            if (met > 0) {
                begin(view);
                assertThat(descent.rasterise(met))
                        .as("view %d, seed %d", i, SEED)
                        .isTrue();
                begin(view);
                assertThat(descent.rasterise(met - 1))
                        .as("view %d, seed %d", i, SEED)
                        .isFalse();
                views++;
            }
        }
        assertThat(views).as("views that meet triangles").isGreaterThan(10);
    }

    /** A triangle in whose plane and box the origin lies, and then, elsewhere, the next tile. */
    @ParameterizedTest
    @EnumSource(RasterMode.class)
    void givesUpWhereTheOriginLiesInATriangle(RasterMode mode) {
        KDTree tree = KDTree.of(TriangleMesh.of(new float[] {0, 0, 1, 4, 0, 1, 0, 4, 1}, new int[] {0, 1, 2}));
        TileDescent descent = new TileDescent(tree, grid, pixels, leaves(tree, mode), mode.nodesAtOnce());
        double[] right = {0.01, 0, 0};
        double[] down = {0, 0, -0.01};
        begin(new PinholeView(new double[] {1, 1, 1}, new double[] {-0.64, 1, 0.32}, right, down));
        assertThat(descent.rasterise(1)).as("from within the triangle").isFalse();
        begin(new PinholeView(new double[] {1, 1, 1.1}, new double[] {-0.64, 1, 0.32}, right, down));
        assertThat(descent.rasterise(1)).as("from above it").isTrue();
    }

    private LeafRasteriser leaves(KDTree tree, RasterMode mode) {
        assumeTrue(mode != RasterMode.MANY_BY_VECTORS || VectorInstructions.areAvailable(), "no vectors");
        return new LeafRasteriser(tree.leafTriangles(), mode.setup(tree.triangles(), grid, pixels));
    }

    private void begin(PinholeView view) {
        grid.set(view.from, view.corner, view.right, view.down);
        pixels.begin(0, 0, TileTracer.WIDTH, TileTracer.HEIGHT);
    }
}
