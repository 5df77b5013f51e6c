package org.dronewatch.route;

/**
 * The legs between posts: straight in plan, level or one level up or down. Their exposure is the time that they take
 * times the mean rate on the leg's own heading, by the trapezoidal rule over the posts that they pass. Where the drone
 * needs room to turn, and where it glides, a leg leads over several posts. Immutable.
 */
final class RouteEdges {
    /** Up, level, down. */
    private static final int[] CLIMBS = {-1, 0, 1};

    private static final int[] LEVEL_ONLY = {0};

    private final RouteGrid grid;
    private final PlanDirections directions;
    private final RouteMode[] modes;
    private final double turnRadius;
    private final PostRates rates;

    RouteEdges(RouteProblem problem) {
        this.grid = problem.grid();
        this.directions = problem.directions();
        this.modes = problem.modes().toArray(RouteMode[]::new);
        this.turnRadius = problem.turnRadius();
        this.rates = new PostRates(problem);
    }

    /** By how many levels a leg may change. */
    int[] climbs() {
        return grid.levels() > 1 ? CLIMBS : LEVEL_ONLY;
    }

    /** Horizontal length of the shortest leg in a direction, m. */
    private double unit(int direction) {
        int east = directions.east(direction);
        int north = directions.north(direction);
        return grid.spacing() * Math.sqrt(east * east + north * north);
    }

    /**
     * How often a leg repeats the step of its direction: as often as the turn to a neighbouring direction needs, and
     * for a glide to the level below as far as it carries.
     *
     * @param level at which the leg begins
     */
    int repeats(int mode, int direction, int level, int climb) {
        int turning = (int) Math.ceil(turnRadius * directions.widest() / unit(direction) - 1e-9);
        int carried = 1;
        if (modes[mode].isGlide() && climb == -1) {
            double drop = grid.height(level) - grid.height(level - 1);
            carried = (int) Math.floor(-drop / (modes[mode].steepest() * unit(direction)) + 1e-9);
        }
        return Math.max(1, Math.max(turning, carried));
    }

    /**
     * The exposure of a leg; infinite where it cannot be flown.
     *
     * @param from post at which it begins; its end is inside the grid
     * @param repeats how often it repeats the step of its direction
     * @param climb by how many levels it changes
     */
    double cost(int mode, int direction, int from, int repeats, int climb) {
        int east = repeats * directions.east(direction);
        int north = repeats * directions.north(direction);
        int plane = grid.columns() * grid.rows();
        int to = from + north * grid.columns() + east + climb * plane;
        double time = modes[mode].time(repeats * unit(direction), grid.z(to) - grid.z(from));
        if (time == Double.POSITIVE_INFINITY || !grid.isOpen(from) || !grid.isOpen(to)) {
            return Double.POSITIVE_INFINITY;
        }
        float[] rate = rates.of(mode, direction);
        int pieces = Math.max(Math.abs(east), Math.abs(north));
        double sum = 0.5 * ((double) rate[from] + rate[to]);
        for (int i = 1; i < pieces; i++) {
            int between = from
                    + nearest(north, i, pieces) * grid.columns()
                    + nearest(east, i, pieces)
                    + (2 * i < pieces ? 0 : climb * plane);
            if (!grid.isOpen(between)) {
                return Double.POSITIVE_INFINITY;
            }
            sum += rate[between];
        }
        return time * sum / pieces;
    }

    /** A fraction of a number of posts, rounded; halves upwards. */
    private static int nearest(int posts, int part, int of) {
        return Math.floorDiv(2 * posts * part + of, 2 * of);
    }
}
