package org.dronewatch.placement;

import java.util.Arrays;
import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;

/** The value of a layout, straight from the definition of its objective. */
final class LayoutValue {
    private final PlacementProblem problem;
    private final PlacementObjective objective;

    /** The number of values that are kept of each row: the best k for objectives that take the k-th best. */
    private final int kept;

    /** By row: its values, the best first; otherwise all of them, in ascending order. */
    private final double[] values;

    /** By row: how many values there are. */
    private final int[] counts;

    LayoutValue(PlacementProblem problem, List<Integer> chosen) {
        this.problem = problem;
        this.objective = problem.objective();
        this.kept = objective.takesBest() ? problem.conditions().fold() : Math.max(1, chosen.size());
        this.counts = new int[problem.table().rows()];
        this.values = new double[Math.multiplyExact(counts.length, kept)];
        for (int candidate : chosen) {
            CandidateColumn column = problem.table().column(candidate);
            for (int at = 0; at < column.size(); at++) {
                insert(column.row(at), column.value(at));
            }
        }
    }

    /** The k best values of a row are those that remain of all when the worst of k + 1 is dropped each time. */
    private void insert(int row, double value) {
        boolean isDescending = objective.takesBest() && !objective.isImpact();
        int start = row * kept;
        int at = start + Math.min(counts[row], kept - 1);
        if (counts[row] == kept && !isBefore(value, values[at], isDescending)) {
            return;
        }
        while (at > start && isBefore(value, values[at - 1], isDescending)) {
            values[at] = values[at - 1];
            at--;
        }
        values[at] = value;
        counts[row] = Math.min(counts[row] + 1, kept);
    }

    private static boolean isBefore(double one, double other, boolean isDescending) {
        return isDescending ? one > other : one < other;
    }

    /** The sum for each group. */
    double[] sums() {
        double[] sums = new double[problem.table().groups()];
        for (int row = 0; row < counts.length; row++) {
            sums[problem.table().group(row)] += problem.table().weight(row) * inRow(row);
        }
        return sums;
    }

    double value() {
        return switch (objective) {
            case COVERED_WEIGHT, JOINT_PROBABILITY, MEAN_IMPACT ->
                Arrays.stream(sums()).reduce(0.0, Double::sum);
            case LEAST_COVERED_WEIGHT -> Arrays.stream(sums()).min().orElse(0.0);
            case WORST_IMPACT -> inRows().max().orElse(0.0);
            case WEAKEST_ROW -> inRows().min().orElse(0.0);
        };
    }

    private DoubleStream inRows() {
        return IntStream.range(0, counts.length).mapToDouble(this::inRow);
    }

    private double inRow(int row) {
        boolean isReached = counts[row] == kept;
        double last = values[row * kept + kept - 1];
        return switch (objective) {
            case COVERED_WEIGHT, LEAST_COVERED_WEIGHT -> isReached ? last : 0.0;
            case MEAN_IMPACT, WORST_IMPACT ->
                isReached ? Math.min(problem.undetected(row), last) : problem.undetected(row);
            case JOINT_PROBABILITY -> 1.0 - missed(row);
            case WEAKEST_ROW ->
                Arrays.stream(values, row * kept, row * kept + counts[row]).reduce(0.0, Double::sum);
        };
    }

    private double missed(int row) {
        double missed = 1.0;
        for (int at = row * kept; at < row * kept + counts[row]; at++) {
            missed *= 1.0 - Math.min(values[at], PlacementProblem.CERTAIN);
        }
        return missed;
    }
}
