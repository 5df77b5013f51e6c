package org.dronewatch.route.search;

import java.util.List;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;

/**
 * Ends a route as soon as it has arrived, and makes the last part, on which a detection is too late, as fast as
 * straight legs allow, not only legs between nodes. Not thread-safe.
 */
final class RouteFinish {
    /** How far inside the edge of a zone a route ends, so that rounding leaves it inside, m. */
    private static final double INSIDE = 0.05;

    /**
     * Each shortening brings forward the moment from which the drone hurries; after a few, this moment hardly moves.
     */
    private static final int ROUNDS = 8;

    /** A shortening by less is the last one, s. */
    private static final double GAIN = 0.01;

    /** Up to this multiple of the response, the least time is that to the best point of the zone. */
    private static final double NEAR = 1.5;

    private final RouteProblem clock;
    private final RouteExposure times;
    private final LegLimits limits;
    private final RouteEnd arrival;
    private final double response;

    /**
     * A finish.
     *
     * @param clock a problem whose exposure is the time
     * @param response the time of the last part, 0 if there is none, s
     */
    RouteFinish(RouteProblem clock, RouteEnd arrival, double response) {
        this.clock = clock;
        this.times = new RouteExposure(clock);
        this.limits = new LegLimits(clock);
        this.arrival = arrival;
        this.response = response;
    }

    /** A route that ends where this one arrives, and never takes longer; the same up to the last part. */
    RoutePath of(RoutePath route) {
        RoutePath path = arrived(route);
        for (int round = 0; response > 0.0 && round < ROUNDS; round++) {
            RoutePath faster = hurried(path);
            double gain = times.time(path) - times.time(faster);
            path = gain > 0.0 ? faster : path;
            if (!(gain > GAIN)) {
                break;
            }
        }
        return path;
    }

    /** The part of a route on which a detection leaves enough time for a response. */
    RoutePath counted(RoutePath route) {
        double left = Math.max(0.0, times.time(route) - response);
        for (int leg = 0; leg < route.modes().size(); leg++) {
            double time = legTime(route, leg);
            if (left < time) {
                return route.until(leg, left / time);
            }
            left -= time;
        }
        return route;
    }

    /**
     * The least time from a node to where a route arrives: over the nodes or, where the drone can turn on the spot, in
     * a straight line.
     *
     * @param fastest routes over the nodes
     * @return s; infinite where no route leads there
     */
    double least(RouteTree fastest, int node) {
        double overNodes = fastest.cost(node);
        if (!(overNodes > 0.0) || overNodes == Double.POSITIVE_INFINITY) {
            return overNodes;
        }
        RoutePath path = fastest.path(fastest.states(node));
        double least = Math.min(overNodes, times.time(arrived(path)));
        Position from = path.points().get(0);
        Position end = path.points().get(path.points().size() - 1);
        if (clock.turnRadius() > 0.0) {
            return least;
        }
        RoutePath straight = arrived(new RoutePath(List.of(from, end), List.of(0)));
        // Where it decides whether a detection is in time, a goal that is merely near is not good enough.
        RoutePath best = overNodes <= NEAR * response ? new LastLeg(clock, arrival, from).of(straight) : straight;
        Position to = best.points().get(best.points().size() - 1);
        double time = times.time(best);
        boolean isFaster = time < least && limits.isOpen(from.x(), from.y(), from.z(), to.x(), to.y(), to.z());
        return isFaster ? time : least;
    }

    private double legTime(RoutePath route, int leg) {
        return times.time(
                route.points().get(leg),
                route.points().get(leg + 1),
                route.modes().get(leg));
    }

    private RoutePath arrived(RoutePath route) {
        for (int leg = 0; leg < route.modes().size(); leg++) {
            Position from = route.points().get(leg);
            Position to = route.points().get(leg + 1);
            OptionalDouble entry = arrival.entry(from, to);
            if (entry.isPresent()) {
                return route.until(leg, share(entry.getAsDouble(), from, to));
            }
        }
        return route;
    }

    /** The fraction of a leg at which it is certainly inside: 0 where it begins inside. */
    static double share(double entry, Position from, Position to) {
        return entry > 0.0 ? Math.min(1.0, entry + INSIDE / from.distance(to)) : 0.0;
    }

    /** The route with a faster last part. */
    private RoutePath hurried(RoutePath route) {
        RoutePath counted = counted(route);
        // Where turns need room, legs are not cut: the drone hurries from the next corner on.
        RoutePath head = clock.turnRadius() > 0.0 && !counted.modes().isEmpty()
                ? route.until(counted.modes().size() - 1, 1.0)
                : counted;
        List<Position> points = head.points();
        List<Position> before = points.subList(Math.max(0, points.size() - 2), points.size());
        RoutePath smooth = RouteSmoothing.after(before.get(0), clock, route.after(head));
        return arrived(head.then(new LastLeg(clock, arrival, before.get(0)).of(smooth)));
    }
}
