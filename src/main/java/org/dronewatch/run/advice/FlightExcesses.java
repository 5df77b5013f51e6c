package org.dronewatch.run.advice;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.dronewatch.drone.FlightLimits;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Quantity;
import org.dronewatch.world.Ground;

/** Finds where a flight exceeds the limits of its drone most; the flight is examined at successive times. */
final class FlightExcesses {
    /** Slower than this, a drone counts as hovering: its course is not defined, m/s. */
    private static final double SLOW = 0.5;
    /** A drone at rest below this height above the surface has landed, m. */
    private static final double LANDED = 1.0;

    private final GreatestExcess climb;
    private final GreatestExcess sink;
    private final GreatestExcess turn;
    private final GreatestExcess height;
    private final GreatestExcess endurance;
    private final GreatestExcess glide;
    private final GreatestExcess hover;

    private double powered;
    private double before;
    private boolean hasFlown;
    private Double stillSince;
    private FlightState still;

    FlightExcesses(FlightLimits limits) {
        climb = new GreatestExcess("climbs at", Quantity.SPEED, limits.climb());
        sink = new GreatestExcess("descends at", Quantity.SPEED, limits.sink());
        turn = new GreatestExcess("turns at", Quantity.ANGULAR_SPEED, limits.turnRate());
        height = new GreatestExcess("is at a height of", Quantity.LENGTH, limits.ceiling());
        endurance = new GreatestExcess("has flown under power for", Quantity.DURATION, limits.endurance());
        glide = new GreatestExcess("has a glide ratio of", Quantity.NUMBER, limits.glideRatio());
        hover = new GreatestExcess("hovers for", Quantity.DURATION, limits.hover() ? Double.POSITIVE_INFINITY : 0.0);
    }

    /**
     * Takes the next moment of the flight into account.
     *
     * @param time time of the moment, later than that of the one before, s
     * @param acceleration acceleration of the drone, m/s2
     */
    void examine(double time, FlightState state, Position acceleration, Ground ground) {
        Position at = state.position();
        Position velocity = state.velocity();
        double above = at.z() - ground.height(at.x(), at.y()).orElse(at.z());
        height.take(above, time, at);
        if (state.isPowered()) {
            climb.take(velocity.z(), time, at);
            sink.take(-velocity.z(), time, at);
            turn.take(turnRate(velocity, acceleration), time, at);
            powered += velocity.length() > 0.0 || above > LANDED ? time - before : 0.0;
            endurance.take(powered, time, at);
        } else if (velocity.z() < 0.0) {
            glide.take(Math.hypot(velocity.x(), velocity.y()) / -velocity.z(), time, at);
        }
        hovering(time, state);
        before = time;
    }

    /** How fast the course turns, rad/s; 0 where the drone is too slow to have one. */
    private static double turnRate(Position velocity, Position acceleration) {
        double squared = velocity.x() * velocity.x() + velocity.y() * velocity.y();
        double across = velocity.x() * acceleration.y() - velocity.y() * acceleration.x();
        return squared < SLOW * SLOW ? 0.0 : Math.abs(across) / squared;
    }

    /** A flight may begin and end at rest: hovering is standing still between two times at which the drone flies. */
    private void hovering(double time, FlightState state) {
        boolean slow = state.velocity().length() < SLOW;
        if (!slow) {
            if (stillSince != null) {
                hover.take(time - stillSince, stillSince, still.position());
            }
            hasFlown = true;
            stillSince = null;
        } else if (hasFlown && stillSince == null) {
            stillSince = time;
            still = state;
        }
    }

    /** A line for each limit that was exceeded. */
    List<String> lines() {
        return Stream.of(climb, sink, turn, height, endurance, glide, hover)
                .map(GreatestExcess::line)
                .flatMap(Optional::stream)
                .toList();
    }
}
