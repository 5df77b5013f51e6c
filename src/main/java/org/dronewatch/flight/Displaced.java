package org.dronewatch.flight;

import org.dronewatch.geometry.Position;
import org.dronewatch.world.Ground;

/**
 * A leader's flight displaced by a constant vector: the flight of a drone in a {@link Swarm}. Not a record of settings,
 * because scene files specify a swarm instead.
 */
public final class Displaced implements FlightPathSettings {
    private final FlightPathSettings leader;
    private final Position offset;

    /**
     * A flight displaced from another.
     *
     * @param leader the leader's flight
     * @param offset displacement to the right of the leader, ahead of it and above it, relative to its heading at time
     *     0, m
     */
    public Displaced(FlightPathSettings leader, Position offset) {
        this.leader = leader;
        this.offset = offset;
    }

    /** The leader's flight. */
    public FlightPathSettings leader() {
        return leader;
    }

    /**
     * The path displaced from the leader's path, for callers that already have the leader's path; {@link #create}
     * returns the same displaced path.
     */
    public FlightPath beside(FlightPath leading) {
        Position displacement = turned(offset, leading.at(0.0).heading());
        return time -> {
            FlightState state = leading.at(time);
            return new FlightState(
                    state.position().plus(displacement), state.velocity(), state.attitude(), state.gliding());
        };
    }

    /** An offset that is given to the right, ahead and above for a heading, transformed to the world, m. */
    static Position turned(Position offset, double heading) {
        double east = Math.sin(heading);
        double north = Math.cos(heading);
        return new Position(offset.x() * north + offset.y() * east, offset.y() * north - offset.x() * east, offset.z());
    }

    /** The offset from the leader: to the right, ahead and above, relative to the leader's heading at time 0, m. */
    public Position offset() {
        return offset;
    }

    @Override
    public FlightPath create(double speed, double acceleration, Ground ground) {
        return beside(leader.create(speed, acceleration, ground));
    }
}
