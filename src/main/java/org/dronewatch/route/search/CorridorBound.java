package org.dronewatch.route.search;

import java.util.BitSet;
import java.util.List;
import org.dronewatch.geometry.Position;

/**
 * A lower bound on the exposure along all routes that are hardly longer than the straight line. A route of at most a
 * given length from one point to another stays inside the prolate spheroid that has them as foci. The route crosses
 * each slab that is perpendicular to the straight line, and its length inside the slab is at least the slab's
 * thickness, so that its exposure is at least the sum, over the slabs, of the thickness times the least exposure per
 * metre in slab and spheroid. Routes that begin, or end, within a ball are those from, or to, its centre, with its
 * radius added to their length. The shorter the detour that the length allows, the tighter the bound.
 */
final class CorridorBound {
    /** The thickness of slabs as a fraction of the distance between nodes; they may be a little thinner. */
    private static final double THICKNESS = 0.5;

    /** In a corridor wider than this fraction of its length, the dual bound of {@link EnduranceLimit} is better. */
    private static final double WIDEST = 0.1;

    /** Against rounding of lengths: the spheroid is too long by this factor. */
    private static final double SAFETY = 1.0 + 1e-12;

    private final RouteProblem problem;
    private final Ball start;
    private final Ball end;

    /** Half the length of the spheroid's short axes, m. */
    private final double radius;

    /**
     * Routes of a limited length.
     *
     * @param starts the nodes from which routes come, and between which they may begin; not empty
     * @param ends the nodes at which routes end, and between which they may end; not empty
     * @param longest the length that no route exceeds, m
     */
    CorridorBound(RouteProblem problem, BitSet starts, BitSet ends, double longest) {
        this.problem = problem;
        this.start = Ball.around(problem.grid(), starts);
        this.end = Ball.around(problem.grid(), ends);
        double half = 0.5 * SAFETY * (longest + start.radius() + end.radius());
        double focus = 0.5 * start.center().distance(end.center());
        this.radius = Math.sqrt(Math.max(0.0, half * half - focus * focus));
    }

    /** The bound; 0 if the length allows so long a detour that the bound would say little. */
    double exposure() {
        double distance = start.center().distance(end.center());
        if (radius > WIDEST * distance) {
            return 0.0;
        }
        double first = start.radius();
        double crossed = distance - first - end.radius();
        int slabs = (int) Math.ceil(crossed / (THICKNESS * problem.grid().spacing()));
        double sum = 0.0;
        for (int slab = 0; slab < slabs; slab++) {
            double from = (first + crossed * slab / slabs) / distance;
            double to = (first + crossed * (slab + 1) / slabs) / distance;
            sum += leastPerMeter(from, to) * crossed / slabs;
        }
        return sum;
    }

    /** The least exposure per metre in the slab between two fractions of the way. */
    private double leastPerMeter(double from, double to) {
        double[] low = new double[3];
        double[] high = new double[3];
        double[] starts = coordinates(start.center());
        double[] ends = coordinates(end.center());
        double distance = start.center().distance(end.center());
        for (int axis = 0; axis < low.length; axis++) {
            double way = ends[axis] - starts[axis];
            double along = way / distance;
            double across = radius * Math.sqrt(Math.max(0.0, 1.0 - along * along));
            low[axis] = starts[axis] + Math.min(from * way, to * way) - across;
            high[axis] = starts[axis] + Math.max(from * way, to * way) + across;
        }
        List<RouteMode> modes = problem.modes();
        double least = Double.POSITIVE_INFINITY;
        for (int mode = 0; mode < modes.size(); mode++) {
            double rate = problem.field()
                    .least(new Position(low[0], low[1], low[2]), new Position(high[0], high[1], high[2]), mode);
            least = Math.min(least, rate / modes.get(mode).speed());
        }
        return least;
    }

    private static double[] coordinates(Position position) {
        return new double[] {position.x(), position.y(), position.z()};
    }

    /**
     * A ball.
     *
     * @param center its centre, m
     * @param radius its radius, m
     */
    private record Ball(Position center, double radius) {
        /** A ball round some nodes: its centre is that of the box round them. */
        static Ball around(RouteGrid grid, BitSet nodes) {
            double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
            double[] high = {Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY};
            nodes.stream().forEach(node -> {
                double[] at = coordinates(grid.position(node));
                for (int axis = 0; axis < at.length; axis++) {
                    low[axis] = Math.min(low[axis], at[axis]);
                    high[axis] = Math.max(high[axis], at[axis]);
                }
            });
            Position center =
                    new Position(0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), 0.5 * (low[2] + high[2]));
            double radius = nodes.stream()
                    .mapToDouble(node -> grid.position(node).distance(center))
                    .max()
                    .orElseThrow();
            return new Ball(center, radius);
        }
    }
}
