package org.dronewatch.analysis;

import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * A square grid of points, each at the same height above the highest surface below it, where drones are placed.
 *
 * @param east east coordinate of the centre, -100,000 to 100,000 m
 * @param north north coordinate of the centre, -100,000 to 100,000 m
 * @param side length of a side, above 0 and at most 100,000 m
 * @param cells number of points along a side, 2 to 2000
 * @param height height of the points above the highest surface below them, above 0 and at most 10,000 m
 */
public record CoverageGrid(
        @In(value = Quantity.LENGTH, from = -In.FARTHEST, to = In.FARTHEST) double east,
        @In(value = Quantity.LENGTH, from = -In.FARTHEST, to = In.FARTHEST) double north,
        @In(value = Quantity.LENGTH, above = 0, to = 100_000) double side,
        @In(value = Quantity.NUMBER, from = 2, to = 2000) int cells,
        @In(value = Quantity.LENGTH, above = 0, to = 10_000) double height) {
    /** Checks the limits. */
    public CoverageGrid {
        Limits.check(CoverageGrid.class, east, north, side, cells, height);
    }

    /** Length of a cell's side, m. */
    public double step() {
        return side / cells;
    }

    /** Area of a cell, m2. */
    public double cellArea() {
        return step() * step();
    }

    /** East coordinate of the centre of a column, counted from the west, m. */
    public double x(int column) {
        return east - 0.5 * side + (column + 0.5) * step();
    }

    /** North coordinate of the centre of a row, counted from the north, m. */
    public double y(int row) {
        return north + 0.5 * side - (row + 0.5) * step();
    }
}
