package org.dronewatch.placement;

import java.util.Arrays;
import java.util.BitSet;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * Candidates and what each contributes to every row of a sparse matrix. A row represents whatever is to be served: a
 * cell of airspace, a scenario, a customer. Immutable.
 */
public final class CandidateTable {
    private final List<Candidate> candidates;
    private final List<CandidateColumn> columns;
    private final double[] weights;
    private final double[] undetected;

    /** By row; null if all rows are of group 0. */
    private final int[] groups;

    private final int groupCount;

    /**
     * A table whose rows form one group.
     *
     * @param candidates the candidates, with distinct names
     * @param columns one column for each candidate
     * @param weights weights of the rows, 0 or more
     * @param undetected for each row, the impact (such as damage) if no chosen candidate detects anything; NaN where
     *     the table does not state it. Only for objectives that minimise impacts
     * @throws IllegalArgumentException when the arguments contradict each other
     */
    public CandidateTable(
            List<Candidate> candidates, List<CandidateColumn> columns, double[] weights, double[] undetected) {
        this(candidates, columns, weights, undetected, null);
    }

    private CandidateTable(
            List<Candidate> candidates,
            List<CandidateColumn> columns,
            double[] weights,
            double[] undetected,
            int[] groups) {
        if (columns.size() != candidates.size() || undetected.length != weights.length) {
            throw new IllegalArgumentException(candidates.size() + " candidates, but " + columns.size() + " columns; "
                    + weights.length + " weights, but " + undetected.length + " impacts without a detection");
        }
        Set<String> names = new HashSet<>();
        for (int number = 0; number < candidates.size(); number++) {
            String name = candidates.get(number).name();
            if (!names.add(name)) {
                throw new IllegalArgumentException("candidate " + name + ": appears twice");
            }
            if (columns.get(number).lastRow() >= weights.length) {
                throw new IllegalArgumentException("candidate " + name + ": row "
                        + columns.get(number).lastRow() + " must be below " + weights.length);
            }
        }
        if (Arrays.stream(weights).anyMatch(weight -> !(weight >= 0.0) || Double.isInfinite(weight))) {
            throw new IllegalArgumentException("weights must be 0 or more");
        }
        if (Arrays.stream(undetected).anyMatch(impact -> impact < 0.0 || Double.isInfinite(impact))) {
            throw new IllegalArgumentException("impacts without a detection must be 0 or more");
        }
        this.candidates = List.copyOf(candidates);
        this.columns = List.copyOf(columns);
        this.weights = weights.clone();
        this.undetected = undetected.clone();
        this.groups = groups;
        this.groupCount =
                groups == null ? 1 : Math.max(1, 1 + Arrays.stream(groups).max().orElse(0));
    }

    /** A table without impacts. */
    public CandidateTable(List<Candidate> candidates, List<CandidateColumn> columns, double[] weights) {
        this(candidates, columns, weights, unstated(weights.length));
    }

    private static double[] unstated(int rows) {
        double[] none = new double[rows];
        Arrays.fill(none, Double.NaN);
        return none;
    }

    /**
     * A copy whose rows form groups, such as the cells under each of several weather conditions.
     *
     * @param numbers the group number of each row; the numbers run from 0 without gaps
     * @throws IllegalArgumentException when there are not as many numbers as rows, or a number is missing
     */
    public CandidateTable withGroups(int[] numbers) {
        BitSet used = new BitSet();
        for (int number : numbers) {
            if (number < 0 || number >= numbers.length) {
                throw new IllegalArgumentException("group " + number + ": must be 0 to " + (numbers.length - 1));
            }
            used.set(number);
        }
        if (numbers.length != weights.length || used.cardinality() != used.length()) {
            throw new IllegalArgumentException(numbers.length + " groups for " + weights.length
                    + " rows: there must be one for each row, numbered from 0 without gaps");
        }
        return new CandidateTable(candidates, columns, weights, undetected, numbers.clone());
    }

    /** The candidates; their indices identify them. */
    public List<Candidate> candidates() {
        return candidates;
    }

    /** The number of candidates. */
    public int size() {
        return candidates.size();
    }

    /** The number of rows. */
    public int rows() {
        return weights.length;
    }

    /** What a candidate contributes to each row. */
    public CandidateColumn column(int candidate) {
        return columns.get(candidate);
    }

    /** The weight of a row. */
    public double weight(int row) {
        return weights[row];
    }

    /** The group of a row, numbered from 0. */
    public int group(int row) {
        return groups == null ? 0 : groups[row];
    }

    /** The number of groups, 1 or more. */
    public int groups() {
        return groupCount;
    }

    /** The impact in a row if no candidate detects anything; NaN where it is not stated. */
    public double undetected(int row) {
        return undetected[row];
    }
}
