package org.dronewatch.raster;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.BruteForce;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.KDTreeStats;
import org.dronewatch.kdtree.Meshes;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.kdtree.Rays;
import org.dronewatch.kdtree.StackTraversal;
import org.jogamp.vecmath.Vector3d;
import org.junit.jupiter.api.Test;

/** Pictures by tiles against pictures by single rays: pixel by pixel the same. */
class TileTracerTest {
    private static final double SAME = 1e-5;
    private static final double EDGE = 1e-6;

    @Test
    void theHill() {
        compare("hill", Meshes.model("hill.obj"), 25, 96, 201);
    }

    @Test
    void theHouse() {
        compare("house", Meshes.model("house.obj"), 25, 96, 202);
    }

    @Test
    void theQuadrotor() {
        compare("quadrotor", Meshes.model("quadrotor.obj"), 25, 96, 203);
    }

    /** From inside, where walls are parallel to the axes and eyes lie in the planes of faces. */
    @Test
    void aRoom() {
        compare("room", Meshes.room(), 60, 80, 204);
    }

    @Test
    void randomTriangles() {
        compare("small triangles", Meshes.soup(2000, 0.05, 205), 25, 80, 206);
        compare("large triangles", Meshes.soup(300, 0.9, 207), 25, 80, 208);
    }

    @Test
    void degenerateMeshes() {
        for (Map.Entry<String, TriangleMesh> entry : Meshes.degenerate().entrySet()) {
            compare(entry.getKey(), entry.getValue(), 10, 40, 209);
        }
    }

    /** A closed ball seen from inside has no gaps: edges and corners belong to some triangle, whatever the tile. */
    @Test
    void aClosedBallHoldsWater() {
        KDTree ball = KDTree.of(Meshes.icosphere(3));
        SplittableRandom random = new SplittableRandom(210);
        TileTracer tiles = new TileTracer(ball);
        for (int i = 0; i < 200; i++) {
            PinholeView view = PinholeView.random(ball.mesh(), random, i, 64);
            view.from[0] = 0.5 * random.nextDouble();
            view.from[1] = 0.5 * random.nextDouble();
            view.from[2] = 0.5 * random.nextDouble();
            tiles.setPicture(view.from, view.corner, view.right, view.down);
            for (int top = 0; top < 64; top += TileTracer.HEIGHT) {
                tiles.trace(0, top, TileTracer.WIDTH, TileTracer.HEIGHT);
                for (int pixel = 0; pixel < TileTracer.WIDTH * TileTracer.HEIGHT; pixel++) {
                    assertThat(tiles.hits(pixel % TileTracer.WIDTH, pixel / TileTracer.WIDTH))
                            .as("seed 210, view %d, pixel %d", i, pixel)
                            .isTrue();
                }
            }
        }
    }

    /** Rays aimed at the ball's vertices, where up to six triangles meet. */
    @Test
    void cornersHoldWater() {
        TriangleMesh mesh = Meshes.icosphere(2);
        TileTracer tiles = new TileTracer(KDTree.of(mesh));
        double[] eye = {0.125, -0.25, 0.0625};
        for (int triangle = 0; triangle < mesh.triangleCount(); triangle++) {
            double[] at = new double[3];
            for (int axis = 0; axis < 3; axis++) {
                at[axis] = mesh.coordinate(triangle, 0, axis) - eye[axis];
            }
            Vector3d right = new Vector3d();
            right.cross(new Vector3d(at), new Vector3d(0.3, 0.5, 0.7));
            Vector3d down = new Vector3d();
            down.cross(new Vector3d(at), right);
            double[] u = {0.01 * right.x, 0.01 * right.y, 0.01 * right.z};
            double[] v = {0.01 * down.x, 0.01 * down.y, 0.01 * down.z};
            tiles.setPicture(eye, at, u, v);
            tiles.trace(-3, -2, 7, 5);
            assertThat(tiles.hits(3, 2)).as("vertex of triangle %d", triangle).isTrue();
        }
    }

    /** The sliver begins in the plane of the eye: its nearest corners lie billions of rows above the tile. */
    @Test
    void aSliverFarAboveTheTileIsLeftOut() {
        float[] corners = {
            2.0154733e-8f,
            8.877762e-11f,
            2.4915876f,
            1.2525413e-8f,
            0f,
            2.669174f,
            6.81866e-9f,
            -1.6378561e-12f,
            2.837284f,
            0f,
            -0.02f,
            2.4f,
            0.03f,
            0.01f,
            2.9f,
            5f,
            0.3f,
            -3f
        };
        TriangleMesh mesh =
                new TriangleMesh(corners, new int[] {0, 1, 2, 3, 4, 5}, new int[2], new int[] {0, 1}, List.of("wall"));
        TileTracer tiles = new TileTracer(KDTree.of(mesh));
        tiles.setPicture(
                new double[3], new double[] {1, -0.032, 0.032}, new double[] {0, 0.001, 0}, new double[] {0, 0, -0.001
                });
        assertTimeoutPreemptively(Duration.ofMinutes(1), () -> tiles.trace(0, 0, 57, 37));
        for (int pixel = 0; pixel < 57 * 37; pixel++) {
            assertThat(tiles.hits(pixel % 57, pixel / 57) && tiles.triangle(pixel % 57, pixel / 57) == 0)
                    .as("pixel %d", pixel)
                    .isFalse();
        }
    }

    /**
     * Two ulps of a float from the centres of columns 3 and 5, or rows: too near for the interval of a line, so signs
     * decide. A tile of 9 x 9 pixels is painted in rows, one of 9 x 12 in columns.
     */
    @Test
    void edgesThatPassCentresCloselyLeaveThemOut() {
        float right = Math.nextUp(Math.nextUp(3f));
        float left = Math.nextDown(5f);
        float[] wide = {right, -99, 1, 99, 4, 1, right, 99, 1, left, -99, 2, left, 99, 2, -99, 4, 2};
        float[] high = wide.clone();
        for (int corner = 0; corner < 6; corner++) {
            high[3 * corner] = wide[3 * corner + 1];
            high[3 * corner + 1] = wide[3 * corner];
        }
        for (int rows = 9; rows <= 12; rows += 3) {
            edgesLeaveCentresOut(wide, false, rows);
            edgesLeaveCentresOut(high, true, rows);
        }
    }

    private static void edgesLeaveCentresOut(float[] corners, boolean level, int rows) {
        TriangleMesh mesh = TriangleMesh.of(corners, new int[] {0, 1, 2, 3, 4, 5});
        // The second triangle lies at twice the distance: seen from the origin its edge is at half the column.
        for (int triangle = 0; triangle < 2; triangle++) {
            double step = triangle == 0 ? 1.0 : 0.5;
            TileTracer tiles = new TileTracer(KDTree.of(only(mesh, triangle)));
            tiles.setPicture(
                    new double[3], new double[] {0, 0, 1}, new double[] {step, 0, 0}, new double[] {0, step, 0});
            tiles.trace(0, 0, 9, rows);
            for (int row = 0; row < rows; row++) {
                for (int column = 0; column < 9; column++) {
                    int across = level ? row : column;
                    assertThat(tiles.hits(column, row))
                            .as("triangle %d, column %d, row %d of %d", triangle, column, row, rows)
                            .isEqualTo(triangle == 0 ? across > 3 : across < 5);
                }
            }
        }
    }

    /**
     * A floor that all pixels see, as far as 100, met first in a cell near by; and posts in a cell far away, at 99.5,
     * before what the farthest pixels see.
     */
    @Test
    void whatStandsJustBeforeTheFarthestPixelIsSeen() {
        List<Float> corners = new ArrayList<>(List.of(-1f, -300f, 0f, 400f, 0f, 0f, -1f, 300f, 0f));
        for (int i = 0; i < 60; i++) {
            float side = i / 30f - 1f;
            // Beside the picture, below the eye; and in it.
            corners.addAll(List.of(1f, side, -2f, 1f, side + 0.02f, -2f, 1.1f, side, -1.9f));
            corners.addAll(List.of(99.4f, side, -0.3f, 99.4f, side + 0.06f, -0.3f, 99.6f, side, 0.31f));
        }
        float[] all = new float[corners.size()];
        int[] numbers = new int[all.length / 3];
        for (int i = 0; i < all.length; i++) {
            all[i] = corners.get(i);
            numbers[i / 3] = i / 3;
        }
        KDTree tree = KDTree.of(TriangleMesh.of(all, numbers));
        assertThat(KDTreeStats.of(tree).nodes()).isGreaterThan(20);
        TileTracer tiles = new TileTracer(tree);
        tiles.setPicture(
                new double[] {0, 0, 1}, new double[] {1, -0.004, -0.01}, new double[] {0, 0.001, 0}, new double[] {
                    0, 0, -0.001
                });
        tiles.trace(0, 0, 9, 9);
        for (int row = 0; row < 9; row++) {
            assertThat(tiles.parameter(4, row))
                    .as("row %d", row)
                    .isCloseTo(row == 0 ? 99.5 : 1.0 / (0.01 + 0.001 * row), within(1e-4));
        }
    }

    private static TriangleMesh only(TriangleMesh mesh, int triangle) {
        float[] corners = new float[9];
        for (int i = 0; i < 9; i++) {
            corners[i] = mesh.coordinate(triangle, i / 3, i % 3);
        }
        return TriangleMesh.of(corners, new int[] {0, 1, 2});
    }

    /**
     * Parameters times lengths of directions; infinity for the sky, even where directions are too short to have a
     * length.
     */
    @Test
    void distancesAreThoseAlongTheRays() {
        SplittableRandom random = new SplittableRandom(214);
        TriangleMesh mesh = Meshes.soup(200, 0.3, 215);
        TileTracer tiles = new TileTracer(KDTree.of(mesh));
        int sky = 0;
        for (int i = 0; i < 20; i++) {
            PinholeView view = PinholeView.random(mesh, random, i, 100);
            int columns = 1 + random.nextInt(TileTracer.WIDTH);
            int rows = 1 + random.nextInt(TileTracer.HEIGHT);
            tiles.setPicture(view.from, view.corner, view.right, view.down);
            tiles.trace(7, 3, columns, rows);
            int rowLength = TileTracer.WIDTH + 6;
            float[] distances = new float[5 + rowLength * rows];
            tiles.copyDistances(distances, 5, rowLength);
            for (int row = 0; row < rows; row++) {
                for (int column = 0; column < columns; column++) {
                    double[] ray = view.ray(7 + column, 3 + row);
                    double length = Math.sqrt(ray[3] * ray[3] + ray[4] * ray[4] + ray[5] * ray[5]);
                    double expected = tiles.hits(column, row) ? length * tiles.parameter(column, row) : 1.0 / 0.0;
                    sky += tiles.hits(column, row) ? 0 : 1;
                    assertThat((double) distances[5 + rowLength * row + column])
                            .as("seed 214, view %d, column %d, row %d", i, column, row)
                            .isBetween(expected * (1.0 - 1e-7), expected * (1.0 + 1e-7));
                }
            }
        }
        assertThat(sky).as("pixels of the sky").isGreaterThan(1000);

        tiles.setPicture(
                new double[] {9, 9, 9}, new double[] {1e-170, 0, 0}, new double[] {0, 1, 0}, new double[] {0, 0, 1});
        tiles.trace(0, 0, 2, 2);
        float[] distances = new float[4];
        tiles.copyDistances(distances, 0, 2);
        assertThat(distances).containsOnly(Float.POSITIVE_INFINITY);
    }

    @Test
    void aPictureWithoutAnAreaIsRefused() {
        TileTracer tiles = new TileTracer(KDTree.of(Meshes.icosphere(0)));
        double[] from = {0, 0, 0};
        double[] step = {1, 0, 0};
        assertThatThrownBy(() -> tiles.setPicture(from, step, step, new double[] {0, 1, 0}))
                .isInstanceOf(IllegalArgumentException.class);
    }

    /** Compares whole pictures, cut into tiles of any size, whose borders cut tiles again. */
    private static void compare(String name, TriangleMesh mesh, int views, int width, long seed) {
        KDTree tree = KDTree.of(mesh);
        TileTracer tiles = new TileTracer(tree);
        RayTracer single = new StackTraversal(tree);
        BruteForce exact = new BruteForce(mesh);
        double size = mesh.triangleCount() == 0 ? 0.0 : mesh.bounds().diagonal();
        SplittableRandom random = new SplittableRandom(seed);
        List<String> excused = new ArrayList<>();
        List<String> wrong = new ArrayList<>();
        int pixels = 0;
        int hits = 0;
        for (int i = 0; i < views; i++) {
            PinholeView view = PinholeView.random(mesh, random, i, width);
            int height = 3 * width / 4;
            tiles.setPicture(view.from, view.corner, view.right, view.down);
            int across = random.nextInt(16, TileTracer.WIDTH + 1);
            int down = random.nextInt(16, TileTracer.HEIGHT + 1);
            for (int top = 0; top < height; top += down) {
                for (int left = 0; left < width; left += across) {
                    int columns = Math.min(across, width - left);
                    int rows = Math.min(down, height - top);
                    boolean singly = random.nextInt(4) == 0;
                    if (singly) {
                        tiles.traceSingly(left, top, columns, rows);
                    } else {
                        tiles.trace(left, top, columns, rows);
                    }
                    for (int pixel = 0; pixel < columns * rows; pixel++) {
                        int column = pixel % columns;
                        int row = pixel / columns;
                        double[] ray = view.ray(left + column, top + row);
                        boolean found = Rays.closestHit(single, ray);
                        boolean same = tiles.hits(column, row) == found
                                && (!found
                                        || Math.abs(tiles.parameter(column, row) - single.distance())
                                                <= SAME * single.distance());
                        pixels++;
                        hits += found ? 1 : 0;
                        if (!same) {
                            boolean onEdge = found && exact.edgeDistance(ray, single.triangle()) <= EDGE * size
                                    || tiles.hits(column, row)
                                            && exact.edgeDistance(ray, tiles.triangle(column, row)) <= EDGE * size;
                            (onEdge ? excused : wrong)
                                    .add(Arrays.toString(ray) + ": "
                                            + (found ? single.triangle() + " at " + single.distance() : "nothing")
                                            + ", tile: "
                                            + (tiles.hits(column, row)
                                                    ? tiles.triangle(column, row) + " at "
                                                            + tiles.parameter(column, row)
                                                    : "nothing"));
                        }
                    }
                }
            }
        }
        assertThat(wrong)
                .as(
                        "%s: wrong of %d pixels, %d of which hit, seed %d; %d excused on edges: %s",
                        name, pixels, hits, seed, excused.size(), excused)
                .isEmpty();
        assertThat(excused)
                .as("%s: excused of %d pixels, seed %d", name, pixels, seed)
                .hasSizeLessThanOrEqualTo(name.equals("slivers") ? pixels / 100 : pixels / 10_000);
    }
}
