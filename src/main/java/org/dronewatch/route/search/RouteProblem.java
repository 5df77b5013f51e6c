package org.dronewatch.route.search;

import java.util.BitSet;
import java.util.List;
import org.dronewatch.route.exposure.ExposureField;

/**
 * The input of a route search.
 *
 * @param grid the nodes between which routes lead
 * @param field exposure field of the drone
 * @param modes modes in which the drone may fly, first those under power, then any glide; at any node, the drone may
 *     change between modes under power, or from one of these to a glide, but not back
 * @param turnRadius the smallest radius of a turn, 0 for no limit, m
 * @param directions directions in plan view in which routes may leave a node
 * @param starts nodes at which a route may begin
 * @param goals nodes at which a route may end
 * @param passage decides between which points the drone can fly straight; blocked nodes are never passed through
 */
public record RouteProblem(
        RouteGrid grid,
        ExposureField field,
        List<RouteMode> modes,
        double turnRadius,
        PlanDirections directions,
        BitSet starts,
        BitSet goals,
        Passage passage) {
    /**
     * Copies lists and sets.
     *
     * @throws IllegalArgumentException if there is no mode, no start or no goal, or the radius is negative
     */
    public RouteProblem {
        modes = List.copyOf(modes);
        starts = (BitSet) starts.clone();
        goals = (BitSet) goals.clone();
        if (modes.isEmpty() || starts.isEmpty() || goals.isEmpty() || !(turnRadius >= 0.0)) {
            throw new IllegalArgumentException(modes.size() + " modes, " + starts.cardinality() + " starts, "
                    + goals.cardinality() + " goals, and a turn radius of " + turnRadius
                    + " m: there must be at least one of each, and a radius of 0 m or more");
        }
    }

    /** A problem in which nothing is solid except the blocked nodes. */
    public RouteProblem(
            RouteGrid grid,
            ExposureField field,
            List<RouteMode> modes,
            double turnRadius,
            PlanDirections directions,
            BitSet starts,
            BitSet goals) {
        this(grid, field, modes, turnRadius, directions, starts, goals, Passage.EVERYWHERE);
    }

    /** This problem with another field. */
    public RouteProblem withField(ExposureField other) {
        return new RouteProblem(grid, other, modes, turnRadius, directions, starts, goals, passage);
    }

    /** The number of headings that the search distinguishes: one where any turn can be flown. */
    int headings() {
        return turnRadius > 0.0 ? directions.count() : 1;
    }

    /** Whether the drone may change from a mode, given by its number, to any other: motors are not started again. */
    boolean mayChangeFrom(int mode) {
        return !modes.get(mode).isGlide();
    }

    /** Whether the drone may change from one mode to the other and back. */
    boolean isExchangeable(int one, int other) {
        return mayChangeFrom(one) && mayChangeFrom(other);
    }

    /** How its legs turn. */
    LegTurns turns() {
        return new LegTurns(directions, turnRadius / grid.spacing());
    }

    /** The number of states: one for each mode, heading and node. */
    int states() {
        return Math.multiplyExact(Math.multiplyExact(modes.size(), headings()), grid.size());
    }
}
