package org.dronewatch.route;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.search.RouteExposure;
import org.dronewatch.route.search.RoutePath;
import org.dronewatch.route.search.RouteProblem;

/**
 * A route as it is flown, from its start to its end: where the drone is at each time, at what height above the ground,
 * and its exposure to the sensors up to then, whether or not a detection would still be in time.
 *
 * @param points points of the route in order of time, at least one; the route is straight between two of them
 */
public record RouteProfile(List<RoutePoint> points) {
    /**
     * Copies the list.
     *
     * @throws IllegalArgumentException if it is empty
     */
    public RouteProfile {
        points = List.copyOf(points);
        if (points.isEmpty()) {
            throw new IllegalArgumentException("0 points: there must be at least one");
        }
    }

    /**
     * The profile of a path, with a point at least every half distance between nodes, and at each of its corners.
     *
     * @param height the height of a point above the ground, m
     */
    static RouteProfile of(RoutePath path, RouteProblem problem, ToDoubleFunction<Position> height) {
        RouteExposure exposure = new RouteExposure(problem);
        double step = 0.5 * problem.grid().spacing();
        List<RoutePoint> points = new ArrayList<>();
        double time = 0.0;
        double distance = 0.0;
        double sum = 0.0;
        int legs = path.modes().size();
        for (int leg = 0; leg < legs; leg++) {
            Position from = path.points().get(leg);
            Position to = path.points().get(leg + 1);
            int mode = path.modes().get(leg);
            double length = from.distance(to);
            int pieces = Math.max(1, (int) Math.ceil(length / step));
            double lasts = exposure.time(from, to, mode);
            for (int piece = 0; piece < pieces; piece++) {
                double begun = (double) piece / pieces;
                Position here = between(from, to, begun);
                Position next = between(from, to, (piece + 1.0) / pieces);
                points.add(new RoutePoint(
                        time + begun * lasts,
                        distance + begun * length,
                        here,
                        height.applyAsDouble(here),
                        mode,
                        sum,
                        piece == 0));
                sum += exposure.leg(here, next, mode);
            }
            time += lasts;
            distance += length;
        }
        Position end = path.points().get(legs);
        int last = legs == 0 ? 0 : path.modes().get(legs - 1);
        points.add(new RoutePoint(time, distance, end, height.applyAsDouble(end), last, sum, true));
        return new RouteProfile(points);
    }

    /** This route as it is flown, for pictures: the exposure is the mean number of looks that detect the drone. */
    RouteProfile with(FlownExposure flown) {
        return new RouteProfile(points.stream()
                .map(point -> point.withExposure(
                        point == end() ? flown.hitsUntil(Double.POSITIVE_INFINITY) : flown.hitsUntil(point.time())))
                .toList());
    }

    private static Position between(Position from, Position to, double share) {
        return from.plus(to.minus(from).times(share));
    }

    /** The last point of the route. */
    public RoutePoint end() {
        return points.get(points.size() - 1);
    }

    /** The exposure along the whole route. */
    public double exposure() {
        return end().exposure();
    }

    /** The probability that the drone is detected at least once on the route, in time or not, 0 to 1. */
    public double detection() {
        return -Math.expm1(-exposure());
    }

    /**
     * The median time of the first detection, given that there is one, s since the start; empty if the drone cannot be
     * detected.
     */
    public OptionalDouble medianDetection() {
        double all = detection();
        if (!(all > 0.0)) {
            return OptionalDouble.empty();
        }
        double wanted = -Math.log1p(-0.5 * all);
        for (int i = 1; i < points.size(); i++) {
            RoutePoint before = points.get(i - 1);
            RoutePoint after = points.get(i);
            if (after.exposure() >= wanted) {
                double share = (wanted - before.exposure()) / (after.exposure() - before.exposure());
                return OptionalDouble.of(before.time() + share * (after.time() - before.time()));
            }
        }
        return OptionalDouble.of(end().time());
    }

    /** The exposure up to a time, s since the start. */
    public double exposureUntil(double time) {
        return at(time).exposure();
    }

    /**
     * Where the drone is at a time, s since the start: interpolated between two points; the last point after the end.
     */
    public RoutePoint at(double time) {
        for (int i = 1; i < points.size(); i++) {
            RoutePoint before = points.get(i - 1);
            RoutePoint after = points.get(i);
            if (after.time() > time) {
                return before.towards(after, Math.max(0.0, (time - before.time()) / (after.time() - before.time())));
            }
        }
        return end();
    }

    /** The median height above the ground over the time of the flight, m. */
    public double medianHeight() {
        if (points.size() == 1) {
            return end().above();
        }
        // Each piece is weighted by the time that the drone spends on it; pieces are in the order of height.
        double[][] pieces = new double[points.size() - 1][];
        Arrays.setAll(pieces, i -> new double[] {
            0.5 * (points.get(i).above() + points.get(i + 1).above()),
            points.get(i + 1).time() - points.get(i).time()
        });
        Arrays.sort(pieces, (a, b) -> Double.compare(a[0], b[0]));
        double left = 0.5 * end().time();
        for (double[] piece : pieces) {
            left -= piece[1];
            if (left <= 0.0) {
                return piece[0];
            }
        }
        return pieces[pieces.length - 1][0];
    }
}
