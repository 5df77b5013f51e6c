package org.dronewatch.world;

import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * A point in plan view, without a height: {@code [120, -40]} in a scene file.
 *
 * @param x east, -100,000 to 100,000 m
 * @param y north, -100,000 to 100,000 m
 */
public record GroundPoint(
        @In(value = Quantity.LENGTH, from = -In.FARTHEST, to = In.FARTHEST) double x,
        @In(value = Quantity.LENGTH, from = -In.FARTHEST, to = In.FARTHEST) double y) {
    /** Checks the limits. */
    public GroundPoint {
        Limits.check(GroundPoint.class, x, y);
    }

    /** The horizontal distance to another point, m. */
    public double distance(GroundPoint other) {
        return Math.hypot(other.x - x, other.y - y);
    }
}
