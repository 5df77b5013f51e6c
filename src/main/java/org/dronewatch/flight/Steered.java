package org.dronewatch.flight;

import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.world.Ground;

/**
 * A flight steered by a program during the run: a hover until the first command, then as commanded, at no more than the
 * drone's speed. Each drone of a swarm starts at its position in the formation and is steered separately.
 *
 * @param start position at time 0, m
 * @param heading heading of the nose before the first command, clockwise from north, rad
 */
public record Steered(
        Position start, @In(value = Quantity.ANGLE, from = -In.TWO_TURNS, to = In.TWO_TURNS) double heading)
        implements FlightPathSettings {
    /** Checks the limits. */
    public Steered {
        Limits.check(Steered.class, start, heading);
    }

    /** A flight that starts with the nose to the north. */
    @Defaults("start")
    public static Steered from(Position start) {
        return new Steered(start, 0.0);
    }

    /**
     * This flight, displaced.
     *
     * @param offset displacement to the right, ahead and above, relative to the heading at the start, m
     */
    public Steered beside(Position offset) {
        return new Steered(start.plus(Displaced.turned(offset, heading)), heading);
    }

    /**
     * A new flight without commands. The acceleration has no effect: the velocity changes at once with each command.
     */
    @Override
    public SteeredFlight create(double speed, double acceleration, Ground ground) {
        return new SteeredFlight(start, heading, speed);
    }
}
