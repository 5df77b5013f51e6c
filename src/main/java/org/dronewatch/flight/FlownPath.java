package org.dronewatch.flight;

import java.util.List;
import java.util.Optional;
import org.dronewatch.geometry.Position;

/** A flight that consists of legs. */
public interface FlownPath extends FlightPath {
    /**
     * The shortest interval over which an acceleration is computed, s; over a shorter one, rounding errors would
     * dominate.
     */
    double SHORTEST_INTERVAL = 1e-9;

    /** The legs that have begun so far, in order of time; there is at least one, and the first begins at time 0. */
    List<Leg> legs();

    /**
     * The mean acceleration, m/s2, over the half second before a time, or since the start of the run if that is later.
     * The interval ends at the given time because the future of a steered drone is not known, and a recorded flight
     * must tilt like the steered one. The acceleration is zero within the first nanosecond of the run.
     */
    @Override
    default Position acceleration(double time) {
        double from = Math.max(0.0, time - 2.0 * HALF_INTERVAL);
        return time - from > SHORTEST_INTERVAL
                ? at(time).velocity().minus(at(from).velocity()).times(1.0 / (time - from))
                : new Position(0, 0, 0);
    }

    /**
     * The given path as one that consists of legs, whose attitudes do not include the tilt of an accelerating drone;
     * empty if the path does not consist of legs.
     */
    static Optional<FlownPath> in(FlightPath path) {
        if (path instanceof LeaningPath leaning) {
            return in(leaning.path());
        }
        return path instanceof FlownPath flown ? Optional.of(flown) : Optional.empty();
    }
}
