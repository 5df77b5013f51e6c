package org.dronewatch.raster;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.Meshes;
import org.dronewatch.parallel.VectorInstructions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * All ways to paint tiles show the same, whatever the size of triangles and tiles: vectors bit for bit what lines do
 * that paint in the same order; leaves one by one or several at a time all but the last bits, which single rays round
 * differently where a tile is given up.
 */
class RasterModeTest {
    private static final long SEED = 260;
    private static final int WIDTH = 160;

    private final SplittableRandom random = new SplittableRandom(SEED);

    @BeforeEach
    void needVectors() {
        assumeTrue(VectorInstructions.areAvailable(), "no vectors of 256 bits, or the module of vectors is not named");
    }

    @Test
    void byTheNumberOfTriangles() {
        assertThat(RasterMode.of(0)).isEqualTo(RasterMode.FEW);
        assertThat(RasterMode.of(499_999)).isEqualTo(RasterMode.FEW);
        assertThat(RasterMode.of(500_000)).isEqualTo(RasterMode.MANY);
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
        KDTree tree = squares(8, 1f, -4f, 8f);
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
     * A plane of small triangles at the height of a level camera that looks along it, somewhat to the side: all are
     * seen edge-on in the row of the horizon, where their edge functions and distances are roundings, which need not
     * lie in the triangle's cell: so what is seen depends on the cells that are asked, and only one order is compared.
     */
    @Test
    void trianglesInThePlaneOfTheEye() {
        KDTree tree = squares(60, 0.7f, 0f, 3.3f);
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
            hits += compare("plane", tree, new PinholeView(eye, corner, right, down), WIDTH, RasterMode.MANY);
        }
        assertThat(hits).as("pixels of the horizon").isGreaterThan(1_000);
    }

    /** The largest tiles, all of whose pixels see something: vectors reach beyond the last one. */
    @Test
    void wholeTiles() {
        for (TriangleMesh mesh : new TriangleMesh[] {Meshes.room(), Meshes.icosphere(5)}) {
            double[] corner = {-0.64, -0.32, 1};
            PinholeView view = new PinholeView(
                    new double[] {0.1, 0.2, 0.3}, corner, new double[] {0.01, 0, 0}, new double[] {0, 0.01, 0});
            int hits = compare(
                    "whole tile", KDTree.of(mesh), view, 0, TileTracer.WIDTH, TileTracer.HEIGHT, RasterMode.FEW);
            assertThat(hits).isEqualTo(TileTracer.WIDTH * TileTracer.HEIGHT);
        }
    }

    /** From a corner of triangles their other corners are seen, and nothing of themselves. */
    @Test
    void fromCorners() {
        int hits = 0;
        for (TriangleMesh mesh : new TriangleMesh[] {Meshes.icosphere(3), Meshes.soup(500, 0.3, 263), Meshes.room()}) {
            KDTree tree = KDTree.of(mesh);
            for (int i = 0; i < 30; i++) {
                PinholeView view = PinholeView.random(mesh, random, i, WIDTH);
                int triangle = random.nextInt(mesh.triangleCount());
                for (int k = 0; k < 3; k++) {
                    view.from[k] = mesh.coordinate(triangle, i % 3, k);
                }
                hits += compare("from a corner", tree, view, WIDTH, RasterMode.MANY);
            }
        }
        assertThat(hits).isGreaterThan(50_000);
    }

    /** As many triangles at a time as can be, all of them seen. */
    @Test
    void asManyAsCanBe() {
        KDTree tree = squares(8, 1f, -4f, 8f);
        assertThat(tree.triangles().count()).isEqualTo(TriangleSetup.MOST);
        for (RasterMode mode : RasterMode.values()) {
            PixelGrid grid = new PixelGrid();
            grid.set(new double[3], new double[] {-0.64, -0.64, 1}, new double[] {0.01, 0, 0}, new double[] {0, 0.02, 0
            });
            TileBuffer pixels = new TileBuffer(grid, TileTracer.WIDTH, TileTracer.HEIGHT);
            pixels.begin(0, 0, TileTracer.WIDTH, TileTracer.HEIGHT);
            TriangleSetup setup = mode.setup(tree.triangles(), grid, pixels);
            setup.begin();
            setup.rasterise(IntStream.range(0, TriangleSetup.MOST).toArray(), TriangleSetup.MOST);
            Set<Integer> seen = new HashSet<>();
            for (int pixel = 0; pixel < TileTracer.WIDTH * TileTracer.HEIGHT; pixel++) {
                int column = pixel % TileTracer.WIDTH;
                int row = pixel / TileTracer.WIDTH;
                if (pixels.hits(column, row)) {
                    seen.add(pixels.triangle(column, row));
                }
            }
            assertThat(seen).as("%s", mode).hasSize(TriangleSetup.MOST);
        }
    }

    /** Once tracers that share a warm-up have drawn enough pixels, vectors take over, and nothing changes. */
    @Test
    void vectorsTakeOver() {
        KDTree tree = KDTree.of(Meshes.model("hill.obj"));
        PinholeView view = PinholeView.random(Meshes.model("hill.obj"), random, 1, WIDTH);
        TileTracer lines = painting(tree, view, RasterMode.MANY);
        lines.trace(0, 0, TileTracer.WIDTH, TileTracer.HEIGHT);
        RasterWarmup warmup = new RasterWarmup();
        TileTracer tiles = painting(tree, view, RasterMode.MANY, warmup);
        long pixels = 0;
        int size = TileTracer.WIDTH * TileTracer.HEIGHT;
        while (pixels <= RasterWarmup.PIXELS + size) {
            assertThat(warmup.isOver()).isEqualTo(pixels > RasterWarmup.PIXELS);
            assertThat(tiles.mode() == RasterMode.MANY_BY_VECTORS)
                    .as("by vectors after %d pixels", pixels)
                    .isEqualTo(pixels > RasterWarmup.PIXELS);
            tiles.trace(0, 0, TileTracer.WIDTH, TileTracer.HEIGHT);
            pixels += size;
        }
        assertSame(lines, tiles, TileTracer.WIDTH, TileTracer.HEIGHT);
        TileTracer another = painting(tree, view, RasterMode.MANY, warmup);
        another.trace(0, 0, 1, 1);
        assertThat(another.mode()).isEqualTo(RasterMode.MANY_BY_VECTORS);
    }

    /** A painter has nothing left of the picture before, nor of a triangle that it could not paint. */
    @Test
    void onePictureAfterAnother() {
        TriangleMesh mesh = Meshes.model("hill.obj");
        KDTree tree = KDTree.of(mesh);
        TileTracer tiles = painting(tree, PinholeView.random(mesh, random, 1, WIDTH), RasterMode.MANY_BY_VECTORS);
        int hits = 0;
        for (int i = 0; i < 20; i++) {
            PinholeView view = PinholeView.random(mesh, random, i, WIDTH);
            TileTracer fresh = painting(tree, view, RasterMode.MANY_BY_VECTORS);
            tiles.setPicture(view.from, view.corner, view.right, view.down);
            tiles.trace(0, 0, TileTracer.WIDTH, TileTracer.HEIGHT);
            fresh.trace(0, 0, TileTracer.WIDTH, TileTracer.HEIGHT);
            hits += assertSame(fresh, tiles, TileTracer.WIDTH, TileTracer.HEIGHT);
        }
        assertThat(hits).isGreaterThan(20_000);
    }

    private static int assertSame(TileTracer expected, TileTracer tiles, int columns, int rows) {
        int hits = 0;
        for (int pixel = 0; pixel < columns * rows; pixel++) {
            int column = pixel % columns;
            int row = pixel / columns;
            assertThat(tiles.parameter(column, row)).isEqualTo(expected.parameter(column, row));
            hits += tiles.hits(column, row) ? 1 : 0;
        }
        return hits;
    }

    /** A level plane of squares, two triangles each, from a corner on. */
    private static KDTree squares(int along, float size, float from, float height) {
        float[] corners = new float[18 * along * along];
        int at = 0;
        for (int square = 0; square < along * along; square++) {
            for (int[] corner : new int[][] {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}) {
                corners[at++] = from + size * (square % along + corner[0]);
                corners[at++] = from + size * (square / along + corner[1]);
                corners[at++] = height;
            }
        }
        return KDTree.of(
                TriangleMesh.of(corners, IntStream.range(0, corners.length / 3).toArray()));
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
        return compare(name, tree, view, width, RasterMode.FEW);
    }

    private int compare(String name, KDTree tree, PinholeView view, int width, RasterMode reference) {
        int across = random.nextInt(1, Math.min(width, TileTracer.WIDTH) + 1);
        int down = random.nextInt(1, TileTracer.HEIGHT + 1);
        int hits = 0;
        for (int left = 0; left < width; left += across) {
            hits += compare(name, tree, view, left, across, down, reference);
        }
        return hits;
    }

    private int compare(
            String name, KDTree tree, PinholeView view, int left, int across, int down, RasterMode reference) {
        TileTracer expected = painting(tree, view, reference);
        TileTracer many = painting(tree, view, RasterMode.MANY);
        TileTracer byVectors = painting(tree, view, RasterMode.MANY_BY_VECTORS);
        int hits = 0;
        expected.trace(left, 0, across, down);
        many.trace(left, 0, across, down);
        byVectors.trace(left, 0, across, down);
        for (int pixel = 0; pixel < across * down; pixel++) {
            int column = pixel % across;
            int row = pixel / across;
            boolean hit = expected.hits(column, row);
            double parameter = expected.parameter(column, row);
            assertThat(many.hits(column, row) == hit
                            && (!hit || Math.abs(many.parameter(column, row) - parameter) <= 1e-13 * parameter))
                    .as(
                            "several leaves at a time: %s, seed %d, tile of %d x %d, column %d, row %d",
                            name, SEED, across, down, column, row)
                    .isTrue();
            assertThat(byVectors.hits(column, row) == hit
                            && byVectors.parameter(column, row) == many.parameter(column, row)
                            && (!hit || byVectors.triangle(column, row) == many.triangle(column, row)))
                    .as(
                            "by vectors: %s, seed %d, tile of %d x %d, column %d, row %d",
                            name, SEED, across, down, column, row)
                    .isTrue();
            hits += hit ? 1 : 0;
        }
        return hits;
    }

    private static TileTracer painting(KDTree tree, PinholeView view, RasterMode mode) {
        return painting(tree, view, mode, new RasterWarmup());
    }

    private static TileTracer painting(KDTree tree, PinholeView view, RasterMode mode, RasterWarmup warmup) {
        TileTracer tiles = new TileTracer(tree, mode, warmup);
        tiles.setPicture(view.from, view.corner, view.right, view.down);
        return tiles;
    }
}
