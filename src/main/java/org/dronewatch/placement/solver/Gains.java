package org.dronewatch.placement.solver;

import java.util.Arrays;
import org.dronewatch.placement.CandidateColumn;
import org.dronewatch.placement.PlacementObjective;
import org.dronewatch.placement.PlacementProblem;

/**
 * A problem in the form that all searches share: gains of 0 or more, the greater the better, which include the weights
 * of the rows. An impact becomes the amount by which it is less than the impact if no candidate detects anything;
 * probabilities p become -ln(1 - p), which add up. Immutable and thread-safe.
 */
final class Gains {
    /** How the gains of the chosen candidates in a row are combined, and how the rows are combined into a value. */
    enum Form {
        /** The sum over rows of the k-th best gain. */
        BEST_SUM,
        /** The least, over groups of rows, of the sum of their k-th best gains. */
        LEAST_SUM,
        /** The least of the rows' k-th best gains. */
        BEST_LEAST,
        /** The least of the rows' sums of gains. */
        SUM_LEAST,
        /** The sum over rows of weight times 1 - exp(-sum of gains). */
        SATURATED_SUM
    }

    final Form form;
    final int fold;

    /** By candidate: the rows that it reaches, ascending, and its gains there. */
    final int[][] rows;

    final double[][] gains;

    /** By row: the gain without any candidate. */
    final double[] floor;

    /** By row: its weight, for saturated sums only. */
    final double[] weight;

    /** By row: its group. */
    final int[] group;

    final int groups;

    private final double base;
    private final boolean isGreatest;

    Gains(PlacementProblem problem) {
        PlacementObjective objective = problem.objective();
        int size = problem.table().size();
        fold = problem.conditions().fold();
        form = switch (objective) {
            case COVERED_WEIGHT, MEAN_IMPACT -> Form.BEST_SUM;
            case LEAST_COVERED_WEIGHT -> Form.LEAST_SUM;
            case WORST_IMPACT -> Form.BEST_LEAST;
            case WEAKEST_ROW -> Form.SUM_LEAST;
            case JOINT_PROBABILITY -> Form.SATURATED_SUM;
        };
        isGreatest = objective.isGreatest();
        base = isGreatest ? 0.0 : impactOfNone(problem);
        EqualRows equal = new EqualRows(problem.table(), problem::undetected);
        floor = new double[equal.size()];
        weight = new double[equal.size()];
        group = new int[equal.size()];
        groups = problem.table().groups();
        for (int row = 0; row < floor.length; row++) {
            floor[row] = form == Form.BEST_LEAST ? base - problem.undetected(equal.first(row)) : 0.0;
            weight[row] = equal.weight(row);
            group[row] = problem.table().group(equal.first(row));
        }
        rows = new int[size][];
        gains = new double[size][];
        for (int candidate = 0; candidate < size; candidate++) {
            fill(candidate, problem, equal);
        }
    }

    /** The groups of other gains, added up with weights. */
    private Gains(Gains whole, double[] ofGroups) {
        form = Form.BEST_SUM;
        fold = whole.fold;
        rows = whole.rows;
        floor = whole.floor;
        weight = whole.weight;
        group = whole.group;
        groups = whole.groups;
        base = whole.base;
        isGreatest = whole.isGreatest;
        gains = new double[rows.length][];
        for (int candidate = 0; candidate < rows.length; candidate++) {
            gains[candidate] = whole.gains[candidate].clone();
            for (int at = 0; at < rows[candidate].length; at++) {
                gains[candidate][at] *= ofGroups[group[rows[candidate][at]]];
            }
        }
    }

    /**
     * The sum over groups with a weight each, at least the least sum of a group.
     *
     * @param ofGroups each 0 or more; they add up to 1
     */
    Gains weighted(double[] ofGroups) {
        return new Gains(this, ofGroups);
    }

    private static double impactOfNone(PlacementProblem problem) {
        double sum = 0.0;
        double greatest = 0.0;
        for (int row = 0; row < problem.table().rows(); row++) {
            sum += problem.table().weight(row) * problem.undetected(row);
            greatest = Math.max(greatest, problem.undetected(row));
        }
        return problem.objective() == PlacementObjective.MEAN_IMPACT ? sum : greatest;
    }

    private void fill(int candidate, PlacementProblem problem, EqualRows equal) {
        CandidateColumn column = problem.table().column(candidate);
        int[] reached = new int[column.size()];
        double[] values = new double[column.size()];
        int count = 0;
        for (int at = 0; at < column.size(); at++) {
            int row = equal.merged(column.row(at));
            if (equal.first(row) == column.row(at)) {
                double gain = gain(problem, column.row(at), column.value(at), weight[row]);
                if (gain > floor[row]) {
                    reached[count] = row;
                    values[count++] = gain;
                }
            }
        }
        rows[candidate] = Arrays.copyOf(reached, count);
        gains[candidate] = Arrays.copyOf(values, count);
    }

    private double gain(PlacementProblem problem, int row, double value, double rowWeight) {
        return switch (problem.objective()) {
            case COVERED_WEIGHT, LEAST_COVERED_WEIGHT -> rowWeight * value;
            case MEAN_IMPACT -> rowWeight * Math.max(0.0, problem.undetected(row) - value);
            case WORST_IMPACT -> base - Math.min(problem.undetected(row), value);
            case WEAKEST_ROW -> value;
            case JOINT_PROBABILITY -> -Math.log1p(-Math.min(value, PlacementProblem.CERTAIN));
        };
    }

    int candidates() {
        return rows.length;
    }

    int rowCount() {
        return floor.length;
    }

    /** Whether each candidate gains less the more others are chosen: then the greedy choice has a guarantee. */
    boolean isSubmodular() {
        return form == Form.SATURATED_SUM || form == Form.BEST_SUM && fold == 1;
    }

    /** The value of the objective for a sum of gains. */
    double reported(double gain) {
        return isGreatest ? gain : base - gain;
    }

    /** The sum of gains for a value of the objective. */
    double gainOf(double value) {
        return isGreatest ? value : base - value;
    }
}
