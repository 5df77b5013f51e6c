package org.dronewatch.route.search;

import org.dronewatch.drone.FlightLimits;
import org.dronewatch.route.exposure.LegMotion;

/**
 * A mode in which a drone flies, such as under power or gliding.
 *
 * @param name name of the mode, such as {@code powered}
 * @param speed speed along the path, above 0, m/s
 * @param climb greatest rate of climb, above 0, m/s; may be infinite
 * @param sink greatest rate of descent, above 0, m/s; may be infinite
 * @param steepest the greatest slope of the path, height gained over horizontal distance; negative for a glide,
 *     infinite for no limit
 * @param slowest the minimum speed along the path, 0 to {@code speed}, m/s; 0 for a drone that can hover
 */
public record RouteMode(String name, double speed, double climb, double sink, double steepest, double slowest) {
    /** The name of flight under power below the cruise speed. */
    private static final String SLOW = "slow";

    /** Slopes count as equal within this, so that the best glide between two nodes is not lost to rounding. */
    private static final double ROUNDING = 1e-9;

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public RouteMode {
        if (!(speed > 0.0 && speed < Double.POSITIVE_INFINITY && climb > 0.0 && sink > 0.0) || Double.isNaN(steepest)) {
            throw new IllegalArgumentException(
                    "mode " + name + " with speed " + speed + ", climb " + climb + ", sink " + sink + " m/s and slope "
                            + steepest + ": all but the slope must be above 0, and the slope a number");
        }
        if (!(slowest >= 0.0 && slowest <= speed)) {
            throw new IllegalArgumentException(
                    "mode " + name + " with a minimum speed of " + slowest + " m/s: it must be 0 to " + speed + " m/s");
        }
    }

    /** A mode in which the drone can fly as slowly as it likes. */
    public RouteMode(String name, double speed, double climb, double sink, double steepest) {
        this(name, speed, climb, sink, steepest, 0.0);
    }

    /** A mode without limits on climb, descent or slope. */
    public static RouteMode free(String name, double speed) {
        return new RouteMode(name, speed, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
    }

    /** Flight under power at the cruise speed, given in m/s. */
    public static RouteMode powered(FlightLimits limits, double cruise) {
        return new RouteMode(
                "powered",
                cruise,
                limits.climb(),
                limits.sink(),
                Double.POSITIVE_INFINITY,
                limits.hover() ? 0.0 : Math.min(cruise, limits.leastSpeed()));
    }

    /** Flight under power at a given speed below the cruise speed, m/s, by a drone that can hover. */
    public static RouteMode slow(FlightLimits limits, double speed) {
        return new RouteMode(SLOW, speed, limits.climb(), limits.sink(), Double.POSITIVE_INFINITY);
    }

    /**
     * A glide with the motors off, at the best glide ratio or steeper.
     *
     * @throws IllegalArgumentException if the drone cannot glide
     */
    public static RouteMode glide(FlightLimits limits) {
        if (!(limits.glideRatio() > 0.0)) {
            throw new IllegalArgumentException("glide ratio 0: the drone cannot glide");
        }
        return new RouteMode(
                "glide",
                limits.glideSpeed(),
                Double.POSITIVE_INFINITY,
                Double.POSITIVE_INFINITY,
                -1.0 / limits.glideRatio());
    }

    /**
     * The motion on a heading, given in rad clockwise from north: in level flight or, for a glide, at the best glide
     * ratio.
     */
    public LegMotion motion(double heading) {
        double slope = isGlide() ? steepest : 0.0;
        double level = speed / Math.sqrt(1.0 + slope * slope);
        return new LegMotion(heading, level * StrictMath.sin(heading), level * StrictMath.cos(heading), slope * level);
    }

    /** The motion straight up or down, as fast as the limits allow; not for a glide. */
    LegMotion vertical(boolean isUp) {
        double rise = isUp ? 1.0 : -1.0;
        return new LegMotion(0.0, 0.0, 0.0, rise * greatestSpeed(0.0, rise));
    }

    /** Whether the drone flies slowly on purpose, to avoid detection. */
    public boolean isSlow() {
        return name.equals(SLOW);
    }

    /** Whether the drone can only descend in this mode. */
    public boolean isGlide() {
        return steepest < 0.0;
    }

    /**
     * The shortest time for a straight leg, s; infinite where the leg is too steep. A leg that climbs or descends
     * faster than the limits allow at this speed is flown more slowly, but not below the minimum speed.
     *
     * @param horizontal horizontal length of the leg, m
     * @param rise height gained from its beginning to its end, m
     */
    public double time(double horizontal, double rise) {
        if (rise > steepest * horizontal + ROUNDING * (horizontal + Math.abs(rise))) {
            return Double.POSITIVE_INFINITY;
        }
        double length = Math.sqrt(horizontal * horizontal + rise * rise);
        double time = Math.max(length / speed, rise > 0.0 ? rise / climb : -rise / sink);
        return slowest * time > length * (1.0 + ROUNDING) ? Double.POSITIVE_INFINITY : time;
    }

    /**
     * The least horizontal length of a leg that climbs or descends, m: at the least speed, and as fast as the limits
     * allow; 0 where it may be vertical.
     *
     * @param rise height gained from its beginning to its end, m
     */
    double leastLength(double rise) {
        double length = slowest * Math.abs(rise) / (rise > 0.0 ? climb : sink);
        return length > Math.abs(rise) ? Math.sqrt(length * length - rise * rise) : 0.0;
    }

    /**
     * The greatest speed on a straight leg that is not too steep, m/s.
     *
     * @param horizontal horizontal length of the leg, m
     * @param rise height gained from its beginning to its end, m
     */
    double greatestSpeed(double horizontal, double rise) {
        double length = Math.sqrt(horizontal * horizontal + rise * rise);
        double vertical = rise > 0.0 ? climb : sink;
        return vertical * length < speed * Math.abs(rise) ? vertical * length / Math.abs(rise) : speed;
    }
}
