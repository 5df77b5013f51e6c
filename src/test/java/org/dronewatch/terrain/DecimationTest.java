package org.dronewatch.terrain;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import org.dronewatch.geo.CoordinateReferenceSystem;
import org.dronewatch.geo.MapTransform;
import org.dronewatch.geo.Origin;
import org.dronewatch.parallel.LongTask;
import org.dronewatch.setting.InputException;
import org.dronewatch.terrain.io.Lattice;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Every dropped post is measured by brute force, against every triangle that holds it. */
class DecimationTest {
    private static final MapTransform MAP = new MapTransform(
            CoordinateReferenceSystem.of("EPSG:32633"),
            Origin.at(Math.toRadians(50.08), Math.toRadians(14.42)).withHeight(0.0));

    private static Posts posts(int columns, int rows, float... heights) {
        Lattice lattice = new Lattice(458_000, 5_548_000, 10, 0, 0, -10);
        return new Grid(lattice, columns, rows, heights).posts(MAP, 0.0);
    }

    /** Hills of several sizes. */
    private static float[] hills(Random random, int columns, int rows) {
        double[] phases = random.doubles(8, 0.0, 6.28).toArray();
        float[] heights = new float[columns * rows];
        for (int i = 0; i < heights.length; i++) {
            double x = i % columns;
            double y = i / columns;
            heights[i] = (float) (200.0
                    + 20.0 * Math.sin(0.11 * x + phases[0]) * Math.cos(0.13 * y + phases[1])
                    + 5.0 * Math.sin(0.4 * x + 0.3 * y + phases[2])
                    + 2.0 * random.nextDouble());
        }
        return heights;
    }

    /** Twice the area, in columns and rows. */
    private static long area(int columns, int a, int b, int c) {
        long ax = a % columns;
        long ay = a / columns;
        return (b % columns - ax) * (c / columns - ay) - (b / columns - ay) * (c % columns - ax);
    }

    private static long wholeArea(PostTriangles triangles, int columns) {
        int[] c = triangles.corners();
        long sum = 0;
        for (int i = 0; i < c.length; i += 3) {
            long area = area(columns, c[i], c[i + 1], c[i + 2]);
            assertThat(area)
                    .as("triangle %d runs the wrong way or has no area", i / 3)
                    .isPositive();
            sum += area;
        }
        return sum;
    }

    /** The greatest vertical distance of a post from the triangles that it lies in, in the world frame. */
    private static double greatestError(Posts posts, PostTriangles triangles) {
        int columns = posts.columns();
        int[] c = triangles.corners();
        PostFrame.Row frame = posts.frame().newRow();
        double worst = 0.0;
        for (int i = 0; i < c.length; i += 3) {
            double[] world = new double[9];
            for (int k = 0; k < 3; k++) {
                frame.to(c[i + k] / columns);
                frame.column(c[i + k] % columns);
                world[3 * k] = (float) frame.east(posts.up(c[i + k]));
                world[3 * k + 1] = (float) frame.north(posts.up(c[i + k]));
                world[3 * k + 2] = posts.up(c[i + k]);
            }
            Plane plane = Plane.through(world);
            for (int post = 0; post < columns * posts.rows(); post++) {
                boolean isInside = area(columns, c[i], c[i + 1], post) >= 0
                        && area(columns, c[i + 1], c[i + 2], post) >= 0
                        && area(columns, c[i + 2], c[i], post) >= 0;
                if (isInside) {
                    assertThat(posts.isHole(post))
                            .as("post %d in a triangle", post)
                            .isFalse();
                    frame.to(post / columns);
                    frame.column(post % columns);
                    double up = posts.up(post);
                    worst = Math.max(worst, Math.abs(up - plane.at(frame.east(up), frame.north(up))));
                }
            }
        }
        return worst;
    }

    @ParameterizedTest
    @CsvSource({"1, 5.0", "2, 2.0", "3, 0.5", "4, 0.05", "5, 30"})
    void noPostIsFurtherOffThanAllowedAndTheErrorIsTheOneReached(long seed, double accuracy) {
        int columns = 41;
        int rows = 33;
        Posts posts = posts(columns, rows, hills(new Random(seed), columns, rows));
        PostTriangles kept = thinned(posts, accuracy);
        double worst = greatestError(posts, kept);
        assertThat(worst).as("seed %d", seed).isLessThanOrEqualTo(accuracy);
        assertThat(kept.error()).isEqualTo(worst, within(1e-9));
        assertThat(wholeArea(kept, columns)).isEqualTo(2L * (columns - 1) * (rows - 1));
        assertThat(kept.count()).isLessThanOrEqualTo(2 * (columns - 1) * (rows - 1));
    }

    private static PostTriangles thinned(Posts posts, double accuracy) {
        return Decimation.of(posts, accuracy, LongTask.silent());
    }

    private static PostTriangles thinned(Posts posts, double accuracy, int most) {
        return Decimation.of(posts, accuracy, most, LongTask.silent());
    }

    /** Holes of one post, of blocks, at corners and rims: covered is exactly what has heights. Seeds 1 to 40. */
    @Test
    void holesStayHoles() {
        int columns = 23;
        int rows = 19;
        for (long seed = 1; seed <= 40; seed++) {
            Random random = new Random(seed);
            float[] heights = hills(random, columns, rows);
            for (int hole = 0; hole < random.nextInt(12); hole++) {
                int x = random.nextInt(columns);
                int y = random.nextInt(rows);
                int size = 1 + random.nextInt(5);
                for (int i = 0; i < heights.length; i++) {
                    if (Math.abs(i % columns - x) < size && Math.abs(i / columns - y) < size - random.nextInt(2)) {
                        heights[i] = Float.NaN;
                    }
                }
            }
            Posts posts = posts(columns, rows, heights);
            PostTriangles all = PostTriangles.all(posts);
            PostTriangles kept = thinned(posts, 3.0);
            assertThat(wholeArea(kept, columns)).as("seed %d", seed).isEqualTo(wholeArea(all, columns));
            assertThat(greatestError(posts, kept)).as("seed %d", seed).isLessThanOrEqualTo(3.0);
        }
    }

    @Test
    void nothingIsLeftOfPostsAlone() {
        float[] heights = new float[25];
        Arrays.fill(heights, Float.NaN);
        heights[6] = 1;
        heights[18] = 2;
        heights[19] = 2;
        assertThat(thinned(posts(5, 5, heights), 1.0).count()).isZero();
        assertThat(PostTriangles.all(posts(5, 5, heights)).count()).isZero();
    }

    /** Flat ground of 400 m needs two triangles: the earth bends by 6 mm over it. */
    @Test
    void flatGroundNeedsTwoTriangles() {
        Posts flat = posts(41, 41, new float[41 * 41]);
        assertThat(thinned(flat, 0.05).count()).isEqualTo(2);
        assertThat(thinned(flat, 0.05).error()).isBetween(0.002, 0.01);
        assertThat(thinned(flat, 0.002).count()).isGreaterThan(2);
    }

    /** Noise cannot be decimated: before it fills the memory there is a line. */
    @ParameterizedTest
    @ValueSource(doubles = {0.0, 0.001})
    void trianglesAreBounded(double accuracy) {
        Posts noise = posts(41, 33, hills(new Random(3), 41, 33));
        assertThatThrownBy(() -> thinned(noise, accuracy, 1000))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("an accuracy of " + accuracy + " m needs more than 1,000 triangles");
        assertThat(thinned(noise, 10.0, 1000).count()).isLessThan(1000);
    }

    /** At accuracy 0 every post is kept, and every square cut from its north-western to its south-eastern post. */
    @Test
    void atZeroEveryPostIsKeptAndSquaresAreCutAlongTheNorthWestDiagonal() {
        PostTriangles all = thinned(posts(3, 2, 0, 1, 2, 3, 4, 5), 0.0);
        assertThat(all.corners()).containsExactly(0, 4, 3, 0, 1, 4, 1, 5, 4, 1, 2, 5);
    }

    /** With a tiny error it is the same triangulation, found the other way: every unit square has its diagonal. */
    @ParameterizedTest
    @ValueSource(longs = {7, 8, 9})
    void withATinyErrorEverySquareHasTheSameDiagonal(long seed) {
        Posts posts = posts(17, 13, hills(new Random(seed), 17, 13));
        assertThat(triangles(thinned(posts, 1e-9))).isEqualTo(triangles(thinned(posts, 0.0)));
    }

    /** As texts in an order of their own: each begins with its smallest post. */
    private static java.util.List<String> triangles(PostTriangles all) {
        int[] c = all.corners();
        return IntStream.range(0, all.count())
                .mapToObj(t -> {
                    int first = IntStream.range(0, 3)
                            .reduce((a, b) -> c[3 * t + a] < c[3 * t + b] ? a : b)
                            .orElseThrow();
                    return IntStream.range(0, 3)
                            .mapToObj(k -> String.valueOf(c[3 * t + (first + k) % 3]))
                            .reduce((a, b) -> a + " " + b)
                            .orElseThrow();
                })
                .sorted()
                .toList();
    }

    /**
     * A hill of 100 m within 1 m: 400 of 20,000 triangles as this was written. More would mean that it no longer
     * chooses well.
     */
    @Test
    void fewTrianglesAreKept() {
        int side = 101;
        float[] heights = new float[side * side];
        for (int i = 0; i < heights.length; i++) {
            double r2 = Math.pow(i % side - 50, 2) + Math.pow(i / side - 50, 2);
            heights[i] = (float) (100.0 * Math.exp(-r2 / 400.0));
        }
        PostTriangles kept = thinned(posts(side, side, heights), 1.0);
        assertThat(kept.count()).isLessThanOrEqualTo(420);
    }

    /** The polynomial that places posts against each of them placed by itself. */
    @ParameterizedTest
    @CsvSource({
        "EPSG:32633, 458502, 5547686, 25",
        "EPSG:5514, -743011, -1043823, 25",
        "EPSG:4326, 14.42, 50.08, 0.0008333"
    })
    void postsAreWhereTheyWouldBeOneByOne(String code, double x, double y, double step) {
        MapTransform map = new MapTransform(
                CoordinateReferenceSystem.of(code), Origin.at(Math.toRadians(50.08), Math.toRadians(14.42)));
        int side = 2001;
        Lattice lattice = new Lattice(x - 1000 * step, y + 1000 * step, step, 0, 0, -step);
        PostFrame frame = new PostFrame(lattice, side, side, map);
        PostFrame.Row row = frame.newRow();
        Random random = new Random(5);
        for (int i = 0; i < 200; i++) {
            int c = random.nextInt(side);
            int r = random.nextInt(side);
            double height = 4000.0 * random.nextDouble();
            row.to(r);
            row.column(c);
            double up = row.up(height);
            var exact = map.inWorld(lattice.xAt(c, r), lattice.yAt(c, r), height);
            assertThat(up).isEqualTo(exact.z(), within(1e-6));
            assertThat(row.east(up)).isEqualTo(exact.x(), within(1e-6));
            assertThat(row.north(up)).isEqualTo(exact.y(), within(1e-6));
        }
    }
}
