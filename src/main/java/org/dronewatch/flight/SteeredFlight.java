package org.dronewatch.flight;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Check;

/**
 * The flight of a drone that is steered during a run. Between two commands its velocity and its attitude are constant;
 * its position is never set, but follows from its start and its velocities. The past of the flight is kept, because a
 * microphone hears the drone where it was; the future is not known, and querying it fails.
 *
 * <p>A command takes effect from its time on, that time included. If several commands have the same time, the last
 * one takes effect. A command at a time at which sensors have already looked, in response to their observations, takes
 * effect at the next instant that a double can represent, so that these observations remain valid. Only the thread that
 * runs the scene may steer, since a command from any other thread would take effect at whatever time the run happened
 * to have reached; any thread may query the flight.
 */
public final class SteeredFlight implements FlownPath {
    /** The amount by which a commanded speed may exceed the limit, since the length of a rounded vector may. */
    private static final double ROUNDING = 1e-9;

    private static final Position REST = new Position(0, 0, 0);

    private final double fastest;
    private final List<Leg> legs = new ArrayList<>();
    private double now;
    private double looked = -1.0;
    private boolean over;
    private Thread steering = Thread.currentThread();

    /**
     * A flight that is at rest at the start of a run and is steered by the calling thread.
     *
     * @param start its position, m
     * @param heading heading of its nose, clockwise from north, rad
     * @param fastest largest speed that may be commanded, m/s
     */
    SteeredFlight(Position start, double heading, double fastest) {
        this.fastest = fastest;
        legs.add(new Leg(0.0, new FlightState(start, REST, heading)));
    }

    /**
     * Commands a velocity, with a level attitude and the nose in the direction of flight; in vertical flight and at
     * rest, the drone keeps its heading.
     *
     * @param time seconds since the start of the run
     * @param velocity velocity in the world frame, m/s
     * @throws IllegalArgumentException when the velocity exceeds the drone's speed or is null, or the flight is already
     *     known beyond that time
     * @throws IllegalStateException when the run is over, or another thread steers
     */
    public synchronized void fly(double time, Position velocity) {
        double from = effective(time);
        checkSpeed(velocity);
        command(from, velocity, along(velocity, Leg.at(legs, from)));
    }

    /**
     * Commands a velocity and an attitude.
     *
     * @param time seconds since the start of the run
     * @param velocity velocity in the world frame, m/s
     * @param attitude yaw, pitch and roll; does not depend on the velocity
     * @throws IllegalArgumentException when the velocity exceeds the drone's speed, the velocity or the attitude is
     *     null, or the flight is already known beyond that time
     * @throws IllegalStateException when the run is over, or another thread steers
     */
    public synchronized void fly(double time, Position velocity, Attitude attitude) {
        double from = effective(time);
        checkSpeed(velocity);
        command(from, velocity, Check.present("attitude", attitude));
    }

    /**
     * Commands a flight in a straight line at constant speed to a point, with the drone's nose as for
     * {@link #fly(double, Position)}, and a hover there until the next command.
     *
     * @param time seconds since the start of the run
     * @param target the point, m
     * @param arrival time at which the drone is to be there, after the command, seconds since the start of the run
     * @throws IllegalArgumentException when that requires more than the drone's speed, the point is null, the arrival
     *     is not after the command, or the flight is already known beyond that time
     * @throws IllegalStateException when the run is over, or another thread steers
     */
    public synchronized void flyTo(double time, Position target, double arrival) {
        double from = effective(time);
        Check.present("target", target);
        if (!(arrival > from && Double.isFinite(arrival))) {
            throw new IllegalArgumentException(
                    "arrival at " + arrival + " s must be after the command, at " + from + " s");
        }
        FlightState here = Leg.at(legs, from);
        Position way = target.minus(here.position());
        // Checked before the velocity, which may be infinite if the arrival is so soon after the command.
        double speed = way.length() / (arrival - from);
        checkSpeed(speed);
        Position velocity = speed == 0.0 ? REST : way.times(1.0 / (arrival - from));
        Attitude attitude = along(velocity, here);
        command(from, velocity, attitude);
        add(arrival, REST, attitude);
    }

    private static Attitude along(Position velocity, FlightState here) {
        boolean isVertical = velocity.x() == 0.0 && velocity.y() == 0.0;
        return Attitude.level(isVertical ? here.heading() : Math.atan2(velocity.x(), velocity.y()));
    }

    /** The time at which a command takes effect, s. */
    private double effective(double time) {
        if (over) {
            throw new IllegalStateException("the run is over: it accepts no more commands");
        }
        if (Thread.currentThread() != steering) {
            throw new IllegalStateException("commanded by the thread '"
                    + Thread.currentThread().getName() + "', but only '" + steering.getName()
                    + "', which runs the scene, may steer: give commands in events of its simulator");
        }
        if (!Double.isFinite(time)) {
            throw new IllegalArgumentException("a command at " + time + " s: its time must be a finite number");
        }
        double from = time <= looked ? Math.nextUp(looked) : time;
        if (!(time >= looked && from >= now)) {
            throw new IllegalArgumentException("a command at " + time + " s must not be before " + now
                    + " s, up to which the flight is already known");
        }
        return from;
    }

    private void checkSpeed(Position velocity) {
        checkSpeed(Check.present("velocity", velocity).length());
    }

    private void checkSpeed(double speed) {
        if (speed > fastest * (1.0 + ROUNDING)) {
            throw new IllegalArgumentException(String.format(
                    Locale.ROOT, "speed %s m/s must be at most the drone's %s m/s", (float) speed, (float) fastest));
        }
    }

    /** A command that has been checked. */
    private void command(double from, Position velocity, Attitude attitude) {
        now = from;
        add(from, velocity, attitude);
    }

    /**
     * Adds a leg that begins at the drone's position at that time; anything that an earlier command planned for a later
     * time is discarded.
     */
    private void add(double from, Position velocity, Attitude attitude) {
        Position here = Leg.at(legs, from).position();
        for (int last = legs.size() - 1; last >= 0 && legs.get(last).time() >= from; last--) {
            legs.remove(last);
        }
        legs.add(new Leg(from, new FlightState(here, velocity, attitude, OptionalDouble.empty())));
    }

    /** Makes the calling thread the one that runs the scene: only it may steer from now on. */
    synchronized void steerHere() {
        steering = Thread.currentThread();
    }

    /** Advances the flight: it is then known before this time, and also at it unless a command still changes it. */
    synchronized void advance(double time) {
        now = Math.max(now, time);
    }

    /** Records that sensors look at a time: up to and including that time, the flight can no longer change. */
    synchronized void look(double time) {
        advance(time);
        looked = Math.max(looked, time);
    }

    /** Ends the run: no more commands are accepted. */
    synchronized void end() {
        over = true;
    }

    /** The time up to which the flight is known, seconds since the start of the run. */
    public synchronized double known() {
        return now;
    }

    /**
     * The given path as a steered flight, whose attitudes do not include the tilt of an accelerating drone; empty for
     * any other path.
     */
    public static Optional<SteeredFlight> in(FlightPath path) {
        return FlownPath.in(path).filter(SteeredFlight.class::isInstance).map(SteeredFlight.class::cast);
    }

    /**
     * The state at a time that has been reached.
     *
     * @throws IllegalStateException when that time is yet to come
     */
    @Override
    public synchronized FlightState at(double time) {
        // Because of rounding, the parts of a run may not add up exactly to its duration.
        if (time > now * (1.0 + 1e-12)) {
            throw new IllegalStateException(
                    "where a steered drone will be at " + time + " s is not known at " + now + " s");
        }
        return Leg.at(legs, Math.min(time, now));
    }

    @Override
    public synchronized List<Leg> legs() {
        return legs.stream().filter(leg -> leg.time() <= now).toList();
    }
}
