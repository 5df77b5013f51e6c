package org.dronewatch.placement.plan;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.fusion.AreaZone;
import org.dronewatch.fusion.ProtectedArea;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.world.GroundPoint;

/**
 * Positions in a square grid within a polygon, such as a roof, above the highest surface.
 *
 * @param corners corners of the polygon, in either winding order, 3 to 1000
 * @param every distance between neighbours, above 0 and at most 100 km, m
 * @param above height above the highest surface, 0 to 100 km, m; 2 m by default
 */
public record AreaOfPlaces(
        List<GroundPoint> corners,
        @In(value = Quantity.LENGTH, above = 0, to = In.FARTHEST) double every,
        @In(value = Quantity.LENGTH, from = 0, to = In.FARTHEST) double above) {
    /** Checks the limits, and that the polygon does not cross itself. */
    public AreaOfPlaces {
        Limits.check(AreaOfPlaces.class, corners, every, above);
        corners = List.copyOf(corners);
        ProtectedArea.polygon(corners, 1.0);
    }

    /** Positions 2 m above the surface. */
    @Defaults({"corners", "every"})
    public static AreaOfPlaces of(List<GroundPoint> corners, double every) {
        return new AreaOfPlaces(corners, every, LineOfPlaces.ABOVE);
    }

    /** The positions in plan view, row by row from the south-west; at most one more than a given number. */
    List<GroundPoint> points(int most) {
        AreaZone zone = new AreaZone("area", ProtectedArea.polygon(corners, 1.0), 0.0, 0.0);
        double west = corners.stream().mapToDouble(GroundPoint::x).min().orElseThrow();
        double east = corners.stream().mapToDouble(GroundPoint::x).max().orElseThrow();
        double south = corners.stream().mapToDouble(GroundPoint::y).min().orElseThrow();
        double north = corners.stream().mapToDouble(GroundPoint::y).max().orElseThrow();
        List<GroundPoint> points = new ArrayList<>();
        if ((east - west) / every * ((north - south) / every) > In.FARTHEST) {
            throw new IllegalArgumentException("every " + every + " m: must be larger for an area of this size");
        }
        for (double y = south + 0.5 * every; y < north && points.size() <= most; y += every) {
            for (double x = west + 0.5 * every; x < east && points.size() <= most; x += every) {
                if (zone.covers(x, y)) {
                    points.add(new GroundPoint(x, y));
                }
            }
        }
        return points;
    }
}
