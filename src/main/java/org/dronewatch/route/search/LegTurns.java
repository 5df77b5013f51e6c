package org.dronewatch.route.search;

/**
 * How legs over the nodes of a grid turn where turns need room: each leg is long enough for a turn by {@link #ROOM} or,
 * where directions are farther apart, into the next direction, and may turn as far as its own length and that of the
 * other leg allow. As {@linkplain LegLimits#isTurnable for any route}, a turn takes up half a leg at most. Immutable.
 */
final class LegTurns {
    /** Half the angle between the directions of the two knight's moves on either side of an axis, rad. */
    private static final double ROOM = Math.atan(0.5);

    private static final double ROUNDING = 1e-9;

    private final int[] repeats;
    private final long[] before;

    /**
     * The turns of some directions.
     *
     * @param directions at most 64
     * @param turnRadius smallest radius of a turn, 0 for none, in distances between nodes
     */
    LegTurns(PlanDirections directions, double turnRadius) {
        int count = directions.count();
        this.repeats = new int[count];
        double room = 2.0 * turnRadius * Math.tan(0.5 * Math.max(ROOM, directions.widest()));
        double[] lengths = new double[count];
        for (int i = 0; i < count; i++) {
            repeats[i] = Math.max(1, (int) Math.ceil(room / directions.length(i) - ROUNDING));
            lengths[i] = repeats[i] * directions.length(i);
        }
        this.before = new long[count];
        for (int to = 0; to < count; to++) {
            for (int from = 0; from < count; from++) {
                double angle =
                        Math.abs(Math.IEEEremainder(directions.heading(to) - directions.heading(from), 2.0 * Math.PI));
                boolean isTurnable =
                        2.0 * turnRadius * Math.tan(0.5 * angle) <= Math.min(lengths[from], lengths[to]) + ROUNDING;
                before[to] |= isTurnable ? 1L << from : 0L;
            }
        }
    }

    /** The least number of times that a leg repeats the step of its direction. */
    int repeats(int direction) {
        return repeats[direction];
    }

    /** The directions from which the drone can turn into one: a bit for each. */
    long before(int direction) {
        return before[direction];
    }
}
