package org.dronewatch.placement.solver;

import org.dronewatch.placement.solver.Gains.Form;

/**
 * Decides whether a part of the search can be left out, because nothing in it exceeds the best choice found so far by
 * more than the gap that was asked for. If all gains are multiples of a unit, bounds are rounded down to such a
 * multiple.
 */
final class Cutoff {
    private static final double ROUNDING = 1e-9;
    private static final double WHOLE = 1e-6;
    private static final double MOST_UNITS = 1e9;

    private final Gains gains;
    private final Incumbent incumbent;
    private final double gap;
    private final double unit;
    private double closed = Double.NEGATIVE_INFINITY;

    Cutoff(Gains gains, Incumbent incumbent, double gap) {
        this.gains = gains;
        this.incumbent = incumbent;
        this.gap = gap;
        this.unit = unit(gains);
    }

    /** The unit of all gains: the least of them, or 1; 0 if there is none. */
    private static double unit(Gains gains) {
        double least = Double.POSITIVE_INFINITY;
        for (double[] values : gains.gains) {
            for (double value : values) {
                least = Math.min(least, value);
            }
        }
        boolean isPossible = gains.form != Form.SATURATED_SUM && least < Double.POSITIVE_INFINITY;
        return !isPossible ? 0.0 : isUnit(least, gains) ? least : isUnit(1.0, gains) ? 1.0 : 0.0;
    }

    private static boolean isUnit(double unit, Gains gains) {
        double sum = 0.0;
        for (double[] values : gains.gains) {
            for (double value : values) {
                double units = value / unit;
                sum += units;
                if (Math.abs(units - Math.rint(units)) > ROUNDING) {
                    return false;
                }
            }
        }
        return sum < MOST_UNITS;
    }

    /** Whether no better gain can hide below a bound. */
    boolean isHopeless(double bound) {
        if (!incumbent.isFound()) {
            return false;
        }
        double value = incumbent.value();
        double reachable = reachable(bound);
        double slack = Math.max(ROUNDING * Math.max(1.0, Math.abs(value)), gap * Math.abs(gains.reported(value)));
        if (reachable > value + slack) {
            return false;
        }
        closed = Math.max(closed, reachable);
        return true;
    }

    private double reachable(double bound) {
        return unit > 0.0 ? unit * Math.floor(bound / unit + WHOLE) : bound;
    }

    /** The most that the gain can be if no remaining part of the search has a greater bound than this. */
    double bound(double open) {
        double value = incumbent.value();
        double most = Math.max(closed, reachable(open));
        return most <= value + ROUNDING * Math.max(1.0, Math.abs(value)) ? value : most;
    }
}
