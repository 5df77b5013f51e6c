package org.dronewatch.route.search;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;

/**
 * Turns the last leg of a path so that it arrives as early as it can: the bearing and the slope are changed in ever
 * smaller steps. The time is quasi-convex in both if the zone is convex. For a single use; not thread-safe.
 */
final class LastLeg {
    private static final double FIRST = 0.2;
    private static final double SMALLEST = 1e-4;

    /** How far beyond the end of the leg a zone is looked for, in distances between nodes. */
    private static final double BEYOND = 10.0;

    /** Two positions that are no farther apart in plan view have no bearing, m. */
    private static final double SAME = 1e-6;

    private final RouteExposure times;
    private final LegLimits limits;
    private final RouteEnd arrival;
    private final double spacing;
    private final Position before;

    /**
     * A leg.
     *
     * @param clock a problem whose exposure is the time
     * @param before a point on the leg before the path, or its first point if there is none
     */
    LastLeg(RouteProblem clock, RouteEnd arrival, Position before) {
        this.times = new RouteExposure(clock);
        this.limits = new LegLimits(clock);
        this.arrival = arrival;
        this.spacing = clock.grid().spacing();
        this.before = before;
    }

    /** The path with its last leg turned; it does not take longer. */
    RoutePath of(RoutePath path) {
        int legs = path.modes().size();
        if (legs == 0) {
            return path;
        }
        Position from = path.points().get(legs - 1);
        Position to = path.points().get(legs);
        double horizontal = Math.hypot(to.x() - from.x(), to.y() - from.y());
        if (horizontal <= SAME) {
            return path;
        }
        List<Position> points = new ArrayList<>(path.points());
        points.set(legs, turned(from, to, horizontal, path.modes().get(legs - 1), corner(path)));
        return new RoutePath(points, path.modes());
    }

    /** The point before the beginning of the last leg; the beginning itself if there is none before it. */
    private Position corner(RoutePath path) {
        int legs = path.modes().size();
        return legs > 1 ? path.points().get(legs - 2) : before;
    }

    private Position turned(Position from, Position to, double horizontal, int mode, Position corner) {
        double[] course = {StrictMath.atan2(to.x() - from.x(), to.y() - from.y()), (to.z() - from.z()) / horizontal};
        double reach = horizontal + BEYOND * spacing;
        Position best = to;
        double least = times.time(from, to, mode);
        for (double step = FIRST; step > SMALLEST; ) {
            boolean isFaster = false;
            for (int i = 0; i < 2 * course.length; i++) {
                double kept = course[i / 2];
                course[i / 2] += i % 2 == 0 ? step : -step;
                Position end = end(from, course, reach);
                double time = times.time(from, end, mode);
                if (time < least && isAllowed(corner, from, end)) {
                    least = time;
                    best = end;
                    isFaster = true;
                } else {
                    course[i / 2] = kept;
                }
            }
            step = isFaster ? step : 0.5 * step;
        }
        return best;
    }

    /** Where a leg on a bearing and a slope arrives; where it begins if it never does. */
    private Position end(Position from, double[] course, double reach) {
        Position far = from.plus(
                new Position(reach * StrictMath.sin(course[0]), reach * StrictMath.cos(course[0]), reach * course[1]));
        OptionalDouble entry = arrival.entry(from, far);
        return entry.isPresent()
                ? from.plus(far.minus(from).times(RouteFinish.share(entry.getAsDouble(), from, far)))
                : from;
    }

    private boolean isAllowed(Position corner, Position from, Position end) {
        return !end.equals(from)
                && limits.isTurnable(
                        from.x() - corner.x(), from.y() - corner.y(), end.x() - from.x(), end.y() - from.y())
                && limits.isOpen(from.x(), from.y(), from.z(), end.x(), end.y(), end.z());
    }
}
