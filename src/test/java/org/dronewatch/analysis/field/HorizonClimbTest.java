package org.dronewatch.analysis.field;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.function.IntBinaryOperator;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Lowest visible heights against a published table, closed forms, and rays at all heights. */
class HorizonClimbTest {
    private static final double TOP = 500.0;

    /**
     * Ground that is linear between posts a metre apart, the same from south to north. Source of the heights: the test
     * of GDAL's viewshed in its GROUND mode, autotest/cpp/test_viewshed.cpp.
     */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
                    0 0 0 1 0 0 0 0 | 2 | 0 0 0 0 2 3 4 5
                    0 0 1 1 3 4 5 4 | 0 | 0 0 0 0.5 0 0 0 1.8333333
                    0 0 0 1 1 0 0 0 | 0 | 0 0 0 0 0.3333333 1.6666667 2 2.3333333
                    """)
    void heightsBehindARidgeAreThoseOfTheTable(String ground, int observer, String expected) {
        double[] posts = numbers(ground);
        double[] heights = numbers(expected);
        HorizonClimb climb = new HorizonClimb(World.of(extruded(posts)));
        // What touches a surface counts as in front of it, on either side: the eye is 0.1 mm above the ground.
        Position eye = new Position(observer, 0.3, posts[observer] + 1e-4);
        for (int i = 0; i < posts.length; i++) {
            double lowest = climb.lowest(eye, i, 0.3, posts[i], TOP);
            assertThat(lowest - posts[i]).as("post %d", i).isCloseTo(heights[i], within(1e-3));
        }
    }

    private static double[] numbers(String row) {
        return Arrays.stream(row.strip().split(" +"))
                .mapToDouble(Double::parseDouble)
                .toArray();
    }

    private static TriangleMesh extruded(double[] posts) {
        float[] vertices = new float[6 * posts.length];
        List<Integer> corners = new ArrayList<>();
        for (int i = 0; i < posts.length; i++) {
            float z = (float) posts[i];
            System.arraycopy(new float[] {i, -50, z, i, 50, z}, 0, vertices, 6 * i, 6);
            if (i > 0) {
                corners.addAll(List.of(2 * i - 2, 2 * i, 2 * i - 1, 2 * i - 1, 2 * i, 2 * i + 1));
            }
        }
        return TriangleMesh.of(
                vertices, corners.stream().mapToInt(Integer::intValue).toArray());
    }

    /** Ground whose height is known at posts a metre apart: two triangles for each four, which meet in a diagonal. */
    private static World posts(int rows, int columns, boolean isFromNorthWest, IntBinaryOperator heights) {
        float[] vertices = new float[3 * rows * columns];
        List<Integer> corners = new ArrayList<>();
        for (int i = 0; i < rows * columns; i++) {
            int row = i / columns;
            int column = i % columns;
            float[] post = {column, -row, heights.applyAsInt(row, column)};
            System.arraycopy(post, 0, vertices, 3 * i, 3);
            if (row > 0 && column > 0) {
                int north = i - columns;
                corners.addAll(
                        isFromNorthWest
                                ? List.of(i, north, north - 1, i, north - 1, i - 1)
                                : List.of(i - 1, north, north - 1, i, north, i - 1));
            }
        }
        return World.of(TriangleMesh.of(
                vertices, corners.stream().mapToInt(Integer::intValue).toArray()));
    }

    /**
     * A wall of posts 10 m high on a plain, and a pyramid with sides that rise by 2 m from post to post, for either
     * diagonal. The ridge's heights are also those of GDAL 3.10; all follow from the sections of the triangles.
     */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
                    ridge   | true  | 20 20 2 | 20 | 40 50 51 60 70 80 | 0 0 10.2666667 12.6666667 15.3333333 18
                    ridge   | false | 20 20 2 | 20 | 40 50 51 60 70 80 | 0 0 10.2666667 12.6666667 15.3333333 18
                    pyramid | true  | 30 5 3  | 10 | 40 50 60          | 0.4 7.2 14
                    pyramid | false | 30 5 3  | 10 | 40 50 60          | 0.1875 5.6471 12.2105
                    """)
    void heightsBehindPostsAreThoseOfTheirTriangles(
            String shape, boolean isFromNorthWest, String observer, int row, String columns, String expected) {
        IntBinaryOperator pyramid = (r, c) -> Math.max(0, 20 - 2 * Math.max(Math.abs(r - 30), Math.abs(c - 30)));
        IntBinaryOperator heights = shape.equals("pyramid") ? pyramid : (r, c) -> c == 50 ? 10 : 0;
        HorizonClimb climb = new HorizonClimb(posts(61, 81, isFromNorthWest, heights));
        double[] from = numbers(observer);
        Position eye = new Position(from[1], -from[0], from[2]);
        double[] at = numbers(columns);
        for (int i = 0; i < at.length; i++) {
            double ground = heights.applyAsInt(row, (int) at[i]);
            assertThat(climb.lowest(eye, at[i], -row, ground, TOP) - ground)
                    .as("column %s", at[i])
                    .isCloseTo(numbers(expected)[i], within(1e-3));
        }
    }

    /** A pyramid with edges of 40 m and a height of 30 m on a plain. */
    private static final TriangleMesh PYRAMID = TriangleMesh.of(
            new float[] {
                -20, -20, 0, 20, -20, 0, 20, 20, 0, -20, 20, 0, 0, 0, 30, -500, -500, 0, 500, -500, 0, 500, 500, 0,
                -500, 500, 0
            },
            new int[] {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 5, 6, 7, 5, 7, 8});

    /** Over the apex by similar triangles; beside it over the highest point of the section. */
    @Test
    void heightsBehindAPyramidFollowFromItsSection() {
        HorizonClimb climb = new HorizonClimb(World.of(PYRAMID));
        Position eye = new Position(-100, 0, 2);
        assertThat(climb.lowest(eye, 60, 0, 0, TOP)).isCloseTo(2 + 28.0 / 100 * 160, within(1e-3));
        // In the section through an edge of the pyramid, its height is 30 (1 - |y| / 20) where |x| = |y|.
        for (double y : new double[] {1, 5.5, 12, 19, 26, -8, -33, 90}) {
            assertThat(climb.lowest(eye, 60, y, 0, TOP)).as("y %s", y).isCloseTo(expected(eye, 60, y), within(1e-3));
        }
        assertThat(climb.lowest(eye, 60, 90, 0, TOP)).as("past the pyramid").isZero();
        assertThat(climb.lowest(eye, -60, 0, 0, TOP)).as("in front of it").isZero();
        assertThat(climb.lowest(eye, 10, 0, 0, TOP)).as("within it").isCloseTo(2 + 28.0 / 100 * 110, within(1e-3));
        assertThat(climb.lowest(eye, 60, 0, 0, 46)).as("beyond the top").isNaN();
    }

    private static double expected(Position eye, double x, double y) {
        double lowest = 0.0;
        for (int i = 1; i < 200_000; i++) {
            double share = i / 200_000.0;
            double at = eye.x() + share * (x - eye.x());
            double aside = share * y;
            double ground = 30 * (1 - Math.max(Math.abs(at), Math.abs(aside)) / 20);
            lowest = ground > 0 ? Math.max(lowest, eye.z() + (ground - eye.z()) / share) : lowest;
        }
        return lowest;
    }

    /** Under a bridge the line of sight is free from the ground on, and through a window from its sill on. */
    @Test
    void openingsAreNotPassedOver() {
        World bridge = World.of(wall(50, 6, 9));
        World window = World.of(World.merge(List.of(wall(50, -1, 4), wall(50, 6, 9))));
        Position eye = new Position(0, 0, 2);
        assertThat(new HorizonClimb(bridge).lowest(eye, 0, 100, 0, TOP)).isZero();
        assertThat(new HorizonClimb(window).lowest(eye, 0, 100, 0, TOP)).isCloseTo(6, within(1e-3));
        assertThat(new HorizonClimb(window).lowest(eye, 0, 100, 10.5, TOP)).isCloseTo(16, within(1e-3));
    }

    /** Edge-on, a wall is met in its plane. */
    @Test
    void aWallThatIsSeenEdgeOnIsCleared() {
        TriangleMesh alongNorth =
                TriangleMesh.of(new float[] {0, 40, 0, 0, 60, 0, 0, 60, 10, 0, 40, 10}, new int[] {0, 1, 2, 0, 2, 3});
        World both = World.of(World.merge(List.of(alongNorth, wall(50, -1, 4))));
        double lowest = new HorizonClimb(both).lowest(new Position(0, 0, 2), 0, 100, 0, TOP);
        assertThat(lowest).isGreaterThanOrEqualTo(6);
        assertThat(new Visibility(both).isFree(new Position(0, 0, 2), new Position(0, 100, lowest)))
                .isTrue();
    }

    @Test
    void straightAboveAndBelowASurfaceCounts() {
        World roof = World.of(
                TriangleMesh.of(new float[] {-9, -9, 5, 9, -9, 5, 9, 9, 5, -9, 9, 5}, new int[] {0, 1, 2, 0, 2, 3}));
        HorizonClimb climb = new HorizonClimb(roof);
        assertThat(climb.lowest(new Position(1, 2, 8), 1, 2, 0, TOP)).isCloseTo(5, within(1e-3));
        assertThat(climb.lowest(new Position(1, 2, 3), 1, 2, 6, TOP))
                .as("through the roof")
                .isNaN();
        assertThat(climb.lowest(new Position(1, 2, 3), 1, 2, 0, TOP)).isZero();
        assertThat(climb.lowest(new Position(1, 2, 3), 4, 2, 6, TOP))
                .as("no height is")
                .isNaN();
    }

    private static TriangleMesh wall(float north, float bottom, float top) {
        return TriangleMesh.of(
                new float[] {-99, north, bottom, 99, north, bottom, 99, north, top, -99, north, top},
                new int[] {0, 1, 2, 0, 2, 3});
    }

    /** Random triangles: free at the height that was found, hidden at all heights below. */
    @Test
    void allHeightsBelowAreHidden() {
        long seed = System.nanoTime();
        System.out.println("HorizonClimbTest: seed " + seed);
        Random random = new Random(seed);
        int raised = 0;
        for (int round = 0; round < 60; round++) {
            World world = World.of(soup(random));
            HorizonClimb climb = new HorizonClimb(world);
            Visibility visibility = new Visibility(world);
            for (int i = 0; i < 10; i++) {
                Position eye = new Position(random.nextDouble(), random.nextDouble(), random.nextDouble());
                double x = 10 * random.nextDouble();
                double y = 10 * random.nextDouble();
                double lowest = climb.lowest(eye, x, y, 0, 10);
                double end = Double.isNaN(lowest) ? 10 : lowest;
                for (double z = 0; z < end - 2e-3; z += 0.02) {
                    assertThat(visibility.isFree(eye, new Position(x, y, z)))
                            .as("seed %d, round %d, from %s to %s %s %s, lowest %s", seed, round, eye, x, y, z, lowest)
                            .isFalse();
                }
                if (!Double.isNaN(lowest)) {
                    assertThat(visibility.isFree(eye, new Position(x, y, lowest)))
                            .isTrue();
                    raised += lowest > 0 ? 1 : 0;
                }
            }
        }
        assertThat(raised).isGreaterThan(30);
    }

    private static TriangleMesh soup(Random random) {
        int count = 40;
        float[] vertices = new float[9 * count];
        for (int triangle = 0; triangle < count; triangle++) {
            for (int axis = 0; axis < 3; axis++) {
                double middle = 10 * random.nextDouble();
                for (int corner = 0; corner < 3; corner++) {
                    vertices[9 * triangle + 3 * corner + axis] = (float) (middle + 6 * random.nextDouble() - 3);
                }
            }
        }
        int[] corners = new int[3 * count];
        Arrays.setAll(corners, i -> i);
        return TriangleMesh.of(vertices, corners);
    }
}
