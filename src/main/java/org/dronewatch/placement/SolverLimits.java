package org.dronewatch.placement;

import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Quantity;

/**
 * When a search may end before it has proven a layout to be the best.
 *
 * @param gap the search ends once value and bound differ by at most this fraction of the value, 0 to 1; 0 to prove that
 *     the layout is the best
 * @param end decides when the search ends without having reached the gap; the layout found by then depends on the speed
 *     of the machine
 */
public record SolverLimits(double gap, SearchEnd end) {
    /** No limits: the search ends once the layout is proven to be the best. */
    public static final SolverLimits NONE = new SolverLimits(0.0, Double.POSITIVE_INFINITY, () -> false);

    /** Checks the limits. */
    public SolverLimits {
        if (!(gap >= 0.0) || gap > 1.0) {
            throw new IllegalArgumentException("gap " + gap + ": must be 0 to 1");
        }
    }

    /**
     * Limits whose time starts with the first search that uses them, or uses copies of them with another gap.
     *
     * @param gap the largest difference between value and bound at which a search ends, as a fraction of the value, 0
     *     to 1
     * @param seconds time that all these searches may take together, s, above 0; infinite for no limit
     * @param isStopped queried repeatedly, from any thread; whether the user has asked the searches to stop
     */
    public SolverLimits(double gap, double seconds, BooleanSupplier isStopped) {
        this(gap, new SearchEnd(seconds, isStopped));
    }

    /** A copy with another gap, for a search that shares the time. */
    public SolverLimits withGap(double other) {
        return new SolverLimits(other, end);
    }

    /**
     * Why a search has found no layout.
     *
     * @param impossible supplies the exception for the case that no layout complies with the conditions
     * @return that exception or, if the search ended before this could be known, a {@link CancellationException} for
     *     the user's request and an {@link InputException} for the time limit
     */
    public RuntimeException none(Supplier<? extends RuntimeException> impossible) {
        if (end.isStopped()) {
            return new CancellationException();
        }
        return end.isTimeOver()
                ? new InputException("time limit " + Quantity.DURATION.inWords(end.seconds())
                        + ": by then, no layout within the budget had been found that meets the conditions;"
                        + " whether there is one is not known")
                : impossible.get();
    }
}
