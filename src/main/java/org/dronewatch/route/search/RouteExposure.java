package org.dronewatch.route.search;

import java.util.List;
import org.dronewatch.geometry.Position;

/**
 * The exposure along a path, {@code E = integral of the rate over the time}: Gauss's rule with three points on pieces
 * that are not longer than half the distance between neighbouring posts. Immutable and thread-safe.
 */
public final class RouteExposure {
    private static final double OFF_CENTRE = Math.sqrt(0.6);
    private static final double AT_CENTRE = 4.0 / 9.0;
    private static final double OUTSIDE = 5.0 / 18.0;

    private final ExposureField field;
    private final RouteMode[] modes;
    private final double step;

    /** The integral in a problem. */
    public RouteExposure(RouteProblem problem) {
        this(problem.field(), problem.modes(), 0.5 * problem.grid().spacing());
    }

    /**
     * An integral.
     *
     * @param step the greatest length of a piece, above 0, m
     */
    public RouteExposure(ExposureField field, List<RouteMode> modes, double step) {
        this.field = field;
        this.modes = modes.toArray(RouteMode[]::new);
        this.step = step;
    }

    /** The exposure along a path; infinite if a leg cannot be flown. */
    public double along(RoutePath path) {
        double sum = 0.0;
        for (int i = 0; i < path.modes().size(); i++) {
            sum += leg(
                    path.points().get(i), path.points().get(i + 1), path.modes().get(i));
        }
        return sum;
    }

    /** The time for a path, s; infinite if a leg cannot be flown. */
    double time(RoutePath path) {
        double sum = 0.0;
        for (int i = 0; i < path.modes().size(); i++) {
            sum += time(
                    path.points().get(i), path.points().get(i + 1), path.modes().get(i));
        }
        return sum;
    }

    /** The time for a straight leg, s; infinite if it cannot be flown. */
    public double time(Position from, Position to, int mode) {
        return modes[mode].time(Math.hypot(to.x() - from.x(), to.y() - from.y()), to.z() - from.z());
    }

    /** The exposure along a straight leg; infinite if it cannot be flown. */
    public double leg(Position from, Position to, int mode) {
        return leg(from.x(), from.y(), from.z(), to.x(), to.y(), to.z(), mode);
    }

    /** The same by coordinates, m. */
    double leg(double x, double y, double z, double toX, double toY, double toZ, int mode) {
        double dx = toX - x;
        double dy = toY - y;
        double dz = toZ - z;
        double horizontal = Math.sqrt(dx * dx + dy * dy);
        double time = modes[mode].time(horizontal, dz);
        if (!(time > 0.0) || time == Double.POSITIVE_INFINITY) {
            return time;
        }
        LegMotion motion = LegMotion.along(dx, dy, dz, time);
        int pieces = Math.max(1, (int) Math.ceil(Math.sqrt(horizontal * horizontal + dz * dz) / step));
        double sum = 0.0;
        for (int i = 0; i < pieces; i++) {
            double middle = (i + 0.5) / pieces;
            double off = 0.5 * OFF_CENTRE / pieces;
            double before = middle - off;
            double after = middle + off;
            sum += AT_CENTRE * field.rate(x + middle * dx, y + middle * dy, z + middle * dz, motion, mode)
                    + OUTSIDE
                            * (field.rate(x + before * dx, y + before * dy, z + before * dz, motion, mode)
                                    + field.rate(x + after * dx, y + after * dy, z + after * dz, motion, mode));
        }
        return time * sum / pieces;
    }
}
