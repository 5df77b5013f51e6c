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
