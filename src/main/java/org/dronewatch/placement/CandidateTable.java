package org.dronewatch.placement;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * Candidates and what each contributes to every row of a sparse matrix. A row is whatever is to be served: a cell of
 * the air, a scenario, a customer. Immutable.
 */
public final class CandidateTable {
    private final List<Candidate> candidates;
    private final List<CandidateColumn> columns;
    private final double[] weights;
    private final double[] undetected;

    /**
     * A table.
     *
     * @param candidates with distinct names
     * @param columns one for each candidate
     * @param weights of the rows, 0 or more
     * @param undetected for each row, the impact where no chosen candidate detects; not a number where the table does
     *     not state it. Used for impacts only
     * @throws IllegalArgumentException when these contradict each other
     */
    public CandidateTable(
            List<Candidate> candidates, List<CandidateColumn> columns, double[] weights, double[] undetected) {
        if (columns.size() != candidates.size() || undetected.length != weights.length) {
            throw new IllegalArgumentException(
                    candidates.size() + " candidates, but " + columns.size() + " columns; " + weights.length
                            + " weights, but " + undetected.length + " impacts where no candidate detects anything");
        }
        Set<String> names = new HashSet<>();
        for (int number = 0; number < candidates.size(); number++) {
            String name = candidates.get(number).name();
            if (!names.add(name)) {
                throw new IllegalArgumentException("candidate " + name + ": appears twice");
            }
            if (columns.get(number).lastRow() >= weights.length) {
                throw new IllegalArgumentException("candidate " + name + ": row "
                        + columns.get(number).lastRow() + ", must be below " + weights.length);
            }
        }
        if (Arrays.stream(weights).anyMatch(weight -> !(weight >= 0.0) || Double.isInfinite(weight))) {
            throw new IllegalArgumentException("weights must be 0 or more");
        }
        if (Arrays.stream(undetected).anyMatch(impact -> impact < 0.0 || Double.isInfinite(impact))) {
            throw new IllegalArgumentException("impacts where no candidate detects anything must be 0 or more");
        }
        this.candidates = List.copyOf(candidates);
        this.columns = List.copyOf(columns);
        this.weights = weights.clone();
        this.undetected = undetected.clone();
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

    /** What a candidate contributes. */
    public CandidateColumn column(int candidate) {
        return columns.get(candidate);
    }

    /** The weight of a row. */
    public double weight(int row) {
        return weights[row];
    }

    /** The impact in a row where no candidate detects anything; not a number where it is not stated. */
    public double undetected(int row) {
        return undetected[row];
    }
}
