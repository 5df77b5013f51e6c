package org.dronewatch.terrain.io;

/**
 * A window of columns and rows of a grid.
 *
 * @param column the first column
 * @param row the first row
 * @param columns number of columns
 * @param rows number of rows
 */
public record Window(int column, int row, int columns, int rows) {
    /** The intersection with another window; without columns or rows if they do not overlap. */
    public Window and(Window other) {
        int west = Math.max(column, other.column);
        int north = Math.max(row, other.row);
        int east = Math.min(column + columns, other.column + other.columns);
        int south = Math.min(row + rows, other.row + other.rows);
        return new Window(west, north, Math.max(0, east - west), Math.max(0, south - north));
    }

    /** Whether this window has no columns or no rows. */
    public boolean isEmpty() {
        return columns == 0 || rows == 0;
    }

    /** This window moved by a number of columns and rows. */
    public Window moved(int byColumns, int byRows) {
        return new Window(column + byColumns, row + byRows, columns, rows);
    }

    /** The number of posts in this window. */
    public long posts() {
        return (long) columns * rows;
    }
}
