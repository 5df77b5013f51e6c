package org.dronewatch.terrain.io;

/**
 * The positions of a grid's posts on the map: the post of column 0 and row 0, and the steps from column to column and
 * from row to row, all in the units of the map.
 *
 * @param x east coordinate of the first post
 * @param y north coordinate of the first post
 * @param columnX eastward component of the step to the next column
 * @param columnY northward component of the step to the next column
 * @param rowX eastward component of the step to the next row
 * @param rowY northward component of the step to the next row
 */
public record Lattice(double x, double y, double columnX, double columnY, double rowX, double rowY) {
    /** The east coordinate of a point of the grid. */
    public double xAt(double column, double row) {
        return x + column * columnX + row * rowX;
    }

    /** The north coordinate of a point of the grid. */
    public double yAt(double column, double row) {
        return y + column * columnY + row * rowY;
    }

    /** The column, in general not a whole number, of a point of the map. */
    public double columnAt(double mapX, double mapY) {
        return ((mapX - x) * rowY - (mapY - y) * rowX) / cross();
    }

    /** The row of a point of the map. */
    public double rowAt(double mapX, double mapY) {
        return ((mapY - y) * columnX - (mapX - x) * columnY) / cross();
    }

    private double cross() {
        return columnX * rowY - columnY * rowX;
    }

    /** Whether the steps are finite and span an area. */
    boolean isUsable() {
        return Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(cross()) && cross() != 0.0;
    }

    /** This lattice with another post as column 0 and row 0. */
    public Lattice from(int column, int row) {
        return new Lattice(xAt(column, row), yAt(column, row), columnX, columnY, rowX, rowY);
    }
}
