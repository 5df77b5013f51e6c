package org.dronewatch.placement.solver;

import java.util.Arrays;

/**
 * The relaxation for the least of the rows' sums, which is at most any weighted mean of these sums. The best weights
 * give the bound of the linear programme, by von Neumann's minimax theorem.
 */
final class SumLeastDual extends Dual {
    SumLeastDual(Gains gains, Rules rules) {
        super(gains, rules);
    }

    @Override
    double begin(double[] multipliers) {
        Arrays.fill(slope, 0.0);
        return 0.0;
    }

    @Override
    void choose(int[] rows, double[] values, double[] multipliers) {
        for (int at = 0; at < rows.length; at++) {
            slope[rows[at]] += values[at];
        }
    }

    /** Projects the multipliers onto the simplex of weights of 0 or more whose sum is 1: J. Duchi et al., ICML 2008. */
    @Override
    void project(double[] multipliers) {
        double[] sorted = multipliers.clone();
        Arrays.sort(sorted);
        double sum = 0.0;
        double excess = 0.0;
        for (int rank = 1; rank <= sorted.length; rank++) {
            double value = sorted[sorted.length - rank];
            sum += value;
            if (value - (sum - 1.0) / rank <= 0.0) {
                break;
            }
            excess = (sum - 1.0) / rank;
        }
        double total = 0.0;
        for (int row = 0; row < multipliers.length; row++) {
            multipliers[row] = Math.max(0.0, multipliers[row] - excess);
            total += multipliers[row];
        }
        for (int row = 0; row < multipliers.length; row++) {
            multipliers[row] /= total;
        }
    }

    @Override
    double[] start(int[] chosen) {
        double[] uniform = new double[gains.rowCount()];
        Arrays.fill(uniform, 1.0 / uniform.length);
        return uniform;
    }
}
