package org.dronewatch.scene;

import java.util.Optional;
import java.util.function.DoubleSupplier;
import java.util.function.ObjDoubleConsumer;
import org.dronewatch.flight.Attitude;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.flight.FlightState;
import org.dronewatch.flight.FlownPath;
import org.dronewatch.flight.SteeredFlight;
import org.dronewatch.geometry.Position;

/**
 * A drone during a run, at the simulator's time: where any drone is, and commands for those whose flight is {@code
 * steered}. A command counts from now until the next one; between two commands velocity and attitude are constant, and the
 * position follows from them. Of several commands at one time the last counts. A command from a listener of
 * a scene's observations takes effect just after that look.
 *
 * <p>A drone whose flight is {@code recorded} flies as it did: commands change nothing, so a scene with its pilot can be
 * replayed.
 */
public final class DroneInFlight {
    private final String id;
    private final FlightPath path;
    private final DoubleSupplier clock;

    DroneInFlight(String id, FlightPath path, DoubleSupplier clock) {
        this.id = id;
        this.path = path;
        this.clock = clock;
    }

    /** Its name in the scene. */
    public String id() {
        return id;
    }

    /** Whether commands change how it flies. */
    public boolean isSteered() {
        return SteeredFlight.in(path).isPresent();
    }

    /** Where it is now and how it moves, with all commands so far. */
    public FlightState state() {
        double now = clock.getAsDouble();
        SteeredFlight.in(path).ifPresent(flight -> flight.advance(now));
        return path.at(SteeredFlight.in(path).map(SteeredFlight::known).orElse(now));
    }

    /**
     * Where it was at a time.
     *
     * @param time seconds since the start of the run
     * @throws IllegalStateException when it is steered and the time is yet to come
     */
    public FlightState state(double time) {
        SteeredFlight.in(path).ifPresent(flight -> flight.advance(clock.getAsDouble()));
        return path.at(time);
    }

    /**
     * Flies with a velocity until the next command, level and with the nose where it is going; straight up, straight down
     * and at rest the nose stays as it is.
     *
     * @param velocity east, north and up, m/s
     * @throws IllegalArgumentException when that is faster than the drone's speed
     * @throws IllegalStateException when it is neither steered nor recorded, or the run is over
     */
    public void fly(Position velocity) {
        command((flight, now) -> flight.fly(now, velocity));
    }

    /**
     * Flies with a velocity and an attitude until the next command.
     *
     * @param velocity east, north and up, m/s
     * @param attitude yaw, pitch and roll; does not depend on the velocity
     * @throws IllegalArgumentException when that is faster than the drone's speed
     * @throws IllegalStateException when it is neither steered nor recorded, or the run is over
     */
    public void fly(Position velocity, Attitude attitude) {
        command((flight, now) -> flight.fly(now, velocity, attitude));
    }

    /**
     * Flies in a straight line at constant speed to a point and hovers there, until the next command.
     *
     * @param target the point, m
     * @param time when it is to be there, after now, seconds since the start of the run
     * @throws IllegalArgumentException when that takes more than the drone's speed, or the time is not after now
     * @throws IllegalStateException when it is neither steered nor recorded, or the run is over
     */
    public void flyTo(Position target, double time) {
        command((flight, now) -> flight.flyTo(now, target, time));
    }

    private void command(ObjDoubleConsumer<SteeredFlight> command) {
        Optional<SteeredFlight> flight = SteeredFlight.in(path);
        if (flight.isEmpty()) {
            if (FlownPath.in(path).isPresent()) {
                return;
            }
            throw new IllegalStateException(
                    "drone '" + id + "' cannot be steered: its flight is not of the kind 'steered'");
        }
        try {
            command.accept(flight.get(), clock.getAsDouble());
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException("drone '" + id + "': " + e.getMessage(), e);
        }
    }
}
