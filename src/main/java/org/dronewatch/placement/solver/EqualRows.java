package org.dronewatch.placement.solver;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.function.IntToDoubleFunction;
import org.dronewatch.placement.CandidateColumn;
import org.dronewatch.placement.CandidateTable;

/**
 * Rows to which all candidates contribute the same are merged, and their weights added: many cells of the air are seen
 * by the same sensors. Rows that no candidate reaches are merged, too.
 */
final class EqualRows {
    private final int[] merged;
    private final int[] first;
    private final double[] weights;

    /** The rows of a table; those with different impacts where no candidate detects anything differ. */
    EqualRows(CandidateTable table, IntToDoubleFunction undetected) {
        int[] counts = counts(table);
        Map<Contents, Integer> known = new HashMap<>();
        merged = new int[table.rows()];
        int[] firsts = new int[table.rows()];
        double[] sums = new double[table.rows()];
        int[][] candidates = new int[table.rows()][];
        double[][] values = new double[table.rows()][];
        transpose(table, counts, candidates, values);
        for (int row = 0; row < merged.length; row++) {
            Contents contents = new Contents(candidates[row], values[row], undetected.applyAsDouble(row));
            Integer earlier = known.putIfAbsent(contents, known.size());
            merged[row] = earlier == null ? known.size() - 1 : earlier;
            if (earlier == null) {
                firsts[merged[row]] = row;
            }
            sums[merged[row]] += table.weight(row);
        }
        first = Arrays.copyOf(firsts, known.size());
        weights = Arrays.copyOf(sums, known.size());
    }

    /** By row: how many candidates reach it. */
    private static int[] counts(CandidateTable table) {
        int[] counts = new int[table.rows()];
        for (int candidate = 0; candidate < table.size(); candidate++) {
            CandidateColumn column = table.column(candidate);
            for (int at = 0; at < column.size(); at++) {
                counts[column.row(at)]++;
            }
        }
        return counts;
    }

    private static void transpose(CandidateTable table, int[] counts, int[][] candidates, double[][] values) {
        for (int row = 0; row < counts.length; row++) {
            candidates[row] = new int[counts[row]];
            values[row] = new double[counts[row]];
        }
        int[] filled = new int[counts.length];
        for (int candidate = 0; candidate < table.size(); candidate++) {
            CandidateColumn column = table.column(candidate);
            for (int at = 0; at < column.size(); at++) {
                int row = column.row(at);
                candidates[row][filled[row]] = candidate;
                values[row][filled[row]++] = column.value(at);
            }
        }
    }

    /** The number of rows that differ. */
    int size() {
        return first.length;
    }

    /** The merged row of a row of the table. */
    int merged(int row) {
        return merged[row];
    }

    /** The first row of the table that was merged into a row. */
    int first(int row) {
        return first[row];
    }

    /** The sum of the weights of the rows that were merged. */
    double weight(int row) {
        return weights[row];
    }

    /** What distinguishes rows. */
    private static final class Contents {
        private final int[] candidates;
        private final double[] values;
        private final double undetected;

        Contents(int[] candidates, double[] values, double undetected) {
            this.candidates = candidates;
            this.values = values;
            this.undetected = undetected;
        }

        @Override
        public boolean equals(Object other) {
            return other instanceof Contents that
                    && undetected == that.undetected
                    && Arrays.equals(candidates, that.candidates)
                    && Arrays.equals(values, that.values);
        }

        @Override
        public int hashCode() {
            return 31 * (31 * Arrays.hashCode(candidates) + Arrays.hashCode(values)) + Double.hashCode(undetected);
        }
    }
}
