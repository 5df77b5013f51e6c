package org.dronewatch.route.search;

import java.util.OptionalDouble;

/**
 * The least time that a drone needs from each node of a grid to the end of a route: where this is less than the time
 * that a response takes, an alert must already have been raised. Immutable and thread-safe.
 */
public final class TimeToGo {
    private final RouteGrid grid;

    /** By node, s; infinite where no route leads to the end. */
    private final double[] least;

    TimeToGo(RouteGrid grid, double[] least) {
        this.grid = grid;
        this.least = least.clone();
    }

    /** The nodes; for a site, they are at the centres of its cells, with rows counted from the south. */
    public RouteGrid grid() {
        return grid;
    }

    /** The least time from a node, s; empty where no route leads to the end. */
    public OptionalDouble at(int node) {
        return finite(least[node]);
    }

    /** The least time from any level in a column and row of the grid, s; empty where no route leads to the end. */
    public OptionalDouble at(int column, int row) {
        double soonest = Double.POSITIVE_INFINITY;
        for (int level = 0; level < grid.levels(); level++) {
            soonest = Math.min(soonest, least[grid.node(column, row, level)]);
        }
        return finite(soonest);
    }

    private static OptionalDouble finite(double seconds) {
        return seconds < Double.POSITIVE_INFINITY ? OptionalDouble.of(seconds) : OptionalDouble.empty();
    }
}
