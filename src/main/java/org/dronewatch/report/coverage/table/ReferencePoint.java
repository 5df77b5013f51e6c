package org.dronewatch.report.coverage.table;

import java.util.Locale;
import java.util.Optional;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.InboundWarnings;
import org.dronewatch.analysis.survey.GapMap;
import org.dronewatch.fusion.Protection;
import org.dronewatch.geo.GeoPoint;
import org.dronewatch.geo.Geodesy;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.CompassPoint;

/**
 * The point from which a report describes where something is: the centre of what is protected, or the mean position of
 * the sensors.
 *
 * @param at position of the point, m
 * @param name what the point is, such as {@code the centroid of the sensors}
 * @param geodesy converts to geographic coordinates; empty if the scene has no origin
 */
public record ReferencePoint(Position at, String name, Optional<Geodesy> geodesy) {
    /** The point that inbound flights head for. */
    public static ReferencePoint of(InboundWarnings warnings, Protection protection, CoverageInputs inputs) {
        String name = inputs.area()
                .filter(area -> !area.equals(Protection.ZONE))
                .map(ReferencePoint::area)
                .orElseGet(() -> zone(protection));
        return new ReferencePoint(warnings.target(), name, inputs.origin().map(Geodesy::new));
    }

    private static String zone(Protection protection) {
        return protection.isEmpty()
                ? "the centroid of the sensors"
                : protection
                        .zone()
                        .map(ball -> "the centre of the protected zone")
                        .orElseGet(() -> area(protection.areas().get(0).name()));
    }

    private static String area(String name) {
        return "the centre of the protected area '" + name + "'";
    }

    /** {@code 210 m north-west of the centroid of the sensors}. */
    String describe(double x, double y) {
        return distanceAndDirection(x, y) + " of " + name;
    }

    /** {@code 210 m north-west}. */
    String distanceAndDirection(double x, double y) {
        return String.format(
                Locale.ROOT, "%.0f m %s", distance(x, y), CompassPoint.of(Math.atan2(x - at.x(), y - at.y())));
    }

    /** The distance in plan view, m. */
    double distance(double x, double y) {
        return Math.hypot(x - at.x(), y - at.y());
    }

    /** Coordinates in the scene's frame, and geographic ones: {@code x -44 m, y 124 m; 43.73120° N, 7.41950° E}. */
    String coordinates(double x, double y) {
        String plan = String.format(Locale.ROOT, "x %.0f m, y %.0f m", x + 0.0, y + 0.0);
        return plan
                + geodesy.map(earth -> {
                            GeoPoint point = earth.onEarth(new Position(x, y, at.z()));
                            return String.format(
                                    Locale.ROOT,
                                    "; %.5f\u00b0 %s, %.5f\u00b0 %s",
                                    Math.abs(point.latitude()),
                                    point.latitude() < 0.0 ? "S" : "N",
                                    Math.abs(point.longitude()),
                                    point.longitude() < 0.0 ? "W" : "E");
                        })
                        .orElse("");
    }

    /**
     * The {@link FieldGrid#cell number} of the cell of a gap that is nearest to this point; the first if several are
     * equally near.
     */
    int nearestCell(GapMap map, int gap) {
        FieldGrid grid = map.coverage().field().grid();
        int nearest = -1;
        double least = Double.POSITIVE_INFINITY;
        for (int cell : map.cells(gap)) {
            double distance = distance(grid.x(grid.column(cell)), grid.y(grid.row(cell)));
            if (distance < least) {
                least = distance;
                nearest = cell;
            }
        }
        return nearest;
    }
}
