package org.dronewatch.flight;

import java.util.List;
import org.dronewatch.setting.Check;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.Formerly;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.world.Ground;
import org.dronewatch.world.GroundPoint;

/**
 * A flight from point to point low over the highest surface below, whether ground, roof or tree, at cruise speed along
 * the path from the beginning; the drone stays at the end. It never climbs or descends more steeply than allowed: it
 * begins to climb well before a wall and descends gradually behind it. The surface is sampled every half metre along
 * the path: objects thinner than that may be missed, and above a ridge between two samples the clearance may fall short
 * by a few millimetres. Where there is no surface below, the nearest known height along the path is used.
 *
 * @param points the path in plan view, as pairs of east and north coordinates, m: at least two points, consecutive ones
 *     0.001 m or more apart, at most 50,000 m in all
 * @param height height above the highest surface, above 0 and at most 10,000 m
 * @param maxFlightPathAngle maximum angle of climb and descent, rad, pi/36 to 17 pi/36 (5 to 85 degrees)
 */
public record TerrainFollowing(
        List<GroundPoint> points,
        @In(value = Quantity.LENGTH, above = 0, to = 10_000) double height,
        @In(value = Quantity.ANGLE, from = Math.PI / 36, to = 17 * Math.PI / 36) @Formerly("steepest")
                double maxFlightPathAngle)
        implements FlightPathSettings {
    /** The default angle, rad. */
    static final double USUAL_STEEPEST = Math.PI / 4;

    /** Checks the limits and copies the list. */
    public TerrainFollowing {
        Limits.check(TerrainFollowing.class, points, height, maxFlightPathAngle);
        points = List.copyOf(points);
        if (points.size() < 2) {
            throw new IllegalArgumentException(
                    "points has " + Counted.of(points.size(), "point") + " but needs 2 or more");
        }
        double length = 0.0;
        for (int i = 1; i < points.size(); i++) {
            double leg = points.get(i).distance(points.get(i - 1));
            length += Check.between("points: distance to point " + i, leg, 0.001, GroundTrack.LONGEST, Quantity.LENGTH);
        }
        if (length > GroundTrack.LONGEST) {
            throw new IllegalArgumentException(
                    "points: path of " + (float) length + " m must be at most " + GroundTrack.LONGEST + " m long");
        }
    }

    /** A flight that climbs and descends at no more than 45 degrees. */
    @Defaults({"points", "height"})
    public static TerrainFollowing over(List<GroundPoint> points, double height) {
        return new TerrainFollowing(points, height, USUAL_STEEPEST);
    }

    @Override
    public FlightPath create(double speed, double acceleration, Ground ground) {
        GroundTrack track = new GroundTrack(points);
        double[] profile = TerrainProfile.over(track, ground, Math.tan(maxFlightPathAngle));
        return new TerrainPath(track, profile, height, speed);
    }
}
