package org.dronewatch.placement.solver;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.dronewatch.placement.Candidate;
import org.dronewatch.placement.CandidateColumn;
import org.dronewatch.placement.CandidateTable;
import org.dronewatch.placement.PlacementConditions;
import org.dronewatch.placement.PlacementObjective;
import org.dronewatch.placement.PlacementProblem;

/** The rows that an oracle has found, each different from the others. */
final class CutRows {
    private final List<Candidate> candidates;
    private final PlacementConditions conditions;
    private final List<double[]> rows = new ArrayList<>();

    CutRows(List<Candidate> candidates, PlacementConditions conditions) {
        this.candidates = candidates;
        this.conditions = conditions;
    }

    void addAll(List<double[]> found) {
        for (double[] row : found) {
            if (rows.stream().noneMatch(other -> Arrays.equals(other, row))) {
                rows.add(row.clone());
            }
        }
    }

    /**
     * The problem with these rows. No layout reaches more than the bound in all of them, so that greater values of a
     * single candidate count as equal to it: this makes relaxations tighter, and does not make a layout of less value
     * the better one.
     *
     * @param bound bound on the best value, 0 or more
     */
    PlacementProblem problem(double bound) {
        double most = Math.max(bound, conditions.anyoneLost().orElse(0.0));
        List<CandidateColumn> columns = IntStream.range(0, candidates.size())
                .mapToObj(candidate -> column(candidate, most))
                .toList();
        double[] weights = new double[rows.size()];
        Arrays.fill(weights, 1.0);
        return new PlacementProblem(
                new CandidateTable(candidates, columns, weights), PlacementObjective.WEAKEST_ROW, conditions);
    }

    private CandidateColumn column(int candidate, double most) {
        int[] reached = IntStream.range(0, rows.size())
                .filter(row -> rows.get(row)[candidate] > 0.0)
                .toArray();
        return new CandidateColumn(
                reached,
                IntStream.of(reached)
                        .mapToDouble(row -> Math.min(most, rows.get(row)[candidate]))
                        .toArray());
    }

    /** The sum of a layout's values in the row where it is least; infinite without rows. */
    double value(List<Integer> layout) {
        double least = Double.POSITIVE_INFINITY;
        for (double[] row : rows) {
            double sum = 0.0;
            for (int candidate : layout) {
                sum += row[candidate];
            }
            least = Math.min(least, sum);
        }
        return least;
    }

    /** The best of those layouts that comply, the first of them in a tie; empty if none complies. */
    Optional<List<Integer>> best(List<List<Integer>> layouts) {
        List<Integer> best = null;
        PlacementProblem problem = problem(Double.MAX_VALUE);
        for (List<Integer> layout : layouts) {
            if (problem.isAllowed(layout) && (best == null || value(layout) > value(best))) {
                best = layout;
            }
        }
        return Optional.ofNullable(best);
    }
}
