package org.dronewatch.placement.solver;

import java.util.Arrays;

/**
 * The relaxation for sums of the rows' best gains: each row may take the gains of several candidates, at a price. For k
 * = 1 its best bound is that of the linear programme of the p-median: G. Cornuejols, M. L. Fisher and G. L. Nemhauser,
 * Management Science 23 (1977). For greater k, it is the mean of a row's k best gains that is bounded, which is no less
 * than the k-th best.
 */
final class BestSumDual extends Dual {
    BestSumDual(Gains gains, Rules rules) {
        super(gains, rules);
    }

    @Override
    double begin(double[] multipliers) {
        double sum = 0.0;
        for (double multiplier : multipliers) {
            sum += multiplier;
        }
        Arrays.fill(slope, gains.fold);
        return gains.fold * sum;
    }

    @Override
    double share(int[] rows, double[] values, double[] multipliers) {
        double sum = 0.0;
        for (int at = 0; at < rows.length; at++) {
            sum += Math.max(0.0, values[at] / gains.fold - multipliers[rows[at]]);
        }
        return sum;
    }

    @Override
    void choose(int[] rows, double[] values, double[] multipliers) {
        for (int at = 0; at < rows.length; at++) {
            if (values[at] / gains.fold > multipliers[rows[at]]) {
                slope[rows[at]] -= 1.0;
            }
        }
    }

    @Override
    void project(double[] multipliers) {
        for (int row = 0; row < multipliers.length; row++) {
            multipliers[row] = Math.max(0.0, multipliers[row]);
        }
    }

    @Override
    double[] start(int[] chosen) {
        double[] best = new double[gains.rowCount()];
        for (int candidate : chosen) {
            for (int at = 0; at < gains.rows[candidate].length; at++) {
                int row = gains.rows[candidate][at];
                best[row] = Math.max(best[row], gains.gains[candidate][at] / gains.fold);
            }
        }
        return best;
    }
}
