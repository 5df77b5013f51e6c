package org.dronewatch.raster;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Which boxes a tile may see something in, against each of its rays. */
class TileCullerTest {
    private static final int SIZE = 12;
    private static final int LEFT = 30;
    private static final int TOP = -7;
    private static final double[] ORIGIN = {2.0, -1.0, 0.5};

    private final PixelGrid grid = new PixelGrid();
    private final TileBuffer pixels = new TileBuffer(grid, SIZE, SIZE);
    private final TileCuller culler = new TileCuller(grid, pixels);

    /** Looks along +x, columns along +y, rows along -z; a pixel is 0.01 wide at a distance of 1. */
    private void begin() {
        double[] corner = {1.0, -0.01 * (LEFT + SIZE / 2), 0.01 * (TOP + SIZE / 2)};
        grid.set(ORIGIN, corner, new double[] {0.0, 0.01, 0.0}, new double[] {0.0, 0.0, -0.01});
        pixels.begin(LEFT, TOP, SIZE, SIZE);
        culler.begin();
    }

    /**
     * The box spans -0.13 to 0.17 m at 9.85 m: columns 4.7 to 7.7 and rows 4.3 to 7.3, of which (7, 7) is painted last.
     */
    @Test
    void aBoxAheadIsSeenUntilAllPixelsBeforeItSeeSomethingNearer() {
        begin();
        double[] ahead = box(10.0, 0.02, 0.02, 0.3);
        for (int pixel = 0; pixel < SIZE * SIZE; pixel++) {
            assertThat(culler.reaches(ahead, 0)).as("pixels painted: %d", pixel).isEqualTo(pixel <= 7 * SIZE + 7);
            pixels.set(pixel % SIZE, pixel / SIZE, 9.0, 0);
        }
    }

    @Test
    void boxesBesideBehindAndBetweenThePixelsAreNotSeen() {
        begin();
        assertThat(culler.reaches(box(10.0, 2.0, 0.0, 0.5), 0)).as("beside").isFalse();
        assertThat(culler.reaches(box(10.0, 0.0, -2.0, 0.5), 0)).as("below").isFalse();
        assertThat(culler.reaches(box(10.0, 0.05, 0.05, 0.02), 0))
                .as("between centres")
                .isFalse();
        assertThat(culler.reaches(box(10.0, 0.0, 0.0, 0.02), 0))
                .as("at a centre")
                .isTrue();
        assertThat(culler.reaches(box(0.0, 0.0, 0.0, 0.1), 0))
                .as("around the eye")
                .isTrue();
    }

    /** No box that any ray of the tile meets before what its pixel sees is ever left out; most others are. */
    @Test
    void randomBoxes() {
        long seed = 230;
        SplittableRandom random = new SplittableRandom(seed);
        int seen = 0;
        int spared = 0;
        int neither = 0;
        for (int i = 0; i < 20_000; i++) {
            double[] corner = vector(random, 1.0);
            double[] right = vector(random, 0.02);
            double[] down = vector(random, 0.02);
            grid.set(ORIGIN, corner, right, down);
            int left = random.nextInt(40) - 20;
            int top = random.nextInt(40) - 20;
            int columns = 1 + random.nextInt(SIZE);
            int rows = 1 + random.nextInt(SIZE);
            pixels.begin(left, top, columns, rows);
            culler.begin();
            for (int pixel = 0; pixel < columns * rows; pixel++) {
                if (random.nextInt(4) > 0) {
                    pixels.set(pixel % columns, pixel / columns, 0.2 + 2.0 * random.nextDouble(), pixel);
                }
            }
            double[] box = new double[6];
            double half = 0.3 * random.nextDouble() * random.nextDouble();
            double along = 3.0 * random.nextDouble();
            for (int axis = 0; axis < 3; axis++) {
                double middle = ORIGIN[axis]
                        + along * grid.direction(left + random.nextInt(columns), top + random.nextInt(rows), axis)
                        + 0.2 * (random.nextDouble() - 0.5);
                box[axis] = middle - half;
                box[axis + 3] = middle + half * random.nextDouble();
            }
            boolean met = meets(box, left, top, columns, rows);
            boolean reached = culler.reaches(box, 0);
            assertThat(reached || !met).as("seed %d, box %d", seed, i).isTrue();
            seen += met ? 1 : 0;
            spared += reached ? 0 : 1;
            neither += reached && !met ? 1 : 0;
        }
        assertThat(seen).as("boxes that are seen, of 20,000").isGreaterThan(2_000);
        assertThat(spared).as("boxes left out").isGreaterThan(2_000);
        assertThat(neither).as("boxes looked into in vain").isLessThan(8_000);
    }

    private boolean meets(double[] box, int left, int top, int columns, int rows) {
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                double entry = 0.0;
                double exit = pixels.parameter(column, row);
                for (int axis = 0; axis < 3; axis++) {
                    double direction = grid.direction(left + column, top + row, axis);
                    double toLow = (box[axis] - ORIGIN[axis]) / direction;
                    double toHigh = (box[axis + 3] - ORIGIN[axis]) / direction;
                    entry = Math.max(entry, Math.min(toLow, toHigh));
                    exit = Math.min(exit, Math.max(toLow, toHigh));
                }
                if (entry < exit) {
                    return true;
                }
            }
        }
        return false;
    }

    /** A cube so far ahead of the eye, so much to the right (y) and up (z) of the line through the tile's middle. */
    private static double[] box(double ahead, double aside, double up, double edge) {
        double[] middle = {ORIGIN[0] + ahead, ORIGIN[1] + aside, ORIGIN[2] + up};
        double half = 0.5 * edge;
        return new double[] {
            middle[0] - half, middle[1] - half, middle[2] - half, middle[0] + half, middle[1] + half, middle[2] + half
        };
    }

    private static double[] vector(SplittableRandom random, double length) {
        return new double[] {
            length * (random.nextDouble() - 0.5),
            length * (random.nextDouble() - 0.5),
            length * (random.nextDouble() - 0.5)
        };
    }
}
