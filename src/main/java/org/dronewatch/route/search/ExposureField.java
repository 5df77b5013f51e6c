package org.dronewatch.route.search;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.dronewatch.geometry.Position;

/**
 * How exposed a drone is at a position: the rate at which it is detected, given that it has not been yet. Its integral
 * along a flight is the exposure E, and the flight is detected with the probability {@code 1 - exp(-E)}. A sensor
 * that looks f times a second, and in each look detects with the probability p independently of the others, has the
 * rate {@code -f ln(1 - p)}.
 *
 * <p>Implementations are immutable and thread-safe.
 */
public interface ExposureField {
    /**
     * The rate at a position, 1/s, 0 or more and finite wherever a drone may be.
     *
     * @param x east, m
     * @param y north, m
     * @param z up, m
     * @param heading clockwise from north, rad
     * @param mode number of the drone's {@link RouteMode}
     */
    double rate(double x, double y, double z, double heading, int mode);

    /**
     * The rate on a leg, 1/s, where speed or climb matter, too: by default, they do not.
     *
     * @param x east, m
     * @param y north, m
     * @param z up, m
     * @param motion of the drone
     * @param mode number of the drone's {@link RouteMode}
     */
    default double rate(double x, double y, double z, LegMotion motion, int mode) {
        return rate(x, y, z, motion.heading(), mode);
    }

    /**
     * The mean rate on a straight leg, 1/s: by default by Gauss's rule with three points on pieces of equal length. A
     * field whose rates jump states it exactly, so that no route is led through what lies between the points.
     *
     * @param from where the leg begins, m
     * @param to where it ends, elsewhere, m
     * @param motion of the drone
     * @param mode number of the drone's {@link RouteMode}
     * @param longest the greatest length of a piece, above 0, m
     */
    default double mean(Position from, Position to, LegMotion motion, int mode, double longest) {
        return GaussRule.mean(this, from, to, motion, mode, longest);
    }

    /**
     * A lower bound of the rates at all positions in a box, on all headings, 1/s, 0 or more; the tighter it is, the
     * tighter is the lower bound of a weakest route.
     *
     * @param low the corner of the box with the least coordinates, m
     * @param high the corner with the greatest, m
     * @param mode number of the drone's {@link RouteMode}
     */
    double least(Position low, Position high, int mode);

    /** This field with a constant added to the rate, 0 or more, 1/s: a price of time. */
    default ExposureField plus(double perSecond) {
        return new SummedExposure(List.of(this), perSecond);
    }

    /**
     * The field of independent sensors: their rates add. They are added in the order of their names, so that the order
     * in which they are given does not change a single bit of the sum.
     */
    static ExposureField ofSensors(Map<String, ExposureField> sensors) {
        return new SummedExposure(List.copyOf(new TreeMap<>(sensors).values()), 0.0);
    }
}
