package org.dronewatch.models;

/**
 * Heights on a square grid, metres. Column 0 is the western edge, row 0 the southern edge, and the plan origin is in
 * the middle.
 */
final class HeightGrid {

    private final int side;
    private final double spacing;
    private final double[] heights;

    HeightGrid(int side, double spacing) {
        this.side = side;
        this.spacing = spacing;
        this.heights = new double[side * side];
    }

    int side() {
        return side;
    }

    double spacing() {
        return spacing;
    }

    int index(int column, int row) {
        return row * side + column;
    }

    double get(int index) {
        return heights[index];
    }

    double get(int column, int row) {
        return heights[index(column, row)];
    }

    void set(int index, double height) {
        heights[index] = height;
    }

    /** Metres east (for a column) or north (for a row) of the plan origin. */
    double coordinate(int columnOrRow) {
        return (columnOrRow - (side - 1) / 2.0) * spacing;
    }

    boolean isRim(int index) {
        int column = index % side;
        int row = index / side;
        return column == 0 || row == 0 || column == side - 1 || row == side - 1;
    }

    double[] copyOfHeights() {
        return heights.clone();
    }

    /** The middle of this grid without a margin of some cells on each edge. */
    HeightGrid cropped(int margin) {
        HeightGrid inner = new HeightGrid(side - 2 * margin, spacing);
        for (int row = 0; row < inner.side; row++) {
            for (int column = 0; column < inner.side; column++) {
                inner.set(inner.index(column, row), get(column + margin, row + margin));
            }
        }
        return inner;
    }
}
