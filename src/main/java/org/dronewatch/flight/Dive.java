package org.dronewatch.flight;

import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.world.Ground;

/**
 * A level and straight flight towards a point, followed by a dive onto it, at cruise speed from the beginning; the
 * drone stays at the point.
 *
 * @param target the point, m
 * @param bearing bearing of the approaching drone from the target, clockwise from north, rad
 * @param distance horizontal distance from the target at time 0, greater than the distance at which the dive begins, at
 *     most 100,000 m
 * @param height height of the level flight above the target, above 0 and at most 100,000 m
 * @param angle angle of the dive below the horizontal, rad, pi/18 to pi/2 (10 to 90 degrees)
 */
public record Dive(
        Position target,
        @In(value = Quantity.ANGLE, from = -In.TWO_TURNS, to = In.TWO_TURNS) double bearing,
        @In(value = Quantity.LENGTH, above = 0, to = In.FARTHEST) double distance,
        @In(value = Quantity.LENGTH, above = 0, to = In.FARTHEST) double height,
        @In(value = Quantity.ANGLE, from = Math.PI / 18, to = Math.PI / 2) double angle)
        implements FlightPathSettings {
    /** Checks the limits, and that the dive begins after the start. */
    public Dive {
        Limits.check(Dive.class, target, bearing, distance, height, angle);
        double diving = diving(height, angle);
        if (distance <= diving) {
            throw new IllegalArgumentException("distance " + (float) distance + " m must be above " + (float) diving
                    + " m, the distance at which the dive from height " + (float) height + " m begins");
        }
    }

    /** A flight from the north, and a dive at 60 degrees. */
    @Defaults({"target", "distance", "height"})
    public static Dive from(Position target, double distance, double height) {
        return new Dive(target, 0.0, distance, height, Math.PI / 3);
    }

    /** Horizontal distance from the target at which the dive begins, m; at most 100 km. */
    private static double diving(double height, double angle) {
        return height / Math.tan(angle);
    }

    private Position over(double range) {
        return target.plus(new Position(range * Math.sin(bearing), range * Math.cos(bearing), height));
    }

    @Override
    public FlightPath create(double speed, double acceleration, Ground ground) {
        Position top = over(diving(height, angle));
        Position start = over(distance);
        FlightPath cruise = new Approach(start, top).create(speed, acceleration, ground);
        FlightPath dive = new Approach(top, target).create(speed, acceleration, ground);
        double cruising = start.distance(top) / speed;
        // A dive straight down has no compass heading: the nose keeps its heading.
        double heading = cruise.at(0.0).heading();
        return time -> {
            FlightState state = time < cruising ? cruise.at(time) : dive.at(time - cruising);
            return new FlightState(state.position(), state.velocity(), heading);
        };
    }
}
