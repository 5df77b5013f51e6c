package org.dronewatch.flight;

/** Where a drone is at any time. Immutable. */
@FunctionalInterface
public interface FlightPath {

    /**
     * The drone's state at a time.
     *
     * @param time seconds since the start of the run, 0 or more
     */
    FlightState at(double time);
}
