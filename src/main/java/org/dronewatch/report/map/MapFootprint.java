package org.dronewatch.report.map;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Outline;

/** The footprint of a sensor's field of view, ignoring obstructions. */
final class MapFootprint {
    /**
     * The distance to which the field of view of a camera that detects nothing is drawn, m: a camera has no stated
     * range.
     */
    static final double UNKNOWN_REACH = 100.0;

    /** The distance to which the field of view of a radar without a practical limit of range is drawn, m. */
    static final double MOST = 200_000.0;

    /** Number of line segments of a full circle. */
    static final int STEPS = 72;

    private static final Position UP = new Position(0.0, 0.0, 1.0);

    private static final double TURN = 2.0 * Math.PI;

    private MapFootprint() {}

    /**
     * The edge of the footprint, counterclockwise seen from above, and then its holes, clockwise; each ring ends where
     * it begins.
     *
     * @param at where the sensor is, m
     * @param outline its field of view
     * @param detected the greatest range at which the sensor first detected a drone, m: a camera's field of view is
     *     drawn to this range
     */
    static List<List<Position>> of(Position at, Outline outline, OptionalDouble detected) {
        if (outline instanceof Outline.Sector sector) {
            double reach = Math.min(sector.maxRange(), MOST);
            return rings(at, sector.azimuth(), sector.azimuthWidth(), sector.minRange(), reach);
        }
        if (outline instanceof Outline.Ball ball) {
            return rings(at, 0.0, TURN, 0.0, ball.radius());
        }
        Outline.Frustum frustum = (Outline.Frustum) outline;
        return wedge(at, frustum, Math.min(frustum.far(), detected.orElse(UNKNOWN_REACH)));
    }

    /** All compass bearings that lie in a frustum; a camera that looks straight up or down sees all of them. */
    private static List<List<Position>> wedge(Position at, Outline.Frustum frustum, double reach) {
        if (frustum.spans(UP) || frustum.spans(UP.times(-1.0))) {
            return rings(at, 0.0, TURN, 0.0, reach);
        }
        Position middle = frustum.middle();
        double axis = Math.atan2(middle.x(), middle.y());
        double left = 0.0;
        double right = 0.0;
        for (int corner = 0; corner < 4; corner++) {
            double aside = corner < 2 ? frustum.halfWidth() : -frustum.halfWidth();
            double above = corner % 2 == 0 ? frustum.halfHeight() : -frustum.halfHeight();
            Position vector =
                    middle.plus(frustum.right().times(aside)).plus(frustum.up().times(above));
            double bearing = Math.IEEEremainder(Math.atan2(vector.x(), vector.y()) - axis, TURN);
            left = Math.min(left, bearing);
            right = Math.max(right, bearing);
        }
        return rings(at, axis + 0.5 * (left + right), right - left, 0.0, reach);
    }

    private static List<List<Position>> rings(Position at, double azimuth, double width, double min, double max) {
        boolean hollow = min > 0.0 && min < max;
        if (width > TURN - 1e-6) {
            List<Position> edge = closed(arc(at, max, TURN, 0.0, STEPS).subList(0, STEPS));
            return hollow ? List.of(edge, closed(arc(at, min, 0.0, TURN, STEPS).subList(0, STEPS))) : List.of(edge);
        }
        int steps = Math.max(2, (int) Math.ceil(STEPS * width / TURN));
        double left = azimuth - 0.5 * width;
        double right = azimuth + 0.5 * width;
        List<Position> edge = arc(at, max, right, left, steps);
        edge.addAll(hollow ? arc(at, min, left, right, steps) : List.of(at));
        return List.of(closed(edge));
    }

    /** The positions of an arc about a centre from one compass bearing to another, rad. */
    private static List<Position> arc(Position at, double radius, double from, double to, int steps) {
        List<Position> positions = new ArrayList<>();
        for (int i = 0; i <= steps; i++) {
            double bearing = from + (to - from) * i / steps;
            positions.add(at.plus(new Position(radius * Math.sin(bearing), radius * Math.cos(bearing), 0.0)));
        }
        return positions;
    }

    private static List<Position> closed(List<Position> positions) {
        List<Position> ring = new ArrayList<>(positions);
        ring.add(positions.get(0));
        return ring;
    }
}
