package org.dronewatch.analysis.survey;

import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.FieldCoverage;

/**
 * What remains of the coverage at one height if some sensors fail.
 *
 * @param all the coverage with all sensors
 * @param rest the coverage without the sensors that fail, as {@link FieldCoverage#without} gives it
 * @param height number of the height in the grid
 * @param known the number of cells that are known with all sensors
 * @param covered the number of cells that are covered with all sensors
 * @param remaining the number of cells that are still covered without the sensors that fail
 * @param gone the number of cells that are covered with all sensors, but no longer without those that fail
 */
public record RemainingCoverage(
        FieldCoverage all, FieldCoverage rest, int height, int known, int covered, int remaining, int gone) {
    /** Counts the cells of a height, given by its number. */
    public static RemainingCoverage of(FieldCoverage all, FieldCoverage rest, int height) {
        FieldGrid grid = all.field().grid();
        int known = grid.count((column, row) -> all.isKnown(height, column, row));
        int covered = grid.count((column, row) -> all.isCovered(height, column, row));
        int remaining = grid.count((column, row) -> rest.isCovered(height, column, row));
        int gone =
                grid.count((column, row) -> all.isCovered(height, column, row) && !rest.isCovered(height, column, row));
        return new RemainingCoverage(all, rest, height, known, covered, remaining, gone);
    }

    /** Whether a cell is covered with all sensors, but no longer by the remaining ones. */
    public boolean isLost(int column, int row) {
        return all.isCovered(height, column, row) && !rest.isCovered(height, column, row);
    }

    /** How many fewer cells are covered: {@link #gone} less {@link #gained}; below 0 if more cells are gained. */
    public int lost() {
        return covered - remaining;
    }

    /**
     * The number of cells that are covered by the remaining sensors, but not with all sensors: without those that
     * fail, another course may count, on which the remaining sensors cover the cell.
     */
    public int gained() {
        return remaining - (covered - gone);
    }
}
