package org.dronewatch.sensor.radar;

import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;
import org.dronewatch.world.Ground;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * The part of the surface of a site that a radar sees between two ranges at a bearing: the elevations from the skyline
 * of everything within the nearer range up to the skyline of everything within the farther one. So anything in the
 * shadow of something nearer is left out, and slopes and walls count to the extent that they face the radar. The
 * assumption about the mesh is that everything below a skyline is blocked: no radar looks under a bridge. Where just
 * above the nearer skyline nothing lies within the farther range, as over the brink of a deep valley, all of the cell
 * is left out, even a steep opposite face in it. Allocates nothing but what {@link Ground} returns. For use by one
 * thread.
 */
final class VisibleGround {
    /** The precision of elevations, as a fraction of the angle that the cell fills if nothing hides it. */
    private static final double PRECISION = 1e-3;

    /** The finest precision of elevations, rad. */
    private static final double FINEST = 1e-9;

    private static final double STRAIGHT_UP = 0.5 * Math.PI;

    /** The first step of a search away from a guess, rad. */
    private static final double FIRST_STEP = 1e-3;

    /** The number of iterations: enough for the elevation of the ground at a range to converge. */
    private static final int STEPS = 8;

    private static final double SETTLED = 1e-9;

    private final Position radar;
    private final Visibility visibility;
    private final Ground ground;

    private double east;
    private double north;
    private double tolerance;
    private double low;
    private double high;

    /** The ground as seen from a position in a world. */
    VisibleGround(World world, Position radar) {
        this.radar = radar;
        this.visibility = new Visibility(world);
        this.ground = world.newGround();
    }

    /**
     * Looks at a bearing.
     *
     * @param azimuth azimuth of the bearing, clockwise from north, rad
     * @param near range at which the range cell begins, m; it begins at the radar itself if this is 0 or less
     * @param far range at which it ends, above 0, m
     * @return whether some of the surface in the cell is in sight, between the elevations {@link #low} and
     *     {@link #high}
     */
    boolean look(double azimuth, double near, double far) {
        east = Math.sin(azimuth);
        north = Math.cos(azimuth);
        double start = near > 0.0 ? elevation(near) : -STRAIGHT_UP;
        double end = elevation(far);
        double cell = Math.abs(end - start);
        tolerance = cell > 0.0 ? Math.max(FINEST, PRECISION * cell) : FINEST;
        low = near > 0.0 ? skyline(near, start, -STRAIGHT_UP) : -STRAIGHT_UP;
        if (!isBlocked(low, far)) {
            return false;
        }
        high = skyline(far, end, low);
        return high - low > 2.0 * tolerance;
    }

    /** The lowest elevation at which the surface in the cell is in sight, rad. */
    double low() {
        return low;
    }

    /** The highest elevation at which it is in sight, rad. */
    double high() {
        return high;
    }

    /**
     * The highest elevation at which something within a range blocks the view, rad.
     *
     * @param guess the skyline if nothing nearer is in the way, rad; NaN if unknown
     * @param floor lower limit of the result, rad
     */
    private double skyline(double range, double guess, double floor) {
        double first = Double.isNaN(guess) ? floor : Math.max(floor, guess);
        if (isBlocked(first + tolerance, range)) {
            return above(first + tolerance, range);
        }
        if (first - tolerance <= floor || isBlocked(first - tolerance, range)) {
            return first + tolerance;
        }
        return below(first - tolerance, floor, range);
    }

    /** The skyline above an elevation that is blocked. */
    private double above(double blocked, double range) {
        double lower = blocked;
        for (double step = FIRST_STEP; lower + step < STRAIGHT_UP; step *= 2.0) {
            double upper = lower + step;
            if (!isBlocked(upper, range)) {
                return between(lower, upper, range);
            }
            lower = upper;
        }
        return isBlocked(STRAIGHT_UP, range) ? STRAIGHT_UP : between(lower, STRAIGHT_UP, range);
    }

    /** The skyline below an elevation that is free. */
    private double below(double free, double floor, double range) {
        double upper = free;
        for (double step = FIRST_STEP; upper - step > floor; step *= 2.0) {
            double lower = upper - step;
            if (isBlocked(lower, range)) {
                return between(lower, upper, range);
            }
            upper = lower;
        }
        return isBlocked(floor, range) ? between(floor, upper, range) : floor;
    }

    /** Bisects an interval from a blocked to a free elevation, and returns the free end. */
    private double between(double blocked, double free, double range) {
        double lower = blocked;
        double upper = free;
        while (upper - lower > tolerance) {
            double middle = 0.5 * (lower + upper);
            if (isBlocked(middle, range)) {
                lower = middle;
            } else {
                upper = middle;
            }
        }
        return upper;
    }

    private boolean isBlocked(double elevation, double range) {
        double level = Math.cos(elevation);
        return !visibility.isFreeAlong(
                radar.x(), radar.y(), radar.z(), level * east, level * north, Math.sin(elevation), range);
    }

    /** The elevation of the highest surface at a range, rad; NaN where there is none. */
    private double elevation(double range) {
        double level = range;
        double rise = 0.0;
        for (int i = 0; i < STEPS; i++) {
            OptionalDouble height = ground.height(radar.x() + level * east, radar.y() + level * north);
            if (height.isEmpty()) {
                return Double.NaN;
            }
            rise = height.getAsDouble() - radar.z();
            double next = Math.sqrt(Math.max(0.0, range * range - rise * rise));
            boolean isSettled = Math.abs(next - level) < SETTLED * range;
            level = next;
            if (isSettled) {
                break;
            }
        }
        return Math.atan2(rise, level);
    }
}
