package org.dronewatch.placement;

import java.util.function.BooleanSupplier;

/**
 * When a search may end before it has proven a layout to be the best.
 *
 * @param gap the search ends once value and bound differ by at most this fraction of the value; 0 to prove that the
 *     layout is the best
 * @param seconds the search ends after this time, s; infinite for no limit. What it has found by then depends on the
 *     machine
 * @param isStopped queried repeatedly; the search ends soon after this returns true
 */
public record SolverLimits(double gap, double seconds, BooleanSupplier isStopped) {
    /** No limits: the search ends once the layout is proven to be the best. */
    public static final SolverLimits NONE = new SolverLimits(0.0, Double.POSITIVE_INFINITY, () -> false);

    /** Checks the limits. */
    public SolverLimits {
        if (!(gap >= 0.0) || gap > 1.0) {
            throw new IllegalArgumentException("gap " + gap + ": must be 0 to 1");
        }
        if (!(seconds > 0.0)) {
            throw new IllegalArgumentException("time limit " + seconds + " s: must be above 0");
        }
    }

    /** A copy with another gap. */
    public SolverLimits withGap(double other) {
        return new SolverLimits(other, seconds, isStopped);
    }

    /** A copy with another time limit, s. */
    public SolverLimits withSeconds(double other) {
        return new SolverLimits(gap, other, isStopped);
    }
}
