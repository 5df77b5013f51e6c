package org.dronewatch.flight;

import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;

/**
 * Where a drone is at one moment, and how it moves.
 *
 * @param position of the drone's origin, m
 * @param velocity m/s
 * @param heading where its nose points, clockwise from north, rad
 * @param gliding how long its motors have been off, s; empty while they run
 */
public record FlightState(Position position, Position velocity, double heading, OptionalDouble gliding) {

    /** A state with running motors. */
    public FlightState(Position position, Position velocity, double heading) {
        this(position, velocity, heading, OptionalDouble.empty());
    }

    /** Whether its motors run. */
    public boolean isPowered() {
        return gliding.isEmpty();
    }
}
