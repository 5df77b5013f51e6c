package org.dronewatch.scene;

import java.util.List;
import java.util.Optional;
import java.util.function.DoubleSupplier;
import java.util.function.ObjDoubleConsumer;
import org.dronewatch.flight.Attitude;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.flight.FlightState;
import org.dronewatch.flight.FlownPath;
import org.dronewatch.flight.SteeredFlight;
import org.dronewatch.flight.SteeringClock;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.InputException;

/**
 * A drone during a run, at the simulator's time: its state, and commands if its flight is {@code steered}. A command
 * takes effect now and holds until the next one. Between two commands, velocity and attitude are constant, and the
 * position follows from the velocity; only a drone sent to a point by {@link #flyTo} stops there. If several commands
 * have the same time, the last one takes effect. A command that a listener gives in response to an observation takes
 * effect just after the look of that observation.
 *
 * <p>Only the thread that runs the scene may give commands, in a pilot, in events of the simulator or in listeners: a
 * command from another thread would take effect at whatever time the run happened to have reached, and the run could
 * not be repeated.
 *
 * <p>A drone whose flight is {@code recorded} flies as it did in the recorded run: commands change nothing, so a scene
 * with its pilot can be replayed.
 */
public final class DroneInFlight {
    private final String id;
    private final FlightPath path;
    private final SteeringClock steering;
    private final DoubleSupplier clock;

    DroneInFlight(String id, FlightPath path, DoubleSupplier clock) {
        this.id = id;
        this.path = path;
        this.steering = SteeringClock.of(List.of(path));
        this.clock = clock;
    }

    /** The name of the drone in the scene. */
    public String id() {
        return id;
    }

    /** Whether commands change the flight of the drone. */
    public boolean isSteered() {
        return SteeredFlight.in(path).isPresent();
    }

    /** The drone's position and motion now, with all commands so far. */
    public FlightState state() {
        double now = clock.getAsDouble();
        steering.advance(now);
        return path.at(isSteered() ? steering.known() : now);
    }

    /**
     * The drone's position and motion at a time.
     *
     * @param time seconds since the start of the run
     * @throws InputException when the time is negative, not finite, or, for a steered drone, yet to come
     */
    public FlightState state(double time) {
        if (!(time >= 0.0 && Double.isFinite(time))) {
            throw new InputException(here() + "its state at " + time + " s: the time must be 0 s or later");
        }
        double now = clock.getAsDouble();
        steering.advance(now);
        try {
            return path.at(time);
        } catch (IllegalStateException e) {
            throw new InputException(here() + e.getMessage(), e);
        }
    }

    /**
     * Flies at a velocity until the next command, level and with the nose in the direction of flight; a drone that
     * moves straight up or down, or is at rest, keeps its heading.
     *
     * @param velocity east, north and up, m/s
     * @throws InputException when the velocity is null or faster than the drone's cruise speed, the drone is neither
     *     steered nor recorded, the run is over, or another thread runs it
     */
    public void fly(Position velocity) {
        command((flight, now) -> flight.fly(now, velocity));
    }

    /**
     * Flies at a velocity and with an attitude until the next command.
     *
     * @param velocity east, north and up, m/s
     * @param attitude yaw, pitch and roll, independent of the velocity
     * @throws InputException when the velocity or the attitude is null, the velocity is faster than the drone's cruise
     *     speed, the drone is neither steered nor recorded, the run is over, or another thread runs it
     */
    public void fly(Position velocity, Attitude attitude) {
        command((flight, now) -> flight.fly(now, velocity, attitude));
    }

    /**
     * Flies in a straight line at constant speed to a point and hovers there, until the next command.
     *
     * @param target the point, m
     * @param time when the drone is to arrive, after now, seconds since the start of the run
     * @throws InputException when that requires more than the drone's cruise speed, the point is null, the time is not
     *     after now, the drone is neither steered nor recorded, the run is over, or another thread runs it
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
            throw new InputException(here() + "cannot be steered: its flight is not of the kind 'steered'");
        }
        try {
            command.accept(flight.get(), clock.getAsDouble());
        } catch (IllegalArgumentException | IllegalStateException e) {
            throw new InputException(here() + e.getMessage(), e);
        }
    }

    /** The beginning of a message: who and when. */
    private String here() {
        return "drone '" + id + "' at " + clock.getAsDouble() + " s: ";
    }
}
