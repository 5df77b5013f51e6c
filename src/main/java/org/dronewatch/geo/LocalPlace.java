package org.dronewatch.geo;

import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * A place in the world frame with its height above the surface; scene files can state it instead of a position: {@code
 * {east: 120 m, north: -40 m, above: 10 m}}.
 *
 * @param east distance east of the origin, -100,000 to 100,000, m
 * @param north distance north of the origin, -100,000 to 100,000, m
 * @param above height above the highest surface there (ground, roof or tree), 0 to 100,000, m
 */
public record LocalPlace(
        @In(value = Quantity.LENGTH, from = -In.FARTHEST, to = In.FARTHEST) double east,
        @In(value = Quantity.LENGTH, from = -In.FARTHEST, to = In.FARTHEST) double north,
        @In(value = Quantity.LENGTH, from = 0, to = In.FARTHEST) double above) {
    /** Checks the limits. */
    public LocalPlace {
        Limits.check(LocalPlace.class, east, north, above);
    }

    /** A place on the highest surface; coordinates in m. */
    @Defaults({"east", "north"})
    public static LocalPlace at(double east, double north) {
        return new LocalPlace(east, north, 0.0);
    }
}
