package org.dronewatch.terrain.io;

/**
 * Where the posts of a grid are on the map: the post of column 0 and row 0, and the steps from column to column and
 * from row to row, all in the units of the map.
 *
 * @param x of the first post, to the east
 * @param y of the first post, to the north
 * @param columnX how far to the east the next column is
 * @param columnY how far to the north the next column is
 * @param rowX how far to the east the next row is
 * @param rowY how far to the north the next row is
 */
public record Lattice(double x, double y, double columnX, double columnY, double rowX, double rowY) {
    /** East of a place in the grid. */
    public double xAt(double column, double row) {
        return x + column * columnX + row * rowX;
    }

    /** North of a place in the grid. */
    public double yAt(double column, double row) {
        return y + column * columnY + row * rowY;
    }

    /** The column, not a whole number as a rule, of a point of the map. */
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

    /** The same posts counted from another one. */
    public Lattice from(int column, int row) {
        return new Lattice(xAt(column, row), yAt(column, row), columnX, columnY, rowX, rowY);
    }
}
