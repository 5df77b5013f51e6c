package org.dronewatch.placement;

import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;

/** Limits of searches whose time is over as soon as it has begun, by a clock that differs from that of the process. */
public final class TimeOver {
    /** The limit, s: far more than any test takes. */
    public static final double SECONDS = 100_000.0;

    private static final long LATER = (long) (2.0e9 * SECONDS);

    private TimeOver() {}

    /**
     * Such limits.
     *
     * @param isStopped queried repeatedly; whether the user has asked for the end
     */
    public static SolverLimits limits(double gap, BooleanSupplier isStopped) {
        AtomicLong clock = new AtomicLong();
        return new SolverLimits(gap, new SearchEnd(SECONDS, isStopped, () -> clock.getAndSet(LATER)));
    }
}
