package org.dronewatch.placement.solver;

import java.util.function.BooleanSupplier;
import java.util.function.Consumer;

/**
 * Lowers the bound of a relaxation by steps against its slopes, whose length is B. T. Polyak's: the estimated distance
 * to the best gain, divided by the sum of the squares of the slopes and multiplied by a factor that is halved when the
 * bound no longer decreases: M. Held, P. Wolfe and H. P. Crowder, Mathematical Programming 6 (1974).
 */
final class Subgradient {
    private static final int PATIENCE = 12;

    /** The number of steps between two choices that are improved by swaps. */
    private static final int PERIOD = 8;

    private static final double LEAST_FACTOR = 1e-3;
    private static final double GUESS = 0.05;
    private static final double ENOUGH = 1e-12;

    private final Dual dual;
    private final Incumbent incumbent;
    private final Cutoff cutoff;
    private final Consumer<int[]> improver;
    private final BooleanSupplier isStopped;

    /**
     * A search for the least bound.
     *
     * @param improver is given choices now and then, and offers better ones
     */
    Subgradient(Dual dual, Incumbent incumbent, Cutoff cutoff, Consumer<int[]> improver, BooleanSupplier isStopped) {
        this.dual = dual;
        this.improver = improver;
        this.incumbent = incumbent;
        this.cutoff = cutoff;
        this.isStopped = isStopped;
    }

    /**
     * The least bound found; leaves the relaxation at it.
     *
     * @param multipliers multipliers to begin with; afterwards those of the least bound
     */
    double lowest(double[] multipliers, byte[] state, int steps) {
        double[] trial = multipliers.clone();
        double lowest = Double.POSITIVE_INFINITY;
        double factor = 1.0;
        int patience = PATIENCE;
        for (int step = 0; step < steps && factor > LEAST_FACTOR && !isStopped.getAsBoolean(); step++) {
            double bound = dual.evaluate(trial, state);
            offer(step);
            patience--;
            if (bound < lowest) {
                patience = bound < lowest - ENOUGH * Math.abs(lowest) ? PATIENCE : patience;
                lowest = bound;
                System.arraycopy(trial, 0, multipliers, 0, trial.length);
            }
            if (cutoff.isHopeless(lowest)) {
                return lowest;
            }
            if (patience == 0) {
                factor *= 0.5;
                patience = PATIENCE;
                System.arraycopy(multipliers, 0, trial, 0, trial.length);
                dual.evaluate(trial, state);
            }
            if (!move(trial, bound, factor)) {
                break;
            }
        }
        return Math.min(lowest, dual.evaluate(multipliers, state));
    }

    /** What the relaxation picks is a choice, too; now and then, swaps make it a good one. */
    private void offer(int step) {
        int[] chosen = dual.selection.affordable();
        incumbent.offer(chosen);
        if (step % PERIOD == PERIOD - 1) {
            improver.accept(chosen);
        }
    }

    /** Takes a step down; returns false where the bound is the least that there is. */
    private boolean move(double[] multipliers, double bound, double factor) {
        double square = 0.0;
        for (int row = 0; row < multipliers.length; row++) {
            square += dual.slope[row] > 0.0 && multipliers[row] <= 0.0 ? 0.0 : dual.slope[row] * dual.slope[row];
        }
        double distance = incumbent.isFound() ? bound - incumbent.value() : GUESS * Math.abs(bound);
        double length = factor * distance / square;
        if (!(length > 0.0) || Double.isInfinite(length)) {
            return false;
        }
        for (int row = 0; row < multipliers.length; row++) {
            multipliers[row] -= length * dual.slope[row];
        }
        dual.project(multipliers);
        return true;
    }
}
