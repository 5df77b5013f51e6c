package org.dronewatch.route.search;

/** What a path between the nodes of a grid must keep to: open places, and turns that the drone can fly. */
final class LegLimits {
    private static final double STEPS_PER_NODE = 2.0;

    private final RouteGrid grid;
    private final Passage passage;
    private final double turnRadius;

    LegLimits(RouteProblem problem) {
        this.grid = problem.grid();
        this.passage = problem.passage();
        this.turnRadius = problem.turnRadius();
    }

    /**
     * Whether a straight leg leads only through positions where a drone can be, and through nothing solid; all
     * coordinates in m.
     */
    boolean isOpen(double x, double y, double z, double toX, double toY, double toZ) {
        double length = Math.sqrt((toX - x) * (toX - x) + (toY - y) * (toY - y) + (toZ - z) * (toZ - z));
        int pieces = Math.max(1, (int) Math.ceil(STEPS_PER_NODE * length / grid.spacing()));
        for (int i = 0; i <= pieces; i++) {
            double share = (double) i / pieces;
            if (!grid.isOpen(x + share * (toX - x), y + share * (toY - y), z + share * (toZ - z))) {
                return false;
            }
        }
        return passage.isFree(x, y, z, toX, toY, toZ);
    }

    /**
     * Whether the corner between two legs can be rounded with the radius of a turn, if each provides half its length.
     *
     * @param inX horizontal components of the first leg, and then of the second, m
     */
    boolean isTurnable(double inX, double inY, double outX, double outY) {
        double first = Math.hypot(inX, inY);
        double second = Math.hypot(outX, outY);
        if (turnRadius == 0.0 || first == 0.0 || second == 0.0) {
            return true;
        }
        double angle = Math.abs(StrictMath.atan2(inX * outY - inY * outX, inX * outX + inY * outY));
        return turnRadius * Math.tan(0.5 * angle) <= 0.5 * Math.min(first, second) * (1.0 + 1e-9);
    }
}
