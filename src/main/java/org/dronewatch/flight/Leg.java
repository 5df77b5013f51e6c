package org.dronewatch.flight;

import java.util.List;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;

/**
 * A part of a flight with constant velocity and attitude, from its start until the next leg begins. Steered and
 * recorded flights consist of legs, and compute positions by the same arithmetic, so that a recorded flight repeats the
 * steered one bit for bit.
 *
 * @param time time at which the leg begins, seconds since the start of the run
 * @param start state of the drone at that time
 */
public record Leg(double time, FlightState start) {

    /**
     * The state at a time within the leg, seconds since the start of the run: the drone has moved from the start at
     * constant velocity, and its attitude is unchanged.
     */
    public FlightState at(double when) {
        double since = when - time;
        Position moved = start.position().plus(start.velocity().times(since));
        OptionalDouble gliding = start.gliding().isPresent()
                ? OptionalDouble.of(start.gliding().getAsDouble() + since)
                : OptionalDouble.empty();
        return new FlightState(moved, start.velocity(), start.attitude(), gliding);
    }

    /**
     * The state at a time, seconds since the start of the run: in the last leg that has begun by then, or in the first
     * leg if none has.
     *
     * @param legs the legs, at least one, in order of time
     */
    public static FlightState at(List<Leg> legs, double time) {
        int low = 0;
        int high = legs.size() - 1;
        while (low < high) {
            int middle = (low + high + 1) >>> 1;
            if (legs.get(middle).time <= time) {
                low = middle;
            } else {
                high = middle - 1;
            }
        }
        return legs.get(low).at(time);
    }
}
