package org.dronewatch.flight;

import java.util.List;
import java.util.Optional;
import org.dronewatch.geometry.Position;

/** A flight that is made of legs. */
public interface FlownPath extends FlightPath {

    /** The legs that have begun so far, in order of time; at least one, of which the first begins at time 0. */
    List<Leg> legs();

    /**
     * The mean acceleration over the half second before a time, or since the start: what comes later is not known while
     * a drone is steered, and a recorded flight leans as the steered one did.
     */
    @Override
    default Position acceleration(double time) {
        double from = Math.max(0.0, time - 2.0 * HALF_INTERVAL);
        return time > from
                ? at(time).velocity().minus(at(from).velocity()).times(1.0 / (time - from))
                : new Position(0, 0, 0);
    }

    /** The legs that a path is made of, whether the drone leans on it or not; empty for any other path. */
    static Optional<FlownPath> in(FlightPath path) {
        if (path instanceof LeaningPath leaning) {
            return in(leaning.path());
        }
        return path instanceof FlownPath flown ? Optional.of(flown) : Optional.empty();
    }
}
