package org.dronewatch.route;

import java.util.Arrays;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.geometry.Position;

/**
 * Where points lie between the centres of the cells of a detection field, in coordinates of the field: a point at the
 * centre of a cell has the numbers of its column, row and height. The ground is interpolated between the centres of the
 * columns; columns without ground are given its mean height. Points outside count as those at the edge. Immutable and
 * thread-safe.
 */
final class FieldCells {
    /** The shortest part of a leg, as a fraction of it: rounding errors at the boundaries of parts are smaller. */
    private static final double SHORTEST = 1e-9;

    /** Points as near to the centre of a cell as this count as at the centre, in cells. */
    private static final double NEAR = 1e-9;

    private final FieldGrid grid;
    private final double[] heights;

    /** By row and column, m. */
    private final double[] ground;

    FieldCells(DetectionField field) {
        this.grid = field.grid();
        this.heights = grid.heights().stream().mapToDouble(Double::doubleValue).toArray();
        int side = grid.columns();
        double[] known = new double[side * side];
        Arrays.setAll(known, cell -> field.ground(cell % side, cell / side));
        double mean = Arrays.stream(known).filter(Double::isFinite).average().orElse(0.0);
        this.ground = Arrays.stream(known)
                .map(height -> Double.isNaN(height) ? mean : height)
                .toArray();
    }

    /** The column at an east coordinate, m; a fraction between two centres. */
    double column(double x) {
        return snapped((x - grid.x(0)) / grid.cell(), grid.columns());
    }

    /** The row at a north coordinate, m. */
    double row(double y) {
        return snapped((grid.y(0) - y) / grid.cell(), grid.columns());
    }

    private static double snapped(double index, int count) {
        double inside = Math.max(0.0, Math.min(count - 1.0, index));
        double whole = Math.rint(inside);
        return Math.abs(inside - whole) < NEAR ? whole : inside;
    }

    /** The height of the ground at a column and a row, m. */
    private double ground(double column, double row) {
        int west = lower(column, grid.columns());
        int north = lower(row, grid.columns());
        int east = Math.min(west + 1, grid.columns() - 1);
        int south = Math.min(north + 1, grid.columns() - 1);
        double u = column - west;
        double v = row - north;
        return (1.0 - v) * ((1.0 - u) * ground(west, north) + u * ground(east, north))
                + v * ((1.0 - u) * ground(west, south) + u * ground(east, south));
    }

    /** The height of the ground at the centre of a column, m. */
    double ground(int column, int row) {
        return ground[row * grid.columns() + column];
    }

    /** The number of the height at a column, a row and a height in the world, m. */
    double level(double column, double row, double z) {
        return level(z - ground(column, row));
    }

    /** The number of a height above the ground, m. */
    private double level(double above) {
        int low = 0;
        while (low < heights.length - 2 && above >= heights[low + 1]) {
            low++;
        }
        double gap = low + 1 < heights.length ? heights[low + 1] - heights[low] : 1.0;
        return snapped(low + (above - heights[low]) / gap, heights.length);
    }

    /** The number of the last of several centres that is not beyond a point and is followed by another one. */
    static int lower(double at, int count) {
        return Math.max(0, Math.min(count - 2, (int) at));
    }

    /** The first and the last column of cells that may contribute to what is interpolated at a point of a box. */
    int[] columns(Position low, Position high) {
        return new int[] {(int) column(low.x()), (int) Math.ceil(column(high.x()))};
    }

    /** The first and the last row of such cells. */
    int[] rows(Position low, Position high) {
        return new int[] {(int) row(high.y()), (int) Math.ceil(row(low.y()))};
    }

    /** The numbers of the lowest and the highest height of such cells. */
    int[] levels(Position low, Position high) {
        int[] columns = columns(low, high);
        int[] rows = rows(low, high);
        double lowest = Double.POSITIVE_INFINITY;
        double highest = Double.NEGATIVE_INFINITY;
        for (int row = rows[0]; row <= rows[1]; row++) {
            for (int column = columns[0]; column <= columns[1]; column++) {
                lowest = Math.min(lowest, ground(column, row));
                highest = Math.max(highest, ground(column, row));
            }
        }
        return new int[] {(int) level(low.z() - highest), (int) Math.ceil(level(high.z() - lowest))};
    }

    /** The number of columns. */
    int columns() {
        return grid.columns();
    }

    /** The number of rows. */
    int rows() {
        return grid.columns();
    }

    /** The number of heights. */
    int levels() {
        return heights.length;
    }

    /**
     * Where a straight leg leaves the cuboid between the centres of eight cells in which it is.
     *
     * @param after fraction of the leg after which it leaves
     * @return a greater fraction, 1 at the end of the leg
     */
    double leaves(Position from, Position to, double after) {
        double inside = after + SHORTEST;
        double dx = (to.x() - from.x()) / grid.cell();
        double dy = (from.y() - to.y()) / grid.cell();
        double x = (from.x() - grid.x(0)) / grid.cell();
        double y = (grid.y(0) - from.y()) / grid.cell();
        double next = Math.min(1.0, Math.min(crossing(x, dx, inside), crossing(y, dy, inside)));
        return heights.length == 1 ? next : climbs(from, to, after, next);
    }

    /** Where a coordinate, in cells from the centre of the first cell, next reaches the centre of a cell. */
    private static double crossing(double begin, double change, double inside) {
        if (change == 0.0) {
            return Double.POSITIVE_INFINITY;
        }
        double at = begin + inside * change;
        double middle = change > 0.0 ? Math.floor(at) + 1.0 : Math.ceil(at) - 1.0;
        return Math.max(inside, (middle - begin) / change);
    }

    /**
     * Where a part of a leg first reaches one of the heights; the end of the part if it reaches none. Since the ground
     * is bilinear between four centres, the height above it is a quadratic function along the leg.
     */
    private double climbs(Position from, Position to, double begin, double end) {
        double first = above(from, to, begin);
        double middle = above(from, to, 0.5 * (begin + end));
        double last = above(from, to, end);
        double square = 2.0 * (first - 2.0 * middle + last);
        double slope = last - first - square;
        double earliest = 1.0;
        double shortest = SHORTEST / (end - begin);
        for (double height : heights) {
            earliest = Math.min(earliest, root(square, slope, first - height, shortest));
        }
        return begin + earliest * (end - begin);
    }

    private double above(Position from, Position to, double share) {
        double x = from.x() + share * (to.x() - from.x());
        double y = from.y() + share * (to.y() - from.y());
        return from.z() + share * (to.z() - from.z()) - ground(column(x), row(y));
    }

    /** The least root of a quadratic equation that is not below a limit; 1 if it has none up to 1. */
    private static double root(double square, double slope, double constant, double limit) {
        double discriminant = slope * slope - 4.0 * square * constant;
        if (!(discriminant >= 0.0)) {
            return 1.0;
        }
        double sum = -0.5 * (slope + Math.copySign(Math.sqrt(discriminant), slope));
        double one = sum / square;
        double other = constant / sum;
        double least = 1.0;
        least = one >= limit && one < least ? one : least;
        return other >= limit && other < least ? other : least;
    }

    /** East coordinate of the centre of a column, m. */
    double x(int column) {
        return grid.x(column);
    }

    /** North coordinate of the centre of a row, m. */
    double y(int row) {
        return grid.y(row);
    }

    /** Height of the centre of a cell, m. */
    double z(int level, int column, int row) {
        return ground(column, row) + heights[level];
    }
}
