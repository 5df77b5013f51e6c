package org.dronewatch.route.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.dronewatch.geometry.Position;

/**
 * Makes a path over the nodes of a grid less exposed: points are left out where that costs nothing, and moved where it
 * gains something, in ever smaller steps, with more points from round to round; each leg under power is flown in the
 * mode in which it is least exposed. The result can be flown wherever the path could, and is not more exposed. For use
 * by one thread.
 */
final class RouteSmoothing {
    private static final int ROUNDS = 5;

    /** The fraction by which the exposure of two legs may increase when points are left out at the beginning. */
    private static final double COARSE = 0.02;

    private static final int SWEEPS = 40;

    /** A sweep that gains less than this fraction is the last one with its step. */
    private static final double GAIN = 1e-4;

    /** A leg is not split once it is shorter than this number of nodes. */
    private static final double SHORTEST = 1.5;

    private static final double OBLIQUE = Math.sqrt(0.5);

    /** The axes along which a point is moved: east, north, obliquely, and up. */
    private static final double[][] IN_SPACE = {
        {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {OBLIQUE, OBLIQUE, 0.0}, {OBLIQUE, -OBLIQUE, 0.0}, {0.0, 0.0, 1.0}
    };

    private static final double[][] IN_PLAN = Arrays.copyOf(IN_SPACE, 4);

    private final RouteProblem problem;
    private final RouteExposure exposure;
    private final LegLimits limits;
    private final double spacing;
    private final double[][] axes;
    private final Optional<Position> before;
    private final Optional<Position> next;
    private final List<double[]> points = new ArrayList<>();

    /** The mode of the leg that leaves each point. */
    private final List<Integer> modes = new ArrayList<>();

    private RouteSmoothing(RouteProblem problem, RoutePath path, Optional<Position> before, Optional<Position> next) {
        this.before = before;
        this.next = next;
        this.problem = problem;
        this.exposure = new RouteExposure(problem);
        this.limits = new LegLimits(problem);
        this.spacing = problem.grid().spacing();
        this.axes = problem.grid().levels() > 1 ? IN_SPACE : IN_PLAN;
        path.points().forEach(point -> points.add(new double[] {point.x(), point.y(), point.z()}));
        modes.addAll(path.modes());
    }

    /** The smoothed path; its ends stay where they are. */
    static RoutePath of(RouteProblem problem, RoutePath path) {
        return of(problem, path, Optional.empty(), Optional.empty());
    }

    /**
     * The smoothed path if another one continues it; at its end, the drone must be able to turn towards the first
     * corner of the other one.
     */
    static RoutePath before(RoutePath rest, RouteProblem problem, RoutePath path) {
        Optional<Position> next = rest.modes().isEmpty()
                ? Optional.empty()
                : Optional.of(rest.points().get(1));
        return of(problem, path, Optional.empty(), next);
    }

    /**
     * The smoothed path if it continues another one; the drone turns into it from a point on the last leg of the other
     * one.
     */
    static RoutePath after(Position before, RouteProblem problem, RoutePath path) {
        return of(problem, path, Optional.of(before), Optional.empty());
    }

    private static RoutePath of(
            RouteProblem problem, RoutePath path, Optional<Position> before, Optional<Position> next) {
        if (path.modes().isEmpty()) {
            return path;
        }
        RouteSmoothing smoothing = new RouteSmoothing(problem, path, before, next);
        RoutePath smooth = smoothing.smooth();
        boolean isBetter = smoothing.exposure.along(smooth) <= smoothing.exposure.along(path);
        return isBetter ? smooth : path;
    }

    private RoutePath smooth() {
        pull(0.0);
        // Few points at first: they move in long steps, and those put between them follow.
        pull(COARSE);
        for (int round = 0; round < ROUNDS; round++) {
            double coarse = Math.max(spacing, 0.25 * meanLeg());
            for (double step = coarse; step > spacing / 64.0; step *= 0.5) {
                moveAll(step);
            }
            changeModes();
            pull(0.0);
            if (round + 1 < ROUNDS) {
                split();
            }
        }
        List<Position> path = points.stream()
                .map(point -> new Position(point[0], point[1], point[2]))
                .toList();
        return new RoutePath(path, modes);
    }

    /** Flies every leg under power in the mode in which it is least exposed. */
    private void changeModes() {
        for (int i = 0; i < modes.size(); i++) {
            for (int other = 0; other < problem.modes().size(); other++) {
                int mode = modes.get(i);
                if (problem.isExchangeable(mode, other)
                        && cost(points.get(i), points.get(i + 1), other)
                                < cost(points.get(i), points.get(i + 1), mode)) {
                    modes.set(i, other);
                }
            }
        }
    }

    private double meanLeg() {
        double length = 0.0;
        for (int i = 0; i < modes.size(); i++) {
            length += length(points.get(i), points.get(i + 1));
        }
        return length / modes.size();
    }

    private static double length(double[] from, double[] to) {
        return Math.sqrt(square(to[0] - from[0]) + square(to[1] - from[1]) + square(to[2] - from[2]));
    }

    private static double square(double value) {
        return value * value;
    }

    private double cost(double[] from, double[] to, int mode) {
        return exposure.leg(from[0], from[1], from[2], to[0], to[1], to[2], mode);
    }

    private boolean isOpen(double[] from, double[] to) {
        return limits.isOpen(from[0], from[1], from[2], to[0], to[1], to[2]);
    }

    /**
     * Leaves out every point whose neighbours can be joined at no greater exposure.
     *
     * @param loss the fraction by which the exposure may increase nevertheless, 0 or more
     */
    private void pull(double loss) {
        boolean isShorter = true;
        while (isShorter) {
            isShorter = false;
            for (int i = points.size() - 2; i > 0; i--) {
                isShorter |= leaveOut(i, loss);
            }
        }
    }

    private boolean leaveOut(int i, double loss) {
        int before = modes.get(i - 1);
        int after = modes.get(i);
        if (before != after && !problem.isExchangeable(before, after)) {
            return false;
        }
        double[] from = points.get(i - 1);
        double[] at = points.get(i);
        double[] to = points.get(i + 1);
        double allowed = (1.0 + loss) * local(i);
        int mode = cost(from, to, before) <= cost(from, to, after) ? before : after;
        if (cost(from, to, mode) > allowed || !isOpen(from, to)) {
            return false;
        }
        points.remove(i);
        modes.remove(i);
        modes.set(i - 1, mode);
        if (isTurnable(i - 1) && isTurnable(i)) {
            return true;
        }
        points.add(i, at);
        modes.add(i, after);
        modes.set(i - 1, before);
        return false;
    }

    /** Whether the corner at a point can be flown. */
    private boolean isTurnable(int i) {
        int last = points.size() - 1;
        boolean isFirst = i <= 0;
        boolean isLast = i >= last;
        if (isFirst && before.isEmpty() || isLast && next.isEmpty()) {
            return true;
        }
        double[] at = points.get(Math.max(0, Math.min(last, i)));
        double fromX = isFirst ? before.get().x() : points.get(Math.min(last, i) - 1)[0];
        double fromY = isFirst ? before.get().y() : points.get(Math.min(last, i) - 1)[1];
        double toX = isLast ? next.get().x() : points.get(Math.max(0, i) + 1)[0];
        double toY = isLast ? next.get().y() : points.get(Math.max(0, i) + 1)[1];
        return limits.isTurnable(at[0] - fromX, at[1] - fromY, toX - at[0], toY - at[1]);
    }

    /** Puts a point into the middle of every leg that is not short, if the turns at its ends need no more than half. */
    private void split() {
        for (int i = modes.size() - 1; i >= 0; i--) {
            double[] from = points.get(i);
            double[] to = points.get(i + 1);
            if (length(from, to) > SHORTEST * spacing) {
                points.add(
                        i + 1,
                        new double[] {0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1]), 0.5 * (from[2] + to[2])});
                modes.add(i + 1, modes.get(i));
                if (!isTurnable(i) || !isTurnable(i + 2)) {
                    points.remove(i + 1);
                    modes.remove(i + 1);
                }
            }
        }
    }

    private void moveAll(double step) {
        for (int sweep = 0; sweep < SWEEPS; sweep++) {
            double before = 0.0;
            double gained = 0.0;
            for (int i = 1; i < points.size() - 1; i++) {
                double local = local(i);
                before += local;
                gained += local > 0.0 ? local - move(i, local, step) : 0.0;
            }
            if (!(gained > GAIN * before)) {
                return;
            }
        }
    }

    /** The exposure of the two legs at a point. */
    private double local(int i) {
        return cost(points.get(i - 1), points.get(i), modes.get(i - 1))
                + cost(points.get(i), points.get(i + 1), modes.get(i));
    }

    /** Moves a point by a step along each axis where that gains something; returns the exposure of its two legs. */
    private double move(int i, double before, double step) {
        double best = before;
        double[] at = points.get(i);
        for (double[] axis : axes) {
            for (int sign = 1; sign >= -1; sign -= 2) {
                double[] kept = at.clone();
                for (int part = 0; part < at.length; part++) {
                    at[part] += sign * step * axis[part];
                }
                double moved = local(i);
                if (moved < best && isAllowed(i)) {
                    best = moved;
                    break;
                }
                System.arraycopy(kept, 0, at, 0, at.length);
            }
        }
        return best;
    }

    private boolean isAllowed(int i) {
        return isTurnable(i - 1)
                && isTurnable(i)
                && isTurnable(i + 1)
                && isOpen(points.get(i - 1), points.get(i))
                && isOpen(points.get(i), points.get(i + 1));
    }
}
