package org.dronewatch.flight;

import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;

/**
 * The state of a drone at one time: position, velocity and attitude.
 *
 * @param position position of the drone's origin, m
 * @param velocity velocity of the drone, m/s
 * @param attitude yaw, pitch and roll; independent of the velocity, since a multirotor can fly sideways
 * @param gliding time since the motors were stopped, s; empty while they run
 */
public record FlightState(Position position, Position velocity, Attitude attitude, OptionalDouble gliding) {

    /** A state with the motors running. */
    public FlightState(Position position, Position velocity, Attitude attitude) {
        this(position, velocity, attitude, OptionalDouble.empty());
    }

    /** A state with level attitude and the nose at a heading, clockwise from north, rad. */
    public FlightState(Position position, Position velocity, double heading, OptionalDouble gliding) {
        this(position, velocity, Attitude.level(heading), gliding);
    }

    /** A state with the motors running, level attitude and the nose at a heading, clockwise from north, rad. */
    public FlightState(Position position, Position velocity, double heading) {
        this(position, velocity, heading, OptionalDouble.empty());
    }

    /** This state with another attitude. */
    public FlightState withAttitude(Attitude other) {
        return new FlightState(position, velocity, other, gliding);
    }

    /** The heading of the drone's nose, clockwise from north, rad: the yaw. */
    public double heading() {
        return attitude.yaw();
    }

    /** Whether the drone's motors run. */
    public boolean isPowered() {
        return gliding.isEmpty();
    }
}
