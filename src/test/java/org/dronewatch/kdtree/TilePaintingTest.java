package org.dronewatch.kdtree;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.SplittableRandom;
import org.dronewatch.geometry.TriangleMesh;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * All ways to paint tiles show the same, bit for bit, whatever the size of triangles and tiles. Vectors name the same
 * triangle, too, where several are equally near, as lines do that paint in the same order.
 */
class TilePaintingTest {
    private static final long SEED = 260;
    private static final int WIDTH = 160;

    private final SplittableRandom random = new SplittableRandom(SEED);

    @BeforeEach
    void needVectors() {
        assumeTrue(Vectors.areAvailable(), "no vectors of 256 bits, or the module of vectors is not named");
    }

    @Test
    void byTheNumberOfTriangles() {
        assertThat(TilePainting.of(0)).isEqualTo(TilePainting.FEW);
        assertThat(TilePainting.of(499_999)).isEqualTo(TilePainting.FEW);
        assertThat(TilePainting.of(500_000)).isEqualTo(TilePainting.MANY_BY_VECTORS);
    }

    @Test
    void allPixelsAreTheSame() {
        Map<String, TriangleMesh> meshes = new LinkedHashMap<>(Meshes.degenerate());
        for (String model : new String[] {"hill.obj", "house.obj", "cathedral.obj", "quadrotor.obj"}) {
            meshes.put(model, Meshes.model(model));
        }
        meshes.put("room", Meshes.room());
        meshes.put("ball", Meshes.icosphere(3));
        meshes.put("small triangles", Meshes.soup(2000, 0.05, 261));
        meshes.put("large triangles", Meshes.soup(300, 0.9, 262));
        int hits = 0;
        for (Map.Entry<String, TriangleMesh> entry : meshes.entrySet()) {
            hits += compare(entry.getKey(), entry.getValue());
        }
        assertThat(hits).as("pixels that see something").isGreaterThan(300_000);
    }

    /** Edges through the centres of pixels, exactly: there sums are zero, some of them with a minus. */
    @Test
    void edgesThroughCentres() {
        float[] corners = new float[9 * 2 * 64];
        int at = 0;
        for (int cell = 0; cell < 64; cell++) {
            float x = cell % 8;
            float y = cell / 8;
            for (float[] corner : new float[][] {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}) {
                corners[at++] = x + corner[0] - 4;
                corners[at++] = y + corner[1] - 4;
                corners[at++] = 8;
            }
        }
        int[] numbers = new int[corners.length / 3];
        Arrays.setAll(numbers, i -> i);
        KDTree tree = KDTree.of(TriangleMesh.of(corners, numbers));
        double[] eye = new double[3];
        int hits = 0;
        for (int i = 0; i < 200; i++) {
            double signX = random.nextBoolean() ? 0.125 : -0.125;
            double signY = random.nextBoolean() ? 0.125 : -0.125;
            double[] corner = {-signX * random.nextInt(6), -signY * random.nextInt(6), 1};
            boolean turned = random.nextBoolean();
            double[] right = {turned ? 0 : signX, turned ? signX : 0, 0};
            double[] down = {turned ? signY : 0, turned ? 0 : signY, 0};
            PinholeView view = new PinholeView(eye, corner, right, down);
            hits += compare("grid", tree, view, 12);
        }
        assertThat(hits).as("pixels that see the grid").isGreaterThan(5_000);
    }

    /**
     * A plane of small triangles at the height of a level camera that looks along it, somewhat to the side: all are seen
     * edge-on in the row of the horizon, where their edge functions and distances are roundings, which need not lie in the
     * triangle's cell: so what is seen depends on the cells that are asked, and only one order is compared.
     */
    @Test
    void trianglesInThePlaneOfTheEye() {
        int cells = 60;
        float[] corners = new float[18 * cells * cells];
        int at = 0;
        for (int cell = 0; cell < cells * cells; cell++) {
            for (int[] corner : new int[][] {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}) {
                corners[at++] = 0.7f * (cell % cells + corner[0]);
                corners[at++] = 0.7f * (cell / cells + corner[1]);
                corners[at++] = 3.3f;
            }
        }
        int[] numbers = new int[corners.length / 3];
        Arrays.setAll(numbers, i -> i);
        KDTree tree = KDTree.of(TriangleMesh.of(corners, numbers));
        int hits = 0;
        for (int i = 0; i < 200; i++) {
            double azimuth = 2.0 * Math.PI * random.nextDouble();
            double step = 0.002 + 0.002 * random.nextDouble();
            double[] ahead = {Math.sin(azimuth), Math.cos(azimuth), 0};
            double[] right = {step * Math.cos(azimuth), -step * Math.sin(azimuth), 0};
            double[] down = {0, 0, -step};
            double[] corner = new double[3];
            int horizon = random.nextInt(10);
            for (int k = 0; k < 3; k++) {
                corner[k] = ahead[k] - 80 * right[k] - horizon * down[k];
            }
            double[] eye = {20 - 30 * ahead[0], 20 - 30 * ahead[1], 3.3f};
            hits += compare("plane", tree, new PinholeView(eye, corner, right, down), WIDTH, TilePainting.MANY);
        }
        assertThat(hits).as("pixels of the horizon").isGreaterThan(1_000);
    }

    private int compare(String name, TriangleMesh mesh) {
        KDTree tree = KDTree.of(mesh);
        int hits = 0;
        for (int i = 0; i < 12; i++) {
            hits += compare(name, tree, PinholeView.random(mesh, random, i, WIDTH), WIDTH);
        }
        return hits;
    }

    private int compare(String name, KDTree tree, PinholeView view, int width) {
        return compare(name, tree, view, width, TilePainting.FEW);
    }

    private int compare(String name, KDTree tree, PinholeView view, int width, TilePainting reference) {
        int across = random.nextInt(1, Math.min(width, TileTraversal.WIDTH) + 1);
        int down = random.nextInt(1, TileTraversal.HEIGHT + 1);
        TileTraversal expected = painting(tree, view, reference);
        TileTraversal many = painting(tree, view, TilePainting.MANY);
        TileTraversal byVectors = painting(tree, view, TilePainting.MANY_BY_VECTORS);
        int hits = 0;
        for (int left = 0; left < width; left += across) {
            expected.trace(left, 0, across, down);
            many.trace(left, 0, across, down);
            byVectors.trace(left, 0, across, down);
            for (int pixel = 0; pixel < across * down; pixel++) {
                int column = pixel % across;
                int row = pixel / across;
                boolean hit = expected.hits(column, row);
                double parameter = expected.parameter(column, row);
                assertThat(many.hits(column, row) == hit && many.parameter(column, row) == parameter)
                        .as(
                                "several leaves at a time: %s, seed %d, tile of %d x %d, column %d, row %d",
                                name, SEED, across, down, column, row)
                        .isTrue();
                assertThat(byVectors.hits(column, row) == hit
                                && byVectors.parameter(column, row) == parameter
                                && (!hit || byVectors.triangle(column, row) == many.triangle(column, row)))
                        .as(
                                "by vectors: %s, seed %d, tile of %d x %d, column %d, row %d",
                                name, SEED, across, down, column, row)
                        .isTrue();
                hits += hit ? 1 : 0;
            }
        }
        return hits;
    }

    private static TileTraversal painting(KDTree tree, PinholeView view, TilePainting painting) {
        TileTraversal tiles = new TileTraversal(tree, painting);
        tiles.setPicture(view.from, view.corner, view.right, view.down);
        return tiles;
    }
}
