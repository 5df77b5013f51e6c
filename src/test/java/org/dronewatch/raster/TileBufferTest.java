package org.dronewatch.raster;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** What a tile remembers of its pixels while triangles are rasterised, against looking at each of them. */
class TileBufferTest {
    private static final int SIZE = 40;
    private static final long SEED = 240;

    private final SplittableRandom random = new SplittableRandom(SEED);
    private final TileBuffer pixels = new TileBuffer(new PixelGrid(), SIZE, SIZE);
    private final double[] inverses = new double[SIZE * SIZE];
    private int columns;
    private int rows;

    @Test
    void theFarthestPixelAndThoseBeyond() {
        int beyond = 0;
        int hidden = 0;
        int full = 0;
        for (int tile = 0; tile < 300; tile++) {
            begin();
            for (int stroke = 0; stroke < 200; stroke++) {
                rasterise();
                int left = random.nextInt(columns);
                int right = left + random.nextInt(columns - left);
                int top = random.nextInt(rows);
                int bottom = top + random.nextInt(rows - top);
                double least = least(left, right, top, bottom);
                double inverse = random.nextBoolean() ? least : 2.0 * random.nextDouble();
                boolean found = pixels.anyBeyond(inverse, left, right, top, bottom);
                assertThat(found)
                        .as("seed %d, tile %d, stroke %d: anything beyond %s", SEED, tile, stroke, inverse)
                        .isEqualTo(least < inverse);
                beyond += found ? 1 : 0;
                hidden += found || least == 0.0 ? 0 : 1;
                if (random.nextInt(4) == 0) {
                    double farthest = 1.0 / least(0, columns - 1, 0, rows - 1);
                    assertThat(pixels.farthest())
                            .as("seed %d, tile %d, stroke %d: the farthest", SEED, tile, stroke)
                            .isEqualTo(farthest);
                    full += farthest < Double.POSITIVE_INFINITY ? 1 : 0;
                }
            }
        }
        assertThat(beyond).as("rectangles with pixels beyond").isGreaterThan(10_000);
        assertThat(hidden).as("rectangles painted over").isGreaterThan(10_000);
        assertThat(full).as("tiles painted over").isGreaterThan(3_000);
    }

    private void begin() {
        columns = 1 + random.nextInt(SIZE);
        rows = 1 + random.nextInt(SIZE);
        pixels.begin(random.nextInt(100) - 50, random.nextInt(100) - 50, columns, rows);
        for (int pixel = 0; pixel < columns * rows; pixel++) {
            inverses[pixel] = 0.0;
        }
    }

    /** Paints a rectangle by rows, in which the inverse grows from the left to the right, or by columns, downwards. */
    private void rasterise() {
        boolean upright = random.nextBoolean();
        int left = random.nextInt(columns) / 2;
        int right = left + random.nextInt(columns - left);
        int top = random.nextInt(rows) / 2;
        int bottom = top + random.nextInt(rows - top);
        double inverse = random.nextDouble();
        double step = 0.02 * random.nextDouble();
        for (int row = top; row <= bottom; row++) {
            for (int column = left; column <= right; column++) {
                int pixel = row * columns + column;
                inverses[pixel] = Math.max(inverses[pixel], inverse + (upright ? row : column) * step);
            }
        }
        for (int row = top; !upright && row <= bottom; row++) {
            pixels.fillRow(row, left, right, inverse, step, 7);
        }
        for (int column = left; upright && column <= right; column++) {
            pixels.fillColumn(column, top, bottom, inverse, step, 7);
        }
    }

    private double least(int left, int right, int top, int bottom) {
        double least = Double.POSITIVE_INFINITY;
        for (int row = top; row <= bottom; row++) {
            for (int column = left; column <= right; column++) {
                least = Math.min(least, inverses[row * columns + column]);
            }
        }
        return least;
    }
}
