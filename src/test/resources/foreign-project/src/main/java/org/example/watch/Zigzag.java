package org.example.watch;

import org.dronewatch.flight.FlightPath;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.world.Ground;

/**
 * Flies southward, swaying from side to side.
 *
 * @param from where it is at time 0, m
 * @param sway to either side, m
 */
public record Zigzag(Position from, @In(value = Quantity.LENGTH, from = 0.0, to = 100.0) double sway)
        implements FlightPathSettings {
    public Zigzag {
        Limits.check(Zigzag.class, from, sway);
    }

    @Defaults("from")
    public static Zigzag from(Position from) {
        return new Zigzag(from, 5.0);
    }

    @Override
    public FlightPath create(double speed, double acceleration, Ground ground) {
        return time -> new FlightState(
                from.plus(new Position(sway * Math.sin(time), -speed * time, 0.0)),
                new Position(sway * Math.cos(time), -speed, 0.0),
                Math.PI);
    }
}
