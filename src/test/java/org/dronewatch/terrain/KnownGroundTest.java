package org.dronewatch.terrain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.dronewatch.geometry.TriangleMesh;
import org.junit.jupiter.api.Test;

/** Lines over a square of 10 x 10 cells with a hole in it and a bay in its rim. */
class KnownGroundTest {
    private static final int SIDE = 10;

    /** Cells of a metre each; column 4 to 5 and row 4 to 6 are a hole, column 8 and 9 of row 2 a bay. */
    private static boolean isThere(int column, int row) {
        boolean isHole = column >= 4 && column <= 5 && row >= 4 && row <= 6;
        boolean isBay = column >= 8 && row == 2;
        return column >= 0 && row >= 0 && column < SIDE && row < SIDE && !isHole && !isBay;
    }

    private static KnownGround ground() {
        float[] vertices = new float[3 * (SIDE + 1) * (SIDE + 1)];
        for (int row = 0; row <= SIDE; row++) {
            for (int column = 0; column <= SIDE; column++) {
                int vertex = row * (SIDE + 1) + column;
                vertices[3 * vertex] = column;
                vertices[3 * vertex + 1] = row;
                vertices[3 * vertex + 2] = column + 0.5f * row;
            }
        }
        List<Integer> corners = new ArrayList<>();
        for (int row = 0; row < SIDE; row++) {
            for (int column = 0; column < SIDE; column++) {
                if (isThere(column, row)) {
                    int a = row * (SIDE + 1) + column;
                    corners.addAll(List.of(a, a + 1, a + SIDE + 2, a, a + SIDE + 2, a + SIDE + 1));
                }
            }
        }
        return new KnownGround(new TerrainGround(TriangleMesh.of(
                vertices, corners.stream().mapToInt(Integer::intValue).toArray())));
    }

    @Test
    void theHeightIsThatOfTheTriangle() {
        TerrainGround ground = ground().ground();
        long seed = 7L;
        Random random = new Random(seed);
        for (int i = 0; i < 2000; i++) {
            double x = -1.0 + 12.0 * random.nextDouble();
            double y = -1.0 + 12.0 * random.nextDouble();
            double height = ground.heightAt(x, y);
            if (Math.abs(x - Math.rint(x)) < 1e-4 || Math.abs(y - Math.rint(y)) < 1e-4) {
                // So near the rim, corners are rounded to floats.
                continue;
            }
            if (isThere((int) Math.floor(x), (int) Math.floor(y))) {
                assertThat(Math.abs(height - x - 0.5 * y))
                        .as("seed %d: %s %s", seed, x, y)
                        .isLessThan(1e-6);
            } else {
                assertThat(height).as("seed %d: %s %s", seed, x, y).isNaN();
            }
        }
    }

    /** Against many points along each line. */
    @Test
    void aLineIsKnownWhereAllItsPointsAre() {
        KnownGround ground = ground();
        long seed = 20261124L;
        Random random = new Random(seed);
        int known = 0;
        for (int i = 0; i < 3000; i++) {
            double ax = -0.5 + 11.0 * random.nextDouble();
            double ay = -0.5 + 11.0 * random.nextDouble();
            double bx = -0.5 + 11.0 * random.nextDouble();
            double by = -0.5 + 11.0 * random.nextDouble();
            boolean all = true;
            int steps = 4000;
            for (int k = 0; k <= steps; k++) {
                double t = (double) k / steps;
                all &= isThere((int) Math.floor(ax + t * (bx - ax)), (int) Math.floor(ay + t * (by - ay)));
            }
            boolean answer = ground.containsLine(ax, ay, bx, by);
            known += answer ? 1 : 0;
            if (answer != all) {
                // Only where a line cuts a corner by less than a step may points miss it.
                assertThat(answer).as("seed %d, line %d", seed, i).isFalse();
                assertThat(Math.hypot(bx - ax, by - ay) / steps).isLessThan(0.005);
            }
        }
        assertThat(known).isBetween(500, 2500);
    }

    @Test
    void overAHoleAndBeyondTheRimNothingIsKnown() {
        KnownGround ground = ground();
        assertThat(ground.contains(5, 5.5)).isFalse();
        assertThat(ground.contains(3.5, 5.5)).isTrue();
        assertThat(ground.containsLine(1, 5.5, 9, 5.5)).isFalse();
        assertThat(ground.containsLine(1, 3.5, 9, 3.5)).isTrue();
        assertThat(ground.containsLine(1, 3.5, 12, 3.5)).isFalse();
        assertThat(ground.containsLine(9, 1.5, 9, 3.5)).isFalse();
        assertThat(ground.containsLine(9, 3.5, 9, 3.5)).isTrue();
    }
}
