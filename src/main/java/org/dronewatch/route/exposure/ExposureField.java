package org.dronewatch.route.exposure;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.dronewatch.geometry.Position;

/**
 * How exposed a drone is at a position: the rate at which it is detected, given that it has not been detected yet. Its
 * integral along a flight is the exposure E, and the flight is detected with the probability {@code 1 - exp(-E)}. A
 * sensor that looks f times a second and detects the drone in each look with probability p, independently of the other
 * looks, has the rate {@code -f ln(1 - p)}.
 *
 * <p>Implementations are immutable and thread-safe.
 */
public interface ExposureField {
    /**
     * The rate at a position, 1/s, 0 or more and finite wherever a drone may be.
     *
     * @param x east coordinate, m
     * @param y north coordinate, m
     * @param z height in the world, m
     * @param motion heading, speed and rate of climb
     * @param mode number of the drone's {@code RouteMode}
     */
    double rate(double x, double y, double z, LegMotion motion, int mode);

    /**
     * The mean rate on a straight leg, 1/s: by default, by three-point Gaussian quadrature on pieces of equal length. A
     * field with discontinuous rates must compute it exactly, so that no route can exploit what the points miss.
     *
     * @param from where the leg begins, m
     * @param to where the leg ends, m; a different point
     * @param motion motion of the drone
     * @param mode number of the drone's {@code RouteMode}
     * @param longest the greatest length of a piece, above 0, m
     */
    default double mean(Position from, Position to, LegMotion motion, int mode, double longest) {
        return GaussRule.mean(this, from, to, motion, mode, longest);
    }

    /**
     * A lower bound on the rates at all positions in a box and on all headings, 1/s, 0 or more; the tighter it is, the
     * tighter the lower bound on the exposure along the weakest route.
     *
     * @param low the corner of the box with the least coordinates, m
     * @param high the corner with the greatest coordinates, m
     * @param mode number of the drone's {@code RouteMode}
     */
    double least(Position low, Position high, int mode);

    /**
     * This field with a constant added to its rate, as a price of time.
     *
     * @param perSecond the constant, 0 or more, 1/s
     */
    default ExposureField plus(double perSecond) {
        return new SummedExposure(List.of(this), perSecond);
    }

    /** The sum of this field and another one. */
    default ExposureField plus(ExposureField other) {
        return new SummedExposure(List.of(this, other), 0.0);
    }

    /**
     * The field of independent sensors, whose rates add. The rates are added in the order of the sensors' names, so
     * that the order of the map does not change a single bit of the sum.
     */
    static ExposureField ofSensors(Map<String, ExposureField> sensors) {
        return new SummedExposure(List.copyOf(new TreeMap<>(sensors).values()), 0.0);
    }
}
