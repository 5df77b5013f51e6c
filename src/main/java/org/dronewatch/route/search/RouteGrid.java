package org.dronewatch.route.search;

import java.util.Arrays;
import java.util.BitSet;
import org.dronewatch.geometry.Position;

/**
 * The nodes of a route search: a square raster with a node at each of several heights above the ground. Nodes are
 * numbered by level, then by row from the south, then by column from the west. Immutable.
 */
public final class RouteGrid {
    private final double west;
    private final double south;
    private final double spacing;
    private final int columns;
    private final int rows;
    private final double[] heights;
    private final double[] ground;
    private final BitSet blocked;

    /**
     * A grid over ground.
     *
     * @param west east coordinate of the first column, m
     * @param south north coordinate of the first row, m
     * @param spacing distance between neighbouring nodes, above 0, m
     * @param columns number of columns, 2 or more
     * @param rows number of rows, 2 or more
     * @param heights heights of the levels above the ground, ascending, m
     * @param ground height of the ground in each column of the first row, then of the second, and so on, m
     * @param blocked the nodes at which a drone cannot be
     * @throws IllegalArgumentException if a value is out of range
     */
    public RouteGrid(
            double west,
            double south,
            double spacing,
            int columns,
            int rows,
            double[] heights,
            double[] ground,
            BitSet blocked) {
        if (!(spacing > 0.0) || columns < 2 || rows < 2 || heights.length < 1 || ground.length != columns * rows) {
            throw new IllegalArgumentException(columns + " columns, " + rows + " rows and " + heights.length
                    + " heights, " + spacing + " m apart, over " + ground.length
                    + " values: there must be at least 2, 2"
                    + " and 1, more than 0 m apart, and a height of the ground for each column of each row");
        }
        if ((long) columns * rows * heights.length > Integer.MAX_VALUE) {
            throw new IllegalArgumentException(
                    (long) columns * rows * heights.length + " nodes: there must be at most " + Integer.MAX_VALUE);
        }
        this.west = west;
        this.south = south;
        this.spacing = spacing;
        this.columns = columns;
        this.rows = rows;
        this.heights = heights.clone();
        this.ground = ground.clone();
        this.blocked = (BitSet) blocked.clone();
    }

    /** A grid over level ground at height 0, where a drone can be anywhere. */
    public static RouteGrid level(double west, double south, double spacing, int columns, int rows, double... heights) {
        return new RouteGrid(west, south, spacing, columns, rows, heights, new double[columns * rows], new BitSet());
    }

    /** The number of nodes. */
    public int size() {
        return columns * rows * heights.length;
    }

    /**
     * The number of a node; columns are counted from the west, rows from the south and levels from the lowest, each
     * from 0.
     */
    public int node(int column, int row, int level) {
        return (level * rows + row) * columns + column;
    }

    /**
     * The nearest node at the level that is nearest in height above the ground; for a point outside the grid, a node at
     * its edge.
     */
    public int nearest(Position at) {
        double column = clamp((at.x() - west) / spacing, columns);
        double row = clamp((at.y() - south) / spacing, rows);
        return nearest(column, row, at.z() - ground(column, row));
    }

    private int nearest(double column, double row, double above) {
        int level = 0;
        for (int i = 1; i < heights.length; i++) {
            level = Math.abs(heights[i] - above) < Math.abs(heights[level] - above) ? i : level;
        }
        return node((int) Math.rint(column), (int) Math.rint(row), level);
    }

    private static double clamp(double index, int count) {
        return Math.max(0.0, Math.min(count - 1.0, index));
    }

    /** The number of columns. */
    public int columns() {
        return columns;
    }

    /** The number of rows. */
    public int rows() {
        return rows;
    }

    /** The number of levels. */
    public int levels() {
        return heights.length;
    }

    /** Distance between neighbouring nodes, m. */
    public double spacing() {
        return spacing;
    }

    /** Height of a level above the ground, m. */
    public double height(int level) {
        return heights[level];
    }

    /** East coordinate of a node, m. */
    public double x(int node) {
        return west + node % columns * spacing;
    }

    /** North coordinate of a node, m. */
    public double y(int node) {
        return south + node / columns % rows * spacing;
    }

    /** Height coordinate of a node in the world, m. */
    public double z(int node) {
        return ground[node % (columns * rows)] + heights[node / (columns * rows)];
    }

    /** The height of a point above the ground, m; the ground outside the grid has the height of its edge. */
    public double above(Position at) {
        return at.z() - ground(clamp((at.x() - west) / spacing, columns), clamp((at.y() - south) / spacing, rows));
    }

    /** The position of a node, m. */
    public Position position(int node) {
        return new Position(x(node), y(node), z(node));
    }

    /** Whether a drone can be at a node. */
    public boolean isOpen(int node) {
        return !blocked.get(node);
    }

    /**
     * Whether a drone can be at a point: inside the raster, between the lowest and the highest level, with an open node
     * nearest to it.
     */
    boolean isOpen(double x, double y, double z) {
        double column = (x - west) / spacing;
        double row = (y - south) / spacing;
        if (!(column >= 0.0 && row >= 0.0 && column <= columns - 1 && row <= rows - 1)) {
            return false;
        }
        double above = z - ground(column, row);
        double tolerance = 1e-9 * (1.0 + Math.abs(z));
        return above >= heights[0] - tolerance
                && above <= heights[heights.length - 1] + tolerance
                && isOpen(nearest(column, row, above));
    }

    /** The ground between four nodes, interpolated, m. */
    private double ground(double column, double row) {
        int left = Math.min((int) column, columns - 2);
        int below = Math.min((int) row, rows - 2);
        double u = column - left;
        double v = row - below;
        int at = below * columns + left;
        return (1.0 - v) * ((1.0 - u) * ground[at] + u * ground[at + 1])
                + v * ((1.0 - u) * ground[at + columns] + u * ground[at + columns + 1]);
    }

    /**
     * The greatest slope of the ground between the four nodes of a square whose south-western node is in the given
     * column and row, 0 or more.
     */
    double slope(int column, int row) {
        int at = row * columns + column;
        double east = Math.max(
                Math.abs(ground[at + 1] - ground[at]), Math.abs(ground[at + columns + 1] - ground[at + columns]));
        double north = Math.max(
                Math.abs(ground[at + columns] - ground[at]), Math.abs(ground[at + columns + 1] - ground[at + 1]));
        return Math.sqrt(east * east + north * north) / spacing;
    }

    /**
     * The least and the greatest height of the ground, m, in this order, at the four corners of a square of the raster
     * whose south-western corner is in the given column and row.
     */
    public double[] groundRange(int column, int row) {
        int at = row * columns + column;
        double[] corners = {ground[at], ground[at + 1], ground[at + columns], ground[at + columns + 1]};
        Arrays.sort(corners);
        return new double[] {corners[0], corners[3]};
    }
}
