package org.dronewatch.mesh.polygon;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.Random;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.geometry.Floats;
import org.dronewatch.geometry.Ints;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.mesh.io.LoadedModel;
import org.dronewatch.mesh.io.ModelLoader;
import org.dronewatch.mesh.io.ModelSettings;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

public class PolygonCutterTest {
    /** Linear time needs seconds for the largest polygons together; 10,000,000,000 steps for each take far longer. */
    private static final Duration TIME_LIMIT = Duration.ofMinutes(2);

    private static final int LARGE_POLYGONS = LongForm.count(2, 4);
    private static final Path FORMER_FAILURES = Path.of("src/test/resources/fuzz");
    private static final double[][] ARROWHEAD = {{0, 0}, {4, 0}, {4, 4}, {3, 1}};

    private final Floats vertices = new Floats();
    private final Ints triangles = new Ints();

    /** Cuts a polygon whose corners no other polygon has. */
    private boolean cut(double[]... corners) {
        int first = vertices.size() / 3;
        for (double[] corner : corners) {
            for (int axis = 0; axis < 3; axis++) {
                vertices.add((float) (axis < corner.length ? corner[axis] : 0.0));
            }
        }
        triangles.clear();
        return new PolygonCutter(vertices)
                .cut(IntStream.range(first, first + corners.length).toArray(), triangles);
    }

    private Vector3d vertex(int index) {
        return new Vector3d(vertices.get(3 * index), vertices.get(3 * index + 1), vertices.get(3 * index + 2));
    }

    /** Twice the area as a vector. */
    private Vector3d normal(int triangle) {
        Vector3d a = vertex(triangles.get(3 * triangle));
        Vector3d b = vertex(triangles.get(3 * triangle + 1)).sub(a);
        return b.cross(vertex(triangles.get(3 * triangle + 2)).sub(a));
    }

    private double coveredArea() {
        return IntStream.range(0, triangles.size() / 3)
                .mapToDouble(i -> 0.5 * normal(i).length())
                .sum();
    }

    /** Twice the area of the polygon of the last vertices as a vector, by Newell. */
    private Vector3d newell(int corners) {
        int first = vertices.size() / 3 - corners;
        Vector3d sum = new Vector3d();
        for (int i = 0; i < corners; i++) {
            Vector3d a = vertex(first + i).sub(vertex(first));
            sum.add(a.cross(vertex(first + (i + 1) % corners).sub(vertex(first))));
        }
        return sum;
    }

    private void assertCovered(int corners, String name) {
        Vector3d polygon = newell(corners);
        double area = 0.5 * polygon.length();
        assertThat(coveredArea()).as(name).isCloseTo(area, within(1e-5 * area));
        for (int i = 0; i < triangles.size() / 3; i++) {
            assertThat(normal(i).dot(polygon)).as(name).isGreaterThanOrEqualTo(-1e-6 * polygon.dot(polygon));
        }
    }

    /** Area of all triangles of a mesh. */
    public static double area(TriangleMesh mesh) {
        double[] normal = new double[3];
        double area = 0.0;
        for (int i = 0; i < mesh.triangleCount(); i++) {
            mesh.normal(i, normal);
            area += 0.5 * Math.sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
        }
        return area;
    }

    private static int[] fan(int size) {
        return IntStream.range(1, size - 1)
                .flatMap(i -> IntStream.of(0, i, i + 1))
                .toArray();
    }

    private static double[][] corners(int count, IntFunction<double[]> corner) {
        return IntStream.range(0, count).mapToObj(corner).toArray(double[][]::new);
    }

    private static double[][] circle(int count, double radius) {
        return corners(count, i ->
                new double[] {radius * Math.cos(2 * Math.PI * i / count), radius * Math.sin(2 * Math.PI * i / count)});
    }

    @Test
    void aConcavePolygonOfAFileCoversItsOwnArea() {
        LoadedModel model = new ModelLoader(FORMER_FAILURES).load(ModelSettings.of("concave-polygon/model.obj"));

        assertThat(area(model.mesh())).isEqualTo(4.0);
        assertThat(model.warnings()).isEmpty();
        assertThat(model.dropped()).isZero();
    }

    @ParameterizedTest
    @CsvSource({"0,1,2", "0,2,1", "1,0,2", "1,2,0", "2,0,1", "2,1,0"})
    void planesAlongAxesAreCutExactlyWhereverTheyAreAndWhereverTheyBegin(int x, int y, int z) {
        for (double offset : new double[] {0.0, -7.5, 1e6, 1e7}) {
            for (int start = 0; start < 4; start++) {
                int first = start;
                double[][] placed = corners(4, i -> {
                    double[] corner = new double[3];
                    corner[x] = ARROWHEAD[(i + first) % 4][0] + offset;
                    corner[y] = ARROWHEAD[(i + first) % 4][1] - offset;
                    corner[z] = offset;
                    return corner;
                });

                assertThat(cut(placed)).isTrue();
                assertThat(coveredArea())
                        .as("offset " + offset + ", start " + start)
                        .isEqualTo(4.0);
                assertCovered(4, "offset " + offset + ", start " + start);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-30, 1e-12, 1.0, 1e12, 1e28})
    void sizesFromTheSmallestToTheLargestAreCut(double scale) {
        double[][] placed = corners(
                4, i -> new double[] {ARROWHEAD[i][0] * scale, ARROWHEAD[i][1] * scale, ARROWHEAD[i][0] * scale});

        assertThat(cut(placed)).isTrue();
        assertCovered(4, "scale " + scale);
    }

    @Test
    void randomPolygonsInRandomPlanesAreCoveredAndNoTriangleIsTurnedOver() {
        for (int seed = 1; seed <= 2000; seed++) {
            Random random = new Random(seed);
            int size = 4 + random.nextInt(seed % 20 == 0 ? 400 : 40);
            Quaterniond turn = new Quaterniond(
                            random.nextGaussian(), random.nextGaussian(), random.nextGaussian(), random.nextGaussian())
                    .normalize();
            Vector3d position = new Vector3d(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())
                    .mul(seed % 2 == 0 ? 0.0 : 100.0);
            double[][] flat = seed % 3 == 0 ? skyline(random, size) : star(random, size);
            double[][] placed = Arrays.stream(flat)
                    .map(corner ->
                            new Vector3d(corner[0], corner[1], 0.0).rotate(turn).add(position))
                    .map(corner -> new double[] {corner.x, corner.y, corner.z})
                    .toArray(double[][]::new);

            assertThat(cut(placed)).as("seed " + seed).isTrue();
            assertCovered(placed.length, "seed " + seed);
        }
    }

    /** Corners at growing angles about the origin, some of them close together. */
    private static double[][] star(Random random, int size) {
        double[] angles = random.doubles(size, 0.0, 2 * Math.PI).sorted().toArray();
        // No gap of half a turn, which would put the origin outside.
        for (int i = 0; i < size; i++) {
            angles[i] = 0.5 * angles[i] + 0.5 * 2 * Math.PI * i / size;
        }
        return corners(size, i -> {
            double radius = 5.0 + 95.0 * random.nextDouble();
            return new double[] {radius * Math.cos(angles[i]), radius * Math.sin(angles[i])};
        });
    }

    /** Random heights over a level line, and below it. */
    private static double[][] skyline(Random random, int size) {
        return corners(
                size,
                i -> i < size / 2
                        ? new double[] {2.0 * (size / 2 - i), 1.0 + 50.0 * random.nextDouble()}
                        : new double[] {2.0 * (i - size / 2) + 1.0, -1.0 - 50.0 * random.nextDouble()});
    }

    @Test
    void randomConvexPolygonsKeepTheFanFromTheirFirstCorner() {
        for (int seed = 1; seed <= 300; seed++) {
            Random random = new Random(seed);
            int size = 4 + random.nextInt(PolygonCutter.MOST_CORNERS_OF_A_FAN - 3);
            double tilt = random.nextDouble();
            double[] angles = random.doubles(size, 0.0, 2 * Math.PI).sorted().toArray();
            vertices.clear();

            cut(corners(size, i ->
                    new double[] {30 * Math.cos(angles[i]), 20 * Math.sin(angles[i]), tilt * Math.cos(angles[i])}));

            assertThat(triangles.copyOfRange(0, triangles.size()))
                    .as("seed " + seed)
                    .isEqualTo(fan(size));
        }
    }

    @Test
    void collinearAndRepeatedCornersKeepTheFanWhereItCovers() {
        double[][] wall = {{0, 0}, {1, 0}, {2, 0}, {2, 0}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
        vertices.clear();

        assertThat(cut(wall)).isTrue();
        assertThat(triangles.copyOfRange(0, triangles.size())).isEqualTo(fan(wall.length));
        assertCovered(wall.length, "wall");
    }

    @Test
    void collinearAndRepeatedCornersOfAConcavePolygonAreCut() {
        assertThat(cut(new double[][] {{0, 0}, {2, 0}, {4, 0}, {4, 0}, {4, 4}, {3.5, 2.5}, {3, 1}, {3, 1}, {1.5, 0.5}}))
                .isTrue();
        assertThat(coveredArea()).isCloseTo(4.0, within(1e-12));
    }

    @Test
    void aPolygonWithABridgeToItsHoleLeavesTheHoleOpen() {
        double[][] frame = {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}};

        assertThat(cut(frame)).isTrue();
        assertThat(coveredArea()).isCloseTo(32.0, within(1e-12));
        assertCovered(frame.length, "frame");
    }

    @Test
    void windingIsKept() {
        double[][] backwards = corners(4, i -> ARROWHEAD[3 - i]);

        assertThat(cut(backwards)).isTrue();
        for (int i = 0; i < triangles.size() / 3; i++) {
            assertThat(normal(i).z).isNegative();
        }
    }

    @Test
    void aPolygonThatIsNotPlaneIsCutAsSeenAlongItsMeanNormal() {
        assertThat(cut(new double[][] {{0, 0, 0}, {4, 0, 0.3}, {4, 4, -0.2}, {3, 1, 0.4}}))
                .isTrue();
        for (int i = 0; i < triangles.size() / 3; i++) {
            assertThat(normal(i).dot(newell(4))).isPositive();
        }
    }

    @Test
    void aPolygonThatCrossesItselfStaysAFanAndIsAWarning() {
        LoadedModel model =
                new ModelLoader(FORMER_FAILURES).load(ModelSettings.of("polygon-that-crosses-itself/model.obj"));

        assertThat(model.warnings()).singleElement().asString().contains("model.obj:5: polygon crosses itself");
        assertThat(model.mesh().triangleCount()).isEqualTo(2);
        assertThat(cut(corners(5, i -> circle(5, 1.0)[2 * i % 5]))).isFalse();
        assertThat(triangles.size()).isEqualTo(9);
    }

    @Test
    void aPolygonInALineHasNoAreaAndIsNoWarning() {
        assertThat(cut(new double[][] {{0, 0}, {1, 0.1}, {3, 0.3}, {2, 0.2}})).isTrue();
        assertThat(cut(new double[][] {{5, 5}, {5, 5}, {5, 5}, {5, 5}, {5, 5}})).isTrue();
        assertThat(coveredArea()).isZero();
    }

    @Thorough
    @ParameterizedTest
    @ValueSource(ints = {10_000, 100_000})
    void polygonsOfManyCornersAreCutInSeconds(int size) {
        assertTimeoutPreemptively(TIME_LIMIT, () -> {
            for (int seed = 1; seed <= LARGE_POLYGONS; seed++) {
                cutCircleAndStar(size, seed);
            }
        });
    }

    private void cutCircleAndStar(int size, int seed) {
        vertices.clear();
        assertThat(cut(circle(size, 10.0))).isTrue();
        assertCovered(size, "circle");
        assertThat(triangles.size()).isGreaterThan(3 * size - 100);
        Random random = new Random(seed);
        double[][] star = corners(size, i -> {
            double radius = 9.0 + random.nextDouble();
            return new double[] {radius * Math.cos(2 * Math.PI * i / size), radius * Math.sin(2 * Math.PI * i / size)};
        });
        assertThat(cut(star)).as("seed %d", seed).isTrue();
        assertCovered(size, "star of seed " + seed);
    }

    /** A fan's triangles all meet in one corner: there they share boxes without end. Ears share few. */
    @Test
    void fewTrianglesOfALargePolygonReachFar() {
        cut(circle(10_000, 10.0));

        long far = IntStream.range(0, triangles.size() / 3)
                .filter(i -> vertex(triangles.get(3 * i)).distance(vertex(triangles.get(3 * i + 1))) > 1.0
                        || vertex(triangles.get(3 * i + 1)).distance(vertex(triangles.get(3 * i + 2))) > 1.0)
                .count();

        assertThat(far).isLessThan(300);
    }

    @ParameterizedTest
    @ValueSource(ints = {1_000, 10_000, 300_000})
    void polygonsThatCrossThemselvesOrRepeatTheirCornersAreGivenUpInSeconds(int size) {
        assertTimeoutPreemptively(TIME_LIMIT, () -> {
            Random random = new Random(size);
            double[][] tangle = corners(size, i -> new double[] {random.nextDouble(), random.nextDouble()});
            assertThat(cut(tangle)).isFalse();
            double[][] parabola = corners(size, i -> {
                double x = -1.0 + 2.0 * i / (size - 2);
                return i < size - 1 ? new double[] {x, x * x} : new double[] {0.0, -0.5};
            });
            assertThat(cut(parabola)).isFalse();
            double[][] three = {{0, 0}, {1, 0}, {0, 1}};
            cut(corners(size, i -> three[random.nextInt(3)]));
            double[][] lattice = corners(size, i -> new double[] {random.nextInt(4), random.nextInt(2) * 3});
            cut(lattice);
        });
    }
}
