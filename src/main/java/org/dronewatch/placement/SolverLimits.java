package org.dronewatch.placement;

import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;

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

    /** How long a search may take once the user has asked for the end, s. */
    private static final double LAST_SECONDS = 5.0;

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

    /**
     * Why a search has found no layout.
     *
     * @param impossible what to throw if none complies with the conditions
     * @return that or, if the search was stopped before it could know, a {@link CancellationException}
     */
    public RuntimeException none(Supplier<? extends RuntimeException> impossible) {
        return isStopped.getAsBoolean() ? new CancellationException() : impossible.get();
    }

    /**
     * What is left once the user has asked for the end: a few seconds for a layout of what was assessed by then. Under
     * conditions such as a fold, a search that is stopped at once has none.
     */
    public SolverLimits afterInterruption() {
        return new SolverLimits(gap, Math.min(seconds, LAST_SECONDS), () -> false);
    }
}
