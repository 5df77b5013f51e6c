package org.dronewatch.flight;

import java.util.List;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.Formerly;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.world.Ground;
import org.dronewatch.world.GroundPoint;

/**
 * A straight flight towards a point, low over the ground and using the cover that the site offers; the drone stops at
 * the point, or at the standoff distance. It climbs and descends at no more than 45 degrees, and keeps its height as
 * with {@link TerrainFollowing}.
 *
 * @param target the point in plan view, as a pair of east and north coordinates, m
 * @param bearing bearing of the approaching drone from the target, clockwise from north, rad
 * @param distance horizontal distance from the target at time 0, above 0 and at most 50,000 m
 * @param height height above the highest surface below, above 0 and at most 10,000 m
 * @param standoff horizontal distance from the target at which the drone stops, 0 or more, less than the distance, m
 */
public record LowApproach(
        GroundPoint target,
        @In(value = Quantity.ANGLE, from = -In.TWO_TURNS, to = In.TWO_TURNS) double bearing,
        @In(value = Quantity.LENGTH, above = 0, to = GroundTrack.LONGEST) double distance,
        @In(value = Quantity.LENGTH, above = 0, to = 10_000) double height,
        @In(value = Quantity.LENGTH, from = 0, to = GroundTrack.LONGEST) @Formerly("nearest") double standoff)
        implements FlightPathSettings {
    /** Checks the limits. */
    public LowApproach {
        Limits.check(LowApproach.class, target, bearing, distance, height, standoff);
        if (distance - standoff < SHORTEST) {
            throw new IllegalArgumentException("standoff " + standoff + " m must be less than distance " + distance
                    + " m by " + SHORTEST + " m or more");
        }
    }

    /** An approach from the north that stops above the target. */
    @Defaults({"target", "distance", "height"})
    public static LowApproach from(GroundPoint target, double distance, double height) {
        return new LowApproach(target, 0.0, distance, height, 0.0);
    }

    private GroundPoint at(double range) {
        return new GroundPoint(target.x() + range * Math.sin(bearing), target.y() + range * Math.cos(bearing));
    }

    @Override
    public FlightPath create(double speed, double acceleration, Ground ground) {
        return TerrainFollowing.over(List.of(at(distance), at(standoff)), height)
                .create(speed, acceleration, ground);
    }
}
