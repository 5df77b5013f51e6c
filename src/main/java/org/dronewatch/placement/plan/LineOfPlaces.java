package org.dronewatch.placement.plan;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.world.GroundPoint;

/**
 * Evenly spaced positions along a straight line, above the highest surface.
 *
 * @param from start of the line
 * @param to end of the line
 * @param every distance between neighbours, above 0 and at most 100 km, m
 * @param above height above the highest surface, 0 to 100 km, m; 2 m by default
 */
public record LineOfPlaces(
        GroundPoint from,
        GroundPoint to,
        @In(value = Quantity.LENGTH, above = 0, to = In.FARTHEST) double every,
        @In(value = Quantity.LENGTH, from = 0, to = In.FARTHEST) double above) {
    /** The height of a sensor above a roof or the ground unless another one is given, m. */
    static final double ABOVE = 2.0;

    private static final double ROUNDING = 1e-9;

    /** Checks the limits. */
    public LineOfPlaces {
        Limits.check(LineOfPlaces.class, from, to, every, above);
    }

    /** Positions 2 m above the surface. */
    @Defaults({"from", "to", "every"})
    public static LineOfPlaces of(GroundPoint from, GroundPoint to, double every) {
        return new LineOfPlaces(from, to, every, ABOVE);
    }

    /** The positions in plan view, from the beginning of the line; at most one more than a given number. */
    List<GroundPoint> points(int most) {
        double length = from.distance(to);
        List<GroundPoint> points = new ArrayList<>();
        for (int i = 0; i * every <= length + ROUNDING && points.size() <= most; i++) {
            double part = length == 0.0 ? 0.0 : Math.min(1.0, i * every / length);
            points.add(new GroundPoint(from.x() + part * (to.x() - from.x()), from.y() + part * (to.y() - from.y())));
        }
        return points;
    }
}
