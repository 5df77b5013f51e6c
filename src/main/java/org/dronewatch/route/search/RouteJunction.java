package org.dronewatch.route.search;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.dronewatch.geometry.Position;

/**
 * Joins a route to a less exposed one: the route leaves its course at a corner, and continues on that of the other one
 * from a corner nearby. Smoothing only improves a route bit by bit, and therefore may end in a local minimum from one
 * side where it does not from another.
 */
final class RouteJunction {
    /** The longest leg that joins two routes, in distances between nodes. */
    private static final double LONGEST = 10.0;

    private final RouteProblem problem;
    private final RouteExposure exposure;
    private final LegLimits limits;
    private final double longest;

    RouteJunction(RouteProblem problem) {
        this.problem = problem;
        this.exposure = new RouteExposure(problem);
        this.limits = new LegLimits(problem);
        this.longest = LONGEST * problem.grid().spacing();
    }

    /** A leg from a corner of one route to a corner of another, and the exposure of all the rest. */
    private record Junction(int from, int to, double rest) {}

    /**
     * The least exposed path that begins as one does and ends as another.
     *
     * @param own the path to improve, only the part on which exposure counts
     * @param other the part of the other path on which exposure counts
     * @return empty if none is less exposed than the own path
     */
    Optional<RoutePath> best(RoutePath own, RoutePath other) {
        return best(own, other, exposure.along(own));
    }

    /**
     * The least exposed path that begins as one does and ends as another, and whose exposure is below a limit.
     *
     * @param most exposure of the result, exclusive
     */
    Optional<RoutePath> best(RoutePath own, RoutePath other, double most) {
        double least = most;
        Optional<RoutePath> best = Optional.empty();
        for (Junction junction : junctions(own, other, least)) {
            if (junction.rest() >= least) {
                break;
            }
            double along = junction.rest() + leg(own, other, junction);
            if (along < least && isFlyable(own, other, junction)) {
                least = along;
                best = Optional.of(path(own, other, junction));
            }
        }
        return best;
    }

    /** All junctions whose rest is less exposed than a limit, the least exposed first. */
    private List<Junction> junctions(RoutePath own, RoutePath other, double least) {
        List<Junction> junctions = new ArrayList<>();
        double[] before = before(own);
        double[] passed = before(other);
        double all = passed[passed.length - 1];
        for (int to = 0; to < other.modes().size(); to++) {
            for (int from = 0; from < own.points().size(); from++) {
                double rest = before[from] + all - passed[to];
                if (rest < least && isNear(own, from, other, to)) {
                    junctions.add(new Junction(from, to, rest));
                }
            }
        }
        junctions.sort(Comparator.comparingDouble(Junction::rest));
        return junctions;
    }

    /** The exposure up to each corner. */
    private double[] before(RoutePath path) {
        double[] before = new double[path.points().size()];
        for (int leg = 0; leg < path.modes().size(); leg++) {
            before[leg + 1] = before[leg]
                    + exposure.leg(
                            path.points().get(leg),
                            path.points().get(leg + 1),
                            path.modes().get(leg));
        }
        return before;
    }

    /** Whether the corners are near each other, and the drone flies in the same mode there or can change it. */
    private boolean isNear(RoutePath own, int from, RoutePath other, int to) {
        int mode = own.modes().isEmpty() ? 0 : own.modes().get(Math.max(0, from - 1));
        double length = own.points().get(from).distance(other.points().get(to));
        int onwards = other.modes().get(to);
        return (onwards == mode || problem.mayChangeFrom(mode)) && length > 0.0 && length <= longest;
    }

    private double leg(RoutePath own, RoutePath other, Junction junction) {
        return exposure.leg(
                own.points().get(junction.from()),
                other.points().get(junction.to()),
                other.modes().get(junction.to()));
    }

    private boolean isFlyable(RoutePath own, RoutePath other, Junction junction) {
        Position from = own.points().get(junction.from());
        Position to = other.points().get(junction.to());
        Position next = other.points().get(junction.to() + 1);
        return (junction.from() == 0 || isTurnable(own.points().get(junction.from() - 1), from, to))
                && isTurnable(from, to, next)
                && limits.isOpen(from.x(), from.y(), from.z(), to.x(), to.y(), to.z());
    }

    private boolean isTurnable(Position before, Position at, Position after) {
        return limits.isTurnable(at.x() - before.x(), at.y() - before.y(), after.x() - at.x(), after.y() - at.y());
    }

    private static RoutePath path(RoutePath own, RoutePath other, Junction junction) {
        List<Position> points = new ArrayList<>(own.points().subList(0, junction.from() + 1));
        points.addAll(other.points().subList(junction.to(), other.points().size()));
        List<Integer> modes = new ArrayList<>(own.modes().subList(0, junction.from()));
        modes.add(other.modes().get(junction.to()));
        modes.addAll(other.modes().subList(junction.to(), other.modes().size()));
        return new RoutePath(points, modes);
    }
}
