package org.dronewatch.sensor.acoustic.edge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

/** Shortest ways among random sheets, which cross each other, against all ways from end to end. */
class EdgePathTest {
    private static final double WIDTH = 4000;
    private static final Position FRONT = new Position(0, -10, 0);
    private static final Position BEHIND = new Position(0, 10, 0);

    @Test
    void amongRandomSheetsTheShortestWayIsFound() {
        long seed = 9024;
        SplittableRandom random = new SplittableRandom(seed);
        int found = 0;
        int several = 0;
        int most = 0;
        for (int run = 0; run < 300; run++) {
            int sheets = 2 + run % 9;
            double[][] ends = new double[2 * sheets + 2][2];
            ends[0] = new double[] {-10, 0};
            ends[1] = new double[] {10, 4 * random.nextDouble() - 2};
            for (int i = 2; i < ends.length; i += 2) {
                double u = 18 * random.nextDouble() - 9;
                double v = 8 * random.nextDouble() - 4;
                double angle = Math.PI * random.nextDouble();
                double length = 1 + 7 * random.nextDouble();
                ends[i] = new double[] {(float) u, (float) v};
                ends[i + 1] =
                        new double[] {(float) (u + length * Math.cos(angle)), (float) (v + length * Math.sin(angle))};
            }
            double shortest = shortest(ends);
            EdgePath path = new EdgePath(extruded(ends));
            Position source = new Position(0, ends[0][0], ends[0][1]);
            Position sensor = new Position(0, ends[1][0], ends[1][1]);
            double straight = source.distance(sensor);
            if (shortest < straight + 1e-9) {
                continue;
            }
            assertThat(path.find(source, sensor))
                    .as("seed %d, run %d", seed, run)
                    .isTrue();
            assertThat(path.pathDifference())
                    .as("seed %d, run %d: %s", seed, run, Arrays.deepToString(ends))
                    .isCloseTo(shortest - straight, within(1e-6));
            found++;
            several += path.edges().count() > 1 ? 1 : 0;
            most = Math.max(most, path.edges().count());
        }
        assertThat(found).isGreaterThan(200);
        assertThat(several).isGreaterThan(100);
        assertThat(most).isGreaterThanOrEqualTo(4);
    }

    /** Over a sheet or around its side, whichever is shorter: both ways count once, from either end. */
    @Test
    void nearlyEqualWaysCountOnceEach() {
        double[][] detours = {{0.49, 0.52}, {0.52, 0.49}, {3.9, 4.2}, {4.2, 3.9}, {31.5, 33.0}, {0.3, 0.31}};
        for (double[] detour : detours) {
            float side = at(detour[0]);
            float top = at(detour[1]);
            EdgePath path = new EdgePath(rectangles(new float[][] {{(float) -WIDTH, side, (float) -WIDTH, top}}));
            for (Position source : new Position[] {FRONT, BEHIND}) {
                assertThat(path.find(source, source == FRONT ? BEHIND : FRONT)).isTrue();
                assertThat(path.pathDifference())
                        .as("%s", Arrays.toString(detour))
                        .isCloseTo(Math.min(detour[0], detour[1]), within(1e-5));
                assertThat(path.others()).as("%s", Arrays.toString(detour)).isEqualTo(2);
                double longer = Math.min(path.other(0).detour(), path.other(1).detour());
                assertThat(longer)
                        .as("%s: the other way", Arrays.toString(detour))
                        .isCloseTo(Math.max(detour[0], detour[1]), within(1e-5));
            }
        }
    }

    /** A window that neither the vertical nor the horizontal plane meets is nearer than the top of the wall. */
    @Test
    void aShorterWayInAnotherPlaneIsFound() {
        float w = (float) WIDTH;
        EdgePath path = new EdgePath(rectangles(
                new float[][] {{-w, 1.8f, -w, 4f}, {2.2f, w, -w, 4f}, {1.8f, 2.2f, -w, 1.8f}, {1.8f, 2.2f, 2.2f, 4f}}));
        assertThat(path.find(FRONT, BEHIND)).isTrue();
        assertThat(path.pathDifference()).isCloseTo(2 * Math.sqrt(100 + 2 * 1.8 * 1.8) - 20, within(1e-5));
    }

    /** The line between both ends then runs nearly along the wall, and most planes cut it near that line. */
    @Test
    void theShortestWayAroundAWallIsFoundFromPlacesVeryCloseToIt() {
        SplittableRandom random = new SplittableRandom(4);
        EdgePath path = new EdgePath(rectangles(new float[][] {{-8, 8, -1, 8}}));
        for (int run = 0; run < 100; run++) {
            Position source = new Position(random.nextDouble(-7, 7), -random.nextDouble(0.02, 0.1), place(random));
            Position sensor = new Position(random.nextDouble(-7, 7), random.nextDouble(0.02, 0.1), place(random));
            assertThat(path.find(source, sensor)).as("run %d", run).isTrue();
            double straight = source.distance(sensor);
            double shortest = Double.POSITIVE_INFINITY;
            for (double at = -1; at <= 1; at += 1e-4) {
                for (Position edge : new Position[] {
                    new Position(8 * at, 0, 8),
                    new Position(8 * at, 0, -1),
                    new Position(-8, 0, 3.5 + 4.5 * at),
                    new Position(8, 0, 3.5 + 4.5 * at)
                }) {
                    shortest = Math.min(shortest, source.distance(edge) + edge.distance(sensor));
                }
            }
            assertThat(path.pathDifference())
                    .as("run %d: %s to %s", run, source, sensor)
                    .isCloseTo(shortest - straight, within(0.03 * (shortest - straight)));
        }
    }

    private static double place(SplittableRandom random) {
        return random.nextDouble(0.3, 7.5);
    }

    /** How far off the middle of the line between both ends a way has a detour. */
    private static float at(double detour) {
        double half = 10 + detour / 2;
        return (float) Math.sqrt(half * half - 100);
    }

    /** Rectangles in the plane y = 0, each from x to x and from z to z. */
    private static World rectangles(float[][] bounds) {
        float[] vertices = new float[12 * bounds.length];
        int[] corners = new int[6 * bounds.length];
        for (int i = 0; i < bounds.length; i++) {
            for (int k = 0; k < 4; k++) {
                vertices[12 * i + 3 * k] = bounds[i][k % 2];
                vertices[12 * i + 3 * k + 2] = bounds[i][2 + k / 2];
            }
            int[] square = {4 * i, 4 * i + 1, 4 * i + 3, 4 * i, 4 * i + 3, 4 * i + 2};
            System.arraycopy(square, 0, corners, 6 * i, 6);
        }
        return World.of(TriangleMesh.of(vertices, corners));
    }

    /** The shortest way from the first point to the second over ends of sheets, which are the pairs after these. */
    private static double shortest(double[][] ends) {
        int n = ends.length;
        double[][] way = new double[n][n];
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                way[i][j] = isFree(ends, i, j)
                        ? Math.hypot(ends[i][0] - ends[j][0], ends[i][1] - ends[j][1])
                        : Double.POSITIVE_INFINITY;
            }
        }
        for (int k = 0; k < n; k++) {
            for (int i = 0; i < n; i++) {
                for (int j = 0; j < n; j++) {
                    way[i][j] = Math.min(way[i][j], way[i][k] + way[k][j]);
                }
            }
        }
        return way[0][1];
    }

    private static boolean isFree(double[][] ends, int i, int j) {
        for (int s = 2; s < ends.length; s += 2) {
            if (i == s || i == s + 1 || j == s || j == s + 1) {
                continue;
            }
            boolean apart = side(ends[i], ends[j], ends[s]) == side(ends[i], ends[j], ends[s + 1])
                    || side(ends[s], ends[s + 1], ends[i]) == side(ends[s], ends[s + 1], ends[j]);
            if (!apart) {
                return false;
            }
        }
        return true;
    }

    private static double side(double[] from, double[] to, double[] of) {
        return Math.signum((to[0] - from[0]) * (of[1] - from[1]) - (to[1] - from[1]) * (of[0] - from[0]));
    }

    /** Sheets that reach far to both sides of the plane x = 0. */
    private static World extruded(double[][] ends) {
        int sheets = ends.length / 2 - 1;
        float[] vertices = new float[12 * sheets];
        int[] corners = new int[6 * sheets];
        for (int i = 0; i < 4 * sheets; i++) {
            double[] end = ends[2 + i / 2];
            vertices[3 * i] = (float) (i % 2 == 0 ? -WIDTH : WIDTH);
            vertices[3 * i + 1] = (float) end[0];
            vertices[3 * i + 2] = (float) end[1];
        }
        for (int i = 0; i < sheets; i++) {
            int[] square = {4 * i, 4 * i + 1, 4 * i + 3, 4 * i, 4 * i + 3, 4 * i + 2};
            System.arraycopy(square, 0, corners, 6 * i, 6);
        }
        return World.of(TriangleMesh.of(vertices, corners));
    }
}
