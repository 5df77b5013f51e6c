package org.dronewatch.flight;

import org.dronewatch.geometry.Position;

/**
 * A path on which the drone leans as its type of airframe requires.
 *
 * @param path where it flies
 * @param airframe how it leans
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

    @Override
    public Position acceleration(double time) {
        return path.acceleration(time);
    }
}
