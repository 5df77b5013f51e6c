package org.dronewatch.placement;

import java.util.Arrays;

/**
 * What one candidate contributes: the rows of a {@link CandidateTable} that it reaches, in ascending order, with a
 * value for each. Immutable.
 */
public final class CandidateColumn {
    private final int[] rows;

    /** Null if all are 1: of a covered cell, nothing else is known. */
    private final double[] values;

    /**
     * A column.
     *
     * @param rows numbers of the rows, from 0, ascending
     * @param values a value for each row, 0 or more
     * @throws IllegalArgumentException when rows do not ascend, or a value is below 0 or not finite
     */
    public CandidateColumn(int[] rows, double[] values) {
        if (rows.length != values.length) {
            throw new IllegalArgumentException(rows.length + " rows, but " + values.length + " values");
        }
        for (double value : values) {
            if (!(value >= 0.0) || Double.isInfinite(value)) {
                throw new IllegalArgumentException("value " + value + ": must be 0 or more");
            }
        }
        this.rows = checked(rows);
        this.values = values.clone();
    }

    /**
     * A column with the value 1 in each of its rows.
     *
     * @param rows numbers of the rows, from 0, ascending
     * @throws IllegalArgumentException when rows do not ascend
     */
    public CandidateColumn(int[] rows) {
        this.rows = checked(rows);
        this.values = null;
    }

    private static int[] checked(int[] rows) {
        for (int at = 0; at < rows.length; at++) {
            if (rows[at] < 0 || at > 0 && rows[at] <= rows[at - 1]) {
                throw new IllegalArgumentException(
                        "row " + rows[at] + ": rows must be 0 or more and in ascending order");
            }
        }
        return rows.clone();
    }

    /** The number of rows that the candidate reaches. */
    public int size() {
        return rows.length;
    }

    /**
     * The number of a row that the candidate reaches, from 0.
     *
     * @param at index among the rows that the candidate reaches, from 0
     */
    public int row(int at) {
        return rows[at];
    }

    /** The candidate's value in the {@linkplain #row row} with the same index. */
    public double value(int at) {
        return values == null ? 1.0 : values[at];
    }

    /** The greatest row that it reaches; -1 if there is none. */
    int lastRow() {
        return rows.length == 0 ? -1 : rows[rows.length - 1];
    }

    @Override
    public String toString() {
        return "rows " + Arrays.toString(rows) + ", values " + (values == null ? "1" : Arrays.toString(values));
    }
}
