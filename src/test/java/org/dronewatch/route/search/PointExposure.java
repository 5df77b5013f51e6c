package org.dronewatch.route.search;

import org.dronewatch.geometry.Position;
import org.dronewatch.route.exposure.ExposureField;
import org.dronewatch.route.exposure.LegMotion;

/**
 * The textbook sensor: a rate of K / d^n at the distance d.
 *
 * @param at where it is, m
 * @param strength K
 * @param power n, 1 or 2
 */
public record PointExposure(Position at, double strength, int power) implements ExposureField {
    static PointExposure of(double x, double y, int power) {
        return new PointExposure(new Position(x, y, 0.0), 1.0, power);
    }

    @Override
    public double rate(double x, double y, double z, LegMotion motion, int mode) {
        double square = square(x - at.x()) + square(y - at.y()) + square(z - at.z());
        return strength / (power == 2 ? square : Math.sqrt(square));
    }

    /** That at the farthest corner. */
    @Override
    public double least(Position low, Position high, int mode) {
        double square = square(Math.max(at.x() - low.x(), high.x() - at.x()))
                + square(Math.max(at.y() - low.y(), high.y() - at.y()))
                + square(Math.max(at.z() - low.z(), high.z() - at.z()));
        return strength / (power == 2 ? square : Math.sqrt(square));
    }

    private static double square(double value) {
        return value * value;
    }
}
