package org.dronewatch.placement.solver;

import java.util.Arrays;

/**
 * A Lagrangian relaxation: for any multipliers of the rows, an upper bound on the gain of all choices that agree with
 * some decisions. The rows no longer bind the candidates together, so that each has a separate share. Not thread-safe.
 */
abstract class Dual {
    final Gains gains;
    final Selection selection;

    /** The derivative of the bound with respect to each multiplier. */
    final double[] slope;

    private final double[] share;

    Dual(Gains gains, Rules rules) {
        this.gains = gains;
        selection = new Selection(rules);
        slope = new double[gains.rowCount()];
        share = new double[gains.candidates()];
    }

    /** The relaxation for the form of the given gains. */
    static Dual of(Gains gains, Rules rules) {
        return switch (gains.form) {
            case BEST_SUM -> new BestSumDual(gains, rules);
            case SUM_LEAST -> new SumLeastDual(gains, rules);
            case SATURATED_SUM -> new SaturatedSumDual(gains, rules);
            case LEAST_SUM ->
                throw new IllegalArgumentException("the groups must be combined into a weighted sum first");
            case BEST_LEAST -> throw new IllegalArgumentException("the p-centre has a separate search");
        };
    }

    /** The bound for some multipliers. */
    final double evaluate(double[] multipliers, byte[] state) {
        double constant = begin(multipliers);
        Arrays.fill(share, 0.0);
        for (int candidate = 0; candidate < share.length; candidate++) {
            if (state[candidate] != SearchNode.OUT) {
                share[candidate] = share(gains.rows[candidate], gains.gains[candidate], multipliers);
            }
        }
        double bound = constant + selection.solve(share, state);
        for (int candidate = 0; candidate < share.length; candidate++) {
            if (state[candidate] == SearchNode.IN || selection.isPicked(candidate)) {
                choose(gains.rows[candidate], gains.gains[candidate], multipliers);
            }
        }
        return bound;
    }

    /** The part of the bound that does not depend on the choice; begins the slopes. */
    abstract double begin(double[] multipliers);

    /** What a candidate adds to the bound if it is chosen; by default, its gains weighted by the multipliers. */
    double share(int[] rows, double[] values, double[] multipliers) {
        double sum = 0.0;
        for (int at = 0; at < rows.length; at++) {
            sum += values[at] * multipliers[rows[at]];
        }
        return sum;
    }

    /** Adds the part of a chosen candidate to the slopes. */
    abstract void choose(int[] rows, double[] values, double[] multipliers);

    /** Changes multipliers to the nearest that are valid. */
    abstract void project(double[] multipliers);

    /** Multipliers to begin with. */
    abstract double[] start(int[] chosen);
}
