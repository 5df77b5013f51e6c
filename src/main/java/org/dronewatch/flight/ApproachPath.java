package org.dronewatch.flight;

import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;

/** A straight path at constant speed; the drone stays at its end. */
final class ApproachPath implements FlightPath {
    private final Position from;
    private final Position to;
    private final double length;
    private final Position direction;
    private final double heading;
    private final double speed;

    /**
     * A path from one point to another, m.
     *
     * @param heading heading of the drone, clockwise from north, rad
     * @param speed speed of the drone, m/s
     */
    ApproachPath(Position from, Position to, double heading, double speed) {
        Position leg = to.minus(from);
        this.from = from;
        this.to = to;
        this.length = leg.length();
        this.direction = leg.times(1.0 / length);
        this.heading = heading;
        this.speed = speed;
    }

    @Override
    public FlightState at(double time) {
        double flown = speed * time;
        return flown < length
                ? new FlightState(from.plus(direction.times(flown)), direction.times(speed), heading)
                : new FlightState(to, new Position(0, 0, 0), heading);
    }

    @Override
    public OptionalDouble topSpeed() {
        return OptionalDouble.of(speed);
    }
}
