package org.dronewatch.sensor;

import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Check;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/** The aim of a sensor: a position at which it points, or a direction. */
public sealed interface Aim permits Aim.Direction, Aim.Target {
    /** The minimum distance from a sensor to the point at which it aims, m. */
    double NEAREST = 0.001;

    /**
     * A vector of any non-zero length from a sensor, in the direction in which the sensor points.
     *
     * @param sensor position of the sensor, m
     * @throws IllegalArgumentException when the point at which the sensor aims is less than a millimetre away
     */
    Position from(Position sensor);

    /**
     * An aim at a point, wherever the sensor is.
     *
     * @param lookAt the point, m
     */
    record Target(Position lookAt) implements Aim {
        /** Checks that the point is not null. */
        public Target {
            Limits.check(Target.class, lookAt);
        }

        @Override
        public Position from(Position sensor) {
            Position vector = lookAt.minus(sensor);
            Check.atLeast("distance from 'position' to 'lookAt'", vector.length(), NEAREST, Quantity.LENGTH);
            return vector;
        }
    }

    /**
     * An aim in a direction.
     *
     * @param azimuth azimuth of the axis, clockwise from north as on a compass, -4 pi to 4 pi, rad
     * @param elevation elevation of the axis above the horizon, -pi/2 to pi/2, rad
     */
    record Direction(
            @In(value = Quantity.ANGLE, from = -In.TWO_TURNS, to = In.TWO_TURNS) double azimuth,
            @In(value = Quantity.ANGLE, from = -Math.PI / 2, to = Math.PI / 2) double elevation)
            implements Aim {
        /** A horizontal aim towards the north. */
        @Defaults
        public static final Direction DEFAULT = new Direction(0.0, 0.0);

        /** The direction in which a positioner points; an azimuth beyond two full turns is reduced to -pi to pi. */
        public static Direction of(org.dronewatch.positioner.Direction pointing) {
            double azimuth = Math.abs(pointing.azimuth()) > In.TWO_TURNS
                    ? Math.IEEEremainder(pointing.azimuth(), 2.0 * Math.PI)
                    : pointing.azimuth();
            return new Direction(azimuth, pointing.elevation());
        }

        /** Checks the limits. */
        public Direction {
            Limits.check(Direction.class, azimuth, elevation);
        }

        @Override
        public Position from(Position sensor) {
            double level = Math.cos(elevation);
            return new Position(level * Math.sin(azimuth), level * Math.cos(azimuth), Math.sin(elevation));
        }
    }
}
