package org.dronewatch.analysis.layer;

import org.dronewatch.analysis.cell.CellCode;

/**
 * The assessments of one sensor at one height of all columns, and where exactly these were made.
 *
 * @param columns number of cells in a row
 * @param z heights at which the drone was assessed, row by row, m; NaN in cells in which it cannot be
 * @param entries by row and column, as in {@link SensorLayer}
 * @param byCourse by row, as in {@link SensorLayer}
 */
@SuppressWarnings("ArrayRecordComponent")
record LayerSlice(int columns, double[] z, int[][] entries, byte[][] byCourse) {
    /** Whether the drone was assessed in a cell at this very height, m. */
    boolean holds(int column, int row, double height) {
        return Double.doubleToLongBits(z[row * columns + column]) == Double.doubleToLongBits(height);
    }

    /**
     * Checks everything by which a file that was not written by this program could mislead.
     *
     * @param courses their number
     * @throws IllegalArgumentException when something cannot be right
     */
    void check(int expectedColumns, int expectedRows, int courses) {
        boolean isShaped = columns == expectedColumns
                && entries.length == expectedRows
                && byCourse.length == expectedRows
                && z.length == expectedColumns * expectedRows;
        if (!isShaped) {
            throw new IllegalArgumentException("a slice of another shape");
        }
        for (int row = 0; row < expectedRows; row++) {
            if (entries[row].length != columns) {
                throw new IllegalArgumentException("a row of another length");
            }
            for (int entry : entries[row]) {
                if (!isPossible(entry, byCourse[row], courses)) {
                    throw new IllegalArgumentException("an impossible entry");
                }
            }
        }
    }

    /** Whether an entry, and what it points to, can be those of a cell on a number of courses. */
    private static boolean isPossible(int entry, byte[] pool, int courses) {
        return entry >= 0 ? CellCode.isPossible(entry) : CourseCodes.isPossible(pool, -1L - entry, courses);
    }
}
