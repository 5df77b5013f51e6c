package org.dronewatch.placement.solver;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.function.IntToDoubleFunction;
import org.dronewatch.placement.CandidateColumn;
import org.dronewatch.placement.CandidateTable;

/**
 * Rows to which each candidate contributes the same are merged, and their weights added: many cells of the air are seen
 * by the same sensors. Rows that no candidate reaches are merged, too. Classes of rows are refined by one candidate
 * after the other, which takes an integer for each row, however many candidates there are.
 */
final class EqualRows {
    private static final int NONE = -1;

    private final int[] merged;
    private final int[] first;
    private final double[] weights;

    /**
     * The rows of a table; those of different groups, or with different impacts where nothing detects anything, differ.
     */
    EqualRows(CandidateTable table, IntToDoubleFunction undetected) {
        merged = new int[table.rows()];
        int classes = divideByGroup(table, divideByImpact(undetected));
        for (int candidate = 0; candidate < table.size(); candidate++) {
            classes = divide(table.column(candidate), classes);
            if (classes > 2L * merged.length) {
                classes = renumber(classes);
            }
        }
        first = new int[renumber(classes)];
        weights = new double[first.length];
        Arrays.fill(first, NONE);
        for (int row = 0; row < merged.length; row++) {
            first[merged[row]] = first[merged[row]] == NONE ? row : first[merged[row]];
            weights[merged[row]] += table.weight(row);
        }
    }

    /** Divides the rows by their impacts; returns the number of classes. */
    private int divideByImpact(IntToDoubleFunction undetected) {
        Map<Double, Integer> known = new HashMap<>();
        for (int row = 0; row < merged.length; row++) {
            double impact = undetected.applyAsDouble(row);
            Integer earlier = known.putIfAbsent(impact, known.size());
            merged[row] = earlier == null ? known.size() - 1 : earlier;
        }
        return known.size();
    }

    private int divideByGroup(CandidateTable table, int classes) {
        if (table.groups() == 1) {
            return classes;
        }
        for (int row = 0; row < merged.length; row++) {
            merged[row] = merged[row] * table.groups() + table.group(row);
        }
        return renumber(Math.multiplyExact(classes, table.groups()));
    }

    /** Rows of a class that a candidate reaches form new classes, one for each of its values there. */
    private int divide(CandidateColumn column, int classes) {
        if (column.size() == 0) {
            return classes;
        }
        int count = classes;
        // Most candidates have one value in all rows: that is found without a map.
        double usual = column.value(0);
        int[] ofUsual = new int[classes];
        Arrays.fill(ofUsual, NONE);
        Map<ValueInClass, Integer> ofOthers = new HashMap<>();
        for (int at = 0; at < column.size(); at++) {
            int row = column.row(at);
            int former = merged[row];
            if (column.value(at) == usual) {
                ofUsual[former] = ofUsual[former] == NONE ? count++ : ofUsual[former];
                merged[row] = ofUsual[former];
            } else {
                Integer earlier = ofOthers.putIfAbsent(new ValueInClass(former, column.value(at)), count);
                merged[row] = earlier == null ? count++ : earlier;
            }
        }
        return count;
    }

    private record ValueInClass(int former, double value) {}

    /** Numbers the classes in the order in which they first occur; returns how many there are. */
    private int renumber(int classes) {
        int[] numbers = new int[classes];
        Arrays.fill(numbers, NONE);
        int count = 0;
        for (int row = 0; row < merged.length; row++) {
            int former = merged[row];
            numbers[former] = numbers[former] == NONE ? count++ : numbers[former];
            merged[row] = numbers[former];
        }
        return count;
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
}
