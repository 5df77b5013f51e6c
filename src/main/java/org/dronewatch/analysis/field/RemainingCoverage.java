package org.dronewatch.analysis.field;

/**
 * What remains of the coverage at one height if some sensors fail.
 *
 * @param all the coverage with all sensors
 * @param rest the coverage without some of them, as {@link FieldCoverage#without} gives it
 * @param height its number in the grid
 * @param known the cells that are known with all sensors
 * @param covered those that are covered with all sensors
 * @param remaining the cells that are covered without some of them
 */
public record RemainingCoverage(
        FieldCoverage all, FieldCoverage rest, int height, int known, int covered, int remaining) {
    /** Counts the cells of a height, given by its number. */
    public static RemainingCoverage of(FieldCoverage all, FieldCoverage rest, int height) {
        FieldGrid grid = all.field().grid();
        int known = 0;
        int covered = 0;
        int remaining = 0;
        for (int cell = 0; cell < grid.cells(); cell++) {
            int column = cell % grid.columns();
            int row = cell / grid.columns();
            known += all.isKnown(height, column, row) ? 1 : 0;
            covered += all.isCovered(height, column, row) ? 1 : 0;
            remaining += rest.isCovered(height, column, row) ? 1 : 0;
        }
        return new RemainingCoverage(all, rest, height, known, covered, remaining);
    }

    /** Whether a cell is covered with all sensors, but not by the rest of them. */
    public boolean isLost(int column, int row) {
        return all.isCovered(height, column, row) && !rest.isCovered(height, column, row);
    }

    /**
     * By how much fewer cells are covered; below 0 is possible for the best course, since another one may count without
     * a sensor.
     */
    public int lost() {
        return covered - remaining;
    }
}
