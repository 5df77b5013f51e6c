package org.dronewatch.geo;

import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * A point in plan view in the world frame, which scene files may give instead of a pair of coordinates: {@code {east:
 * 120 m, north: -40 m}}.
 *
 * @param east distance east of the origin, -100,000 to 100,000, m
 * @param north distance north of the origin, -100,000 to 100,000, m
 */
public record LocalPoint(
        @In(value = Quantity.LENGTH, from = -In.FARTHEST, to = In.FARTHEST) double east,
        @In(value = Quantity.LENGTH, from = -In.FARTHEST, to = In.FARTHEST) double north) {
    /** Checks the limits. */
    public LocalPoint {
        Limits.check(LocalPoint.class, east, north);
    }
}
