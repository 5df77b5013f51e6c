package org.dronewatch.world;

import org.dronewatch.geometry.Position;

/**
 * Where a drone is at one moment and how it moves.
 *
 * @param position place of the drone's origin, m
 * @param velocity m/s
 * @param heading where its nose points, clockwise from north, rad
 * @param powered whether its motors run
 */
public record FlightState(Position position, Position velocity, double heading, boolean powered) {

    /** A state with running motors. */
    public FlightState(Position position, Position velocity, double heading) {
        this(position, velocity, heading, true);
    }
}
