package org.dronewatch.placement.solver;

import java.util.function.BooleanSupplier;

/**
 * Says some seconds later than another that a search is to stop: for the first choice, without which there would be no
 * result. Not thread-safe.
 */
final class Grace implements BooleanSupplier {
    private static final double SECONDS = 5.0;
    private static final double NANOS = 1e-9;

    private final BooleanSupplier isStopped;
    private boolean hasBegun;
    private long begun;

    Grace(BooleanSupplier isStopped) {
        this.isStopped = isStopped;
    }

    @Override
    public boolean getAsBoolean() {
        if (!hasBegun && isStopped.getAsBoolean()) {
            hasBegun = true;
            begun = System.nanoTime();
        }
        return hasBegun && NANOS * (System.nanoTime() - begun) > SECONDS;
    }
}
