package org.dronewatch.flight;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * A straight leg of a flight, flown at constant speed.
 *
 * @param to end of the leg, m
 * @param speed speed along the leg, above 0 and at most 400 m/s; the cruise speed by default
 * @param powered whether the motors run; otherwise the drone glides, and the leg must descend
 */
public record RouteLeg(
        Position to, @In(value = Quantity.SPEED, above = 0, to = 400) Optional<Double> speed, boolean powered) {
    /** Checks the limits. */
    public RouteLeg {
        Limits.check(RouteLeg.class, to, speed, powered);
    }

    /** A leg under power at cruise speed. */
    @Defaults("to")
    public static RouteLeg towards(Position to) {
        return new RouteLeg(to, Optional.empty(), true);
    }
}
