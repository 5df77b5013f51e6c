package org.dronewatch.placement;

import java.util.List;

/** The value of a layout, straight from the definition of its objective. */
final class LayoutValue {
    private final PlacementProblem problem;
    private final double[][] values;
    private final int fold;

    LayoutValue(PlacementProblem problem, List<Integer> chosen) {
        this.problem = problem;
        this.values = problem.sortedValues(chosen);
        this.fold = problem.conditions().fold();
    }

    double value() {
        double sum = 0.0;
        double worst = 0.0;
        double least = values.length == 0 ? 0.0 : Double.POSITIVE_INFINITY;
        for (int row = 0; row < values.length; row++) {
            double value = inRow(row);
            sum += problem.table().weight(row) * value;
            worst = Math.max(worst, value);
            least = Math.min(least, value);
        }
        return switch (problem.objective()) {
            case COVERED_WEIGHT, JOINT_PROBABILITY, MEAN_IMPACT -> sum;
            case WORST_IMPACT -> worst;
            case WEAKEST_ROW -> least;
        };
    }

    private double inRow(int row) {
        double[] ascending = values[row];
        return switch (problem.objective()) {
            case COVERED_WEIGHT -> ascending.length < fold ? 0.0 : ascending[ascending.length - fold];
            case MEAN_IMPACT, WORST_IMPACT ->
                ascending.length < fold
                        ? problem.undetected(row)
                        : Math.min(problem.undetected(row), ascending[fold - 1]);
            case JOINT_PROBABILITY -> 1.0 - missed(ascending);
            case WEAKEST_ROW -> sum(ascending);
        };
    }

    private static double missed(double[] probabilities) {
        double missed = 1.0;
        for (double probability : probabilities) {
            missed *= 1.0 - Math.min(probability, PlacementProblem.CERTAIN);
        }
        return missed;
    }

    private static double sum(double[] values) {
        double sum = 0.0;
        for (double value : values) {
            sum += value;
        }
        return sum;
    }
}
