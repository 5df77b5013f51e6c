package org.dronewatch.route.search;

import java.util.Arrays;

/**
 * The legs between nodes: straight in plan, level or one level up or down. Their exposure is the time that they take
 * times the mean rate on the leg's own heading, where the rate is bilinear between the nodes of a level, and a leg that
 * climbs or descends passes from the rate at one level to that at the other in proportion to the distance. Where the
 * drone needs room to turn, and where it glides, a leg leads over several nodes. Where the drone needs no room to turn,
 * it also climbs and descends vertically under power. Immutable.
 */
final class RouteEdges {
    /** Up, level, down. */
    private static final int[] CLIMBS = {-1, 0, 1};

    private static final int[] LEVEL_ONLY = {0};

    private final RouteGrid grid;
    private final PlanDirections directions;
    private final RouteMode[] modes;
    private final LegTurns turns;
    private final LegRates rates;

    /** By direction, the horizontal length of the shortest leg, m. */
    private final double[] units;

    /** By direction and number of repeats, the nodes that a level leg passes, relative to its beginning. */
    private final int[][][] passed;

    /** By direction, the node to which the shortest leg leads, relative to its beginning. */
    private final int[] shortest;

    RouteEdges(RouteProblem problem) {
        this.grid = problem.grid();
        this.directions = problem.directions();
        this.modes = problem.modes().toArray(RouteMode[]::new);
        this.turns = problem.turns();
        this.rates = new LegRates(problem);
        this.units = new double[directions.count()];
        Arrays.setAll(units, direction -> grid.spacing() * directions.length(direction));
        this.passed = new int[units.length][][];
        Arrays.setAll(passed, this::passed);
        this.shortest = new int[units.length];
        Arrays.setAll(shortest, i -> directions.north(i) * grid.columns() + directions.east(i));
    }

    private int[][] passed(int direction) {
        int most = 1;
        for (int mode = 0; mode < modes.length; mode++) {
            for (int level = 0; level < grid.levels(); level++) {
                for (int climb : climbs()) {
                    boolean isInside = level + climb >= 0 && level + climb < grid.levels();
                    most = isInside ? Math.max(most, repeats(mode, direction, level, climb)) : most;
                }
            }
        }
        int[][] nodes = new int[most + 1][];
        for (int repeats = 1; repeats <= most; repeats++) {
            nodes[repeats] =
                    passed(repeats * directions.east(direction), repeats * directions.north(direction), grid.columns());
        }
        return nodes;
    }

    /** By how many levels a leg may change. */
    int[] climbs() {
        return grid.levels() > 1 ? CLIMBS : LEVEL_ONLY;
    }

    /**
     * How often a leg repeats the step of its direction: as often as its turns need; for a glide to the level below, as
     * far as the glide carries; and under power, as far as the least speed requires, over level ground.
     *
     * @param level at which the leg begins
     */
    int repeats(int mode, int direction, int level, int climb) {
        double rise = climb == 0 ? 0.0 : grid.height(level + climb) - grid.height(level);
        int needed = modes[mode].isGlide() && climb == -1
                ? (int) Math.floor(rise / (modes[mode].steepest() * units[direction]) + 1e-9)
                : (int) Math.ceil(modes[mode].leastLength(rise) / units[direction] - 1e-9);
        return Math.max(turns.repeats(direction), needed);
    }

    /**
     * The exposure of a leg; infinite where it cannot be flown: where it is too steep, or passes a blocked node.
     *
     * @param from node at which it begins; its end is inside the grid
     * @param repeats how often it repeats the step of its direction
     * @param climb the number of levels by which the leg changes
     */
    double cost(int mode, int direction, int from, int repeats, int climb) {
        int plane = grid.columns() * grid.rows();
        int to = from + repeats * shortest[direction] + climb * plane;
        double time = modes[mode].time(repeats * units[direction], grid.z(to) - grid.z(from));
        if (time == Double.POSITIVE_INFINITY || climb != 0 && !isOpen(from, to, passed[direction][repeats], climb)) {
            return Double.POSITIVE_INFINITY;
        }
        float[] rate = rates.of(mode, direction);
        double sum = 0.0;
        for (int i = 0; i < repeats; i++) {
            int at = from + i * shortest[direction];
            if (climb == 0) {
                if (rate[at] < 0.0F) {
                    return Double.POSITIVE_INFINITY;
                }
                sum += rate[at];
            } else {
                double climbed = (i + 0.5) / repeats;
                sum += (1.0 - climbed) * Math.abs(rate[at]) + climbed * Math.abs(rate[at + climb * plane]);
            }
        }
        return time * sum / repeats;
    }

    /** Whether a leg may be vertical. */
    boolean hasVertical() {
        return rates.hasVertical();
    }

    /**
     * The exposure of a vertical leg; infinite where it cannot be flown.
     *
     * @param from node at which it begins
     * @param to the node above or below
     */
    double verticalCost(int mode, int from, int to) {
        boolean isUp = to > from;
        double rate = 0.5 * ((double) rates.vertical(mode, isUp, from) + rates.vertical(mode, isUp, to));
        return rate == Double.POSITIVE_INFINITY ? rate : rate * modes[mode].time(0.0, grid.z(to) - grid.z(from));
    }

    /**
     * Whether a drone can be at the ends of a leg that climbs or descends, and at the nodes that it passes.
     *
     * @param between the nodes that the leg would pass if it were level, including its beginning, all relative to its
     *     beginning
     */
    private boolean isOpen(int from, int to, int[] between, int climb) {
        int rise = climb * grid.columns() * grid.rows();
        int pieces = between.length;
        for (int i = 0; i < pieces; i++) {
            if (!grid.isOpen(from + between[i] + (2 * i < pieces ? 0 : rise))) {
                return false;
            }
        }
        return grid.isOpen(to);
    }

    /**
     * The nodes that a level leg passes, and that at which it begins, but not its end, all relative to its beginning.
     *
     * @param east nodes that it leads to the east
     * @param north nodes that it leads to the north
     * @param columns columns of the grid
     */
    static int[] passed(int east, int north, int columns) {
        int[] nodes = new int[Math.max(Math.abs(east), Math.abs(north))];
        Arrays.setAll(nodes, i -> nearest(north, i, nodes.length) * columns + nearest(east, i, nodes.length));
        return nodes;
    }

    /** A fraction of a number of nodes, rounded; halves upwards. */
    private static int nearest(int nodes, int part, int of) {
        return Math.floorDiv(2 * nodes * part + of, 2 * of);
    }
}
