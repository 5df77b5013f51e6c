package org.dronewatch.analysis.field;

import java.util.Arrays;
import java.util.function.IntConsumer;
import org.dronewatch.analysis.cell.FieldGrid;

/**
 * For each column, the lowest height above the ground that any sensor covers: the lowest covered height of the grid,
 * refined by bisection between that height and the next lower one or the ground. Below that interval, and between two
 * covered heights, the column is not searched. Immutable.
 */
public final class DetectableHeights {
    /** The accuracy of the heights, m. */
    public static final double ACCURACY = 0.5;

    private final FieldGrid grid;
    private final int columns;

    /** By row and column, m: the height is above the lower and not above the upper one; NaN where nothing covers. */
    private final double[] lower;

    private final double[] upper;

    /** The largest uncovered interval between two covered heights, m; 0 for none. */
    private final double[] gaps;

    private DetectableHeights(FieldGrid grid, int columns) {
        this.grid = grid;
        this.columns = columns;
        this.lower = new double[grid.cells()];
        this.upper = new double[grid.cells()];
        this.gaps = new double[grid.cells()];
    }

    /**
     * Refines the heights of a coverage, on the {@link org.dronewatch.parallel.Workers} of the calling thread; the
     * result does not depend on their number.
     *
     * @param progress receives the number of cells that a sensor has looked at since the last call; from any thread
     */
    public static DetectableHeights of(FieldCoverage coverage, IntConsumer progress) {
        FieldGrid grid = coverage.field().grid();
        DetectableHeights heights = new DetectableHeights(grid, coverage.field().columnsWithGround());
        for (int cell = 0; cell < grid.cells(); cell++) {
            heights.begin(coverage, cell);
        }
        for (int round = 0; round < rounds(grid); round++) {
            heights.halve(coverage, "round " + round, progress);
        }
        return heights;
    }

    /** The number of steps of the bisection: in each, the columns are assessed once more. */
    public static int rounds(FieldGrid grid) {
        double widest = 0.0;
        double below = 0.0;
        for (double height : grid.heights()) {
            widest = Math.max(widest, height - below);
            below = height;
        }
        int rounds = 0;
        for (double width = widest; width > ACCURACY; width *= 0.5) {
            rounds++;
        }
        return rounds;
    }

    /** Begins with what is known at the heights of the grid. */
    private void begin(FieldCoverage coverage, int cell) {
        lower[cell] = 0.0;
        upper[cell] = Double.NaN;
        double lastCovered = Double.NaN;
        boolean wasBare = false;
        for (int i = 0; i < grid.heights().size(); i++) {
            double height = grid.heights().get(i);
            if (coverage.isCovered(i, grid.column(cell), grid.row(cell))) {
                upper[cell] = Double.isNaN(upper[cell]) ? height : upper[cell];
                gaps[cell] = wasBare ? Math.max(gaps[cell], height - lastCovered) : gaps[cell];
                lastCovered = height;
                wasBare = false;
            } else {
                lower[cell] = Double.isNaN(upper[cell]) ? height : lower[cell];
                wasBare = !Double.isNaN(upper[cell]);
            }
        }
    }

    private void halve(FieldCoverage coverage, String name, IntConsumer progress) {
        double[] middle = new double[grid.cells()];
        for (int cell = 0; cell < middle.length; cell++) {
            boolean isWide = upper[cell] - lower[cell] > ACCURACY;
            middle[cell] = isWide ? 0.5 * (lower[cell] + upper[cell]) : Double.NaN;
        }
        FieldCoverage there = coverage.at(middle, name, progress);
        for (int cell = 0; cell < middle.length; cell++) {
            if (there.isCovered(0, grid.column(cell), grid.row(cell))) {
                upper[cell] = middle[cell];
            } else if (!Double.isNaN(middle[cell])) {
                lower[cell] = middle[cell];
            }
        }
    }

    /** The grid. */
    public FieldGrid grid() {
        return grid;
    }

    /**
     * The lowest covered height above the ground, m, too high by at most {@link #ACCURACY}; NaN where there is none.
     */
    public double height(int column, int row) {
        return upper[grid.cell(column, row)];
    }

    /**
     * The largest gap in a column, m: the difference between two covered heights of the grid that have one or more
     * heights between them, none of them covered; 0 where there is no such gap, although the column may be uncovered
     * above or below its covered heights.
     */
    public double coveredAgainGap(int column, int row) {
        return gaps[grid.cell(column, row)];
    }

    /** The largest {@linkplain #coveredAgainGap gap between covered heights} in any column, m; 0 if there is none. */
    public double largestGap() {
        return Arrays.stream(gaps).max().orElse(0.0);
    }

    /** The number of columns that have a {@linkplain #coveredAgainGap gap between covered heights}. */
    public int coveredAgain() {
        return (int) Arrays.stream(gaps).filter(gap -> gap > 0.0).count();
    }

    /** The number of columns with ground below them. */
    public int columns() {
        return columns;
    }

    /** The number of columns whose lowest covered height is at most a given height, m. */
    public int count(double height) {
        return (int) Arrays.stream(upper).filter(its -> its <= height).count();
    }
}
