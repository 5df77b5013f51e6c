package org.dronewatch.placement.solver;

import java.util.Arrays;

/**
 * The relaxation for sums of weight times 1 - exp(-sum of gains): this concave function lies below its tangents, and a
 * multiplier is the slope of a row's tangent. The best tangents give the bound of the relaxation in which parts of
 * candidates may be chosen.
 */
final class SaturatedSumDual extends Dual {
    private static final double LEAST = 1e-9;

    SaturatedSumDual(Gains gains, Rules rules) {
        super(gains, rules);
    }

    /** The tangent with slope m touches at s = ln(w / m), and has the value w - m - m s at 0. */
    @Override
    double begin(double[] multipliers) {
        double sum = 0.0;
        for (int row = 0; row < multipliers.length; row++) {
            double weight = gains.weight[row];
            double touch = weight > 0.0 ? Math.log(weight / multipliers[row]) : 0.0;
            sum += weight > 0.0 ? weight - multipliers[row] - multipliers[row] * touch : 0.0;
            slope[row] = -touch;
        }
        return sum;
    }

    @Override
    void choose(int[] rows, double[] values, double[] multipliers) {
        for (int at = 0; at < rows.length; at++) {
            slope[rows[at]] += gains.weight[rows[at]] > 0.0 ? values[at] : 0.0;
        }
    }

    @Override
    void project(double[] multipliers) {
        for (int row = 0; row < multipliers.length; row++) {
            double weight = gains.weight[row];
            multipliers[row] = Math.min(weight, Math.max(LEAST * weight, multipliers[row]));
        }
    }

    @Override
    double[] start(int[] chosen) {
        double[] sums = new double[gains.rowCount()];
        for (int candidate : chosen) {
            for (int at = 0; at < gains.rows[candidate].length; at++) {
                sums[gains.rows[candidate][at]] += gains.gains[candidate][at];
            }
        }
        double[] slopes = new double[sums.length];
        Arrays.setAll(slopes, row -> gains.weight[row] * Math.exp(-sums[row]));
        project(slopes);
        return slopes;
    }
}
