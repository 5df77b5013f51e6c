package org.dronewatch.flight;

import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;

/**
 * A path on which the drone leans as its type of airframe requires.
 *
 * @param path path along which the drone flies
 * @param airframe type of airframe, which determines how the drone leans
 */
record LeaningPath(FlightPath path, Airframe airframe) implements FlightPath {
    private static final Position AGAINST_GRAVITY = new Position(0.0, 0.0, Airframe.GRAVITY);

    @Override
    public FlightState at(double time) {
        FlightState state = path.at(time);
        if (!state.attitude().isLevel()) {
            return state;
        }
        Position force = path.acceleration(time).plus(AGAINST_GRAVITY);
        return state.withAttitude(airframe.lean(state.heading(), state.velocity(), force));
    }

    /** Leaning does not change the drone's position. */
    @Override
    public Position position(double time) {
        return path.position(time);
    }

    @Override
    public OptionalDouble topSpeed() {
        return path.topSpeed();
    }

    @Override
    public Position acceleration(double time) {
        return path.acceleration(time);
    }
}
