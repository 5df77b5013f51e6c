package org.dronewatch.report.sheet;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.dronewatch.fusion.Protection;
import org.dronewatch.geometry.Position;

/** The outlines of protected zones in plan view. */
public final class ProtectedOutlines {
    /** Corners of the outline of a circle. */
    private static final int CIRCLE = 72;

    private ProtectedOutlines() {}

    /** The outline of each zone, the sphere first, m. */
    public static List<List<Position>> of(Protection protection) {
        List<List<Position>> outlines = new ArrayList<>();
        protection.zone().ifPresent(ball -> outlines.add(circle(ball.centre(), ball.radius())));
        protection
                .areas()
                .forEach(area -> outlines.add(area.outline().stream()
                        .map(corner -> new Position(corner.x(), corner.y(), 0.0))
                        .toList()));
        return outlines;
    }

    /** The corners of a polygon that approximates a circle in plan view, m. */
    public static List<Position> circle(Position middle, double radius) {
        return IntStream.range(0, CIRCLE)
                .mapToObj(i -> around(middle, 2.0 * Math.PI * i / CIRCLE, radius))
                .toList();
    }

    /**
     * A point at a distance from another, in plan view, m.
     *
     * @param bearing clockwise from north, rad
     * @param distance distance from the other point, m
     */
    public static Position around(Position middle, double bearing, double distance) {
        return middle.plus(new Position(distance * Math.sin(bearing), distance * Math.cos(bearing), 0.0));
    }
}
