package org.dronewatch.route.search;

import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.exposure.ExposureField;
import org.dronewatch.route.exposure.LegMotion;

/**
 * The exposure along a path, {@code E = integral of the rate over time}, as the field integrates it: by default, by
 * Gaussian quadrature on pieces no longer than half the distance between neighbouring nodes. Immutable and thread-safe.
 */
public final class RouteExposure {
    private final ExposureField field;
    private final RouteMode[] modes;
    private final double step;

    /** The exposure in the field of a problem. */
    public RouteExposure(RouteProblem problem) {
        this(problem.field(), problem.modes(), 0.5 * problem.grid().spacing());
    }

    /**
     * The exposure in a field.
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

    /**
     * The time for a straight leg in a mode, given by its number, s; infinite if the leg cannot be flown in this mode.
     */
    public double time(Position from, Position to, int mode) {
        return modes[mode].time(Math.hypot(to.x() - from.x(), to.y() - from.y()), to.z() - from.z());
    }

    /**
     * The exposure along a straight leg in a mode, given by its number; infinite if the leg cannot be flown in this
     * mode.
     */
    public double leg(Position from, Position to, int mode) {
        return leg(from.x(), from.y(), from.z(), to.x(), to.y(), to.z(), mode);
    }

    /** The exposure along a straight leg given by coordinates, m. */
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
        return time * field.mean(new Position(x, y, z), new Position(toX, toY, toZ), motion, mode, step);
    }
}
