package org.dronewatch.flight;

import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Formerly;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.world.Ground;

/**
 * A hover at a point, for example behind an obstacle, then a vertical climb from rest to rest at no more than the
 * cruise speed; the drone stays at the top, with its nose to the north.
 *
 * @param position position of the first hover, m
 * @param hoverTime duration of that hover, 0 to 1,000,000 s
 * @param height height of the climb, 0.001 to 100,000 m
 */
public record PopUp(
        Position position,
        @In(value = Quantity.DURATION, from = 0, to = 1e6) @Formerly("hidden") double hoverTime,
        @In(value = Quantity.LENGTH, from = 0.001, to = In.FARTHEST) double height)
        implements FlightPathSettings {
    /** Checks the limits. */
    public PopUp {
        Limits.check(PopUp.class, position, hoverTime, height);
    }

    @Override
    public FlightPath create(double speed, double acceleration, Ground ground) {
        Position top = position.plus(new Position(0, 0, height));
        FlightPath rise = new WaypointPath(List.of(position, top), speed, acceleration);
        // Before the climb, the drone is in the same state as at its beginning: at rest.
        return time -> rise.at(Math.max(0.0, time - hoverTime));
    }
}
