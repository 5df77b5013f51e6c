package org.dronewatch.buildings.land;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.function.BiPredicate;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Areas, lines and coasts in a raster against the definition of each, cell by cell. */
class LandPainterTest {
    private static final double HALF = 40.0;

    /** Every cell has the class exactly if its centre is inside. */
    private static void isPainted(LandPainter painter, BiPredicate<Double, Double> isInside, String what) {
        LandRaster raster = painter.cover();
        int inside = 0;
        for (int row = 0; row < raster.side(); row++) {
            for (int column = 0; column < raster.side(); column++) {
                double x = (column + 0.5) * raster.cell() - raster.half();
                double y = (row + 0.5) * raster.cell() - raster.half();
                boolean expected = isInside.test(x, y);
                inside += expected ? 1 : 0;
                assertThat(raster.at(x, y) == LandClass.WATER)
                        .as("%s at %.1f, %.1f", what, x, y)
                        .isEqualTo(expected);
            }
        }
        assertThat(inside).as(what).isBetween(1, raster.side() * raster.side() - 1);
    }

    private static double[] star(Random random, double x, double y, double most) {
        int corners = 3 + random.nextInt(9);
        double[] ring = new double[2 * corners];
        for (int i = 0; i < corners; i++) {
            double radius = most * (0.2 + 0.8 * random.nextDouble());
            ring[2 * i] = x + radius * Math.cos(2.0 * Math.PI * i / corners);
            ring[2 * i + 1] = y + radius * Math.sin(2.0 * Math.PI * i / corners);
        }
        return ring;
    }

    /** Areas with courtyards, islands in them, and parts outside of the raster, against the shapes of the JDK. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void anAreaHasTheCellsWhoseCentresItContains(long seed) {
        Random random = new Random(seed);
        List<double[]> rings = new ArrayList<>();
        Path2D path = new Path2D.Double(Path2D.WIND_EVEN_ODD);
        for (int i = 0; i < 1 + seed; i++) {
            double[] ring = star(random, 60 * random.nextDouble() - 30, 60 * random.nextDouble() - 30, 50);
            rings.add(ring);
            path.moveTo(ring[0], ring[1]);
            for (int k = 2; k < ring.length; k += 2) {
                path.lineTo(ring[k], ring[k + 1]);
            }
            path.closePath();
        }
        LandPainter painter = new LandPainter(HALF);
        painter.fill(rings, LandClass.WATER);

        isPainted(painter, path::contains, "seed " + seed);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void aLineHasTheCellsWhoseCentresAreWithinHalfItsWidth(long seed) {
        Random random = new Random(seed);
        double[] line = new double[8];
        for (int i = 0; i < line.length; i++) {
            line[i] = 120 * random.nextDouble() - 60;
        }
        // Level and upright pieces, and one without a length.
        line[3] = seed == 1 ? line[1] : line[3];
        line[4] = seed == 2 ? line[2] : line[4];
        line[6] = seed == 3 ? line[4] : line[6];
        line[7] = seed == 3 ? line[5] : line[7];
        double width = 1.0 + 9.0 * random.nextDouble();
        LandPainter painter = new LandPainter(HALF);
        painter.stroke(line, width, LandClass.WATER);

        isPainted(painter, (x, y) -> distance(line, x, y) < 0.5 * width, "seed " + seed);
    }

    private static double distance(double[] line, double x, double y) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i + 3 < line.length; i += 2) {
            least = Math.min(least, Line2D.ptSegDist(line[i], line[i + 1], line[i + 2], line[i + 3], x, y));
        }
        return least;
    }

    /** A path of 30 cm across cells of 1 m: without gaps, and no wider than a cell. */
    @Test
    void aNarrowLineIsAsWideAsACell() {
        LandPainter painter = new LandPainter(HALF);
        painter.stroke(new double[] {-100, -70, 100, 70}, 0.3, LandClass.ROAD);
        LandRaster raster = painter.cover();
        for (int column = 0; column < 80; column++) {
            double x = column - 39.5;
            int cells = 0;
            for (int row = 0; row < 80; row++) {
                cells += raster.at(x, row - 39.5) == LandClass.ROAD ? 1 : 0;
            }
            assertThat(cells).as("x = %.1f", x).isBetween(1, 2);
        }
    }

    /** An island and a bay in it: right of the line is the sea, wherever the ring begins. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void theSeaLiesOnTheRightOfTheCoast(long seed) {
        Random random = new Random(seed);
        double[] island = star(random, 20 * random.nextDouble() - 10, 20 * random.nextDouble() - 10, 38);
        Path2D land = new Path2D.Double();
        land.moveTo(island[0], island[1]);
        for (int i = 2; i < island.length; i += 2) {
            land.lineTo(island[i], island[i + 1]);
        }
        land.closePath();
        double[] coast = new double[island.length + 2];
        System.arraycopy(island, 0, coast, 0, island.length);
        System.arraycopy(island, 0, coast, island.length, 2);

        // In two ways of OpenStreetMap, of which the second comes first.
        int half = 2 * (coast.length / 4);
        double[] first = Arrays.copyOfRange(coast, 0, half + 2);
        double[] second = Arrays.copyOfRange(coast, half, coast.length);
        LandPainter painter = new LandPainter(HALF);
        new Coast(List.of(second, first)).paint(painter, LandClass.WATER);

        isPainted(painter, (x, y) -> !land.contains(x, y), "seed " + seed);
    }

    /** Open coasts far from the area, in it, and with ends in it: as the side of the nearest piece says. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void quartersHaveTheSideOfTheNearestPiece(long seed) {
        Random random = new Random(seed);
        double[] line = new double[40];
        for (int i = 0; i < line.length; i += 2) {
            line[i] = 8.0 * i - 160.0;
            line[i + 1] = 30.0 * random.nextDouble() - 15.0;
        }
        Coast coast = new Coast(List.of(line));
        LandPainter painter = new LandPainter(HALF);
        coast.paint(painter, LandClass.WATER);

        isPainted(painter, coast::isSea, "seed " + seed);
        LandPainter inland = new LandPainter(HALF);
        new Coast(List.of(new double[] {500, -500, 500, 500})).paint(inland, LandClass.WATER);
        LandPainter offshore = new LandPainter(HALF);
        new Coast(List.of(new double[] {500, 500, 500, -500})).paint(offshore, LandClass.WATER);
        assertThat(inland.cover().isAnywhere()).isFalse();
        assertThat(offshore.cover().areas()[LandClass.WATER.code()]).isCloseTo(6400.0, within(1e-6));
    }

    @Test
    void withoutACoastThereIsNoSea() {
        LandPainter painter = new LandPainter(HALF);
        new Coast(List.of()).paint(painter, LandClass.WATER);
        new Coast(List.of(new double[] {1, 1}, new double[0], new double[] {2, 2, 2, 2}))
                .paint(painter, LandClass.WATER);
        painter.fill(List.of(), LandClass.ROCK);
        painter.fill(List.of(new double[0], new double[] {1, 1}, new double[] {3, 3, 9, 3}), LandClass.ROCK);
        painter.fill(List.of(new double[] {1e9, 1e9, 2e9, 1e9, 2e9, 2e9}), LandClass.ROCK);
        painter.stroke(new double[] {3, 3}, 5.0, LandClass.ROCK);
        painter.stroke(new double[] {1e9, 3, 1e9, 7}, 5.0, LandClass.ROCK);
        assertThat(painter.cover().isAnywhere()).isFalse();
    }

    @Test
    void largeSquaresHaveLargerCells() {
        LandPainter painter = new LandPainter(20_000);
        assertThat(painter.side()).isEqualTo(LandPainter.MOST_CELLS);
        assertThat(painter.cell()).isCloseTo(40_000.0 / 8192, within(1e-9));
    }

    @Test
    void runsAreTheRaster() {
        LandPainter painter = new LandPainter(HALF);
        painter.stroke(new double[] {-30, -20, 30, 25}, 3.0, LandClass.ROAD);
        LandRaster raster = painter.cover();
        assertThat(LandRaster.ofRuns(HALF, 80, raster.runs()))
                .usingRecursiveComparison()
                .isEqualTo(raster);
        assertThat(raster.at(40.0, 0.0)).isEqualTo(LandClass.NONE);
        assertThat(raster.at(Double.NaN, 0.0)).isEqualTo(LandClass.NONE);
        for (int[] wrong : new int[][] {{6401, 0}, {-1, 0}, {6400, 300}, {6400, 99}, {6400, -1}}) {
            assertThatThrownBy(() -> LandRaster.ofRuns(HALF, 80, wrong)).isInstanceOf(IllegalArgumentException.class);
        }
        assertThatThrownBy(() -> LandRaster.ofRuns(HALF, 1 << 30, new int[0]))
                .isInstanceOf(IllegalArgumentException.class);
    }
}
