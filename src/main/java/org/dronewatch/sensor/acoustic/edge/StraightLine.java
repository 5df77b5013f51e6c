package org.dronewatch.sensor.acoustic.edge;

import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.Position;

/**
 * The straight line between two points, and the directions across it. Exchanging the points gives the same numbers.
 *
 * @param from the end with the lower coordinates, m
 * @param to the other end, m
 * @param isExchanged whether the line begins at the sensor
 * @param length length of the line, m
 * @param ahead unit vector along it; zero for a line without length
 * @param across a horizontal unit vector across it; for a vertical line, any such vector
 * @param up a unit vector perpendicular to both
 */
record StraightLine(
        Position from, Position to, boolean isExchanged, double length, Position ahead, Position across, Position up) {

    static StraightLine between(Position source, Position sensor) {
        boolean isExchanged = isAfter(source, sensor);
        Position from = isExchanged ? sensor : source;
        Position to = isExchanged ? source : sensor;
        Position vector = to.minus(from);
        double length = vector.length();
        Position ahead = length > 0.0 ? vector.times(1.0 / length) : vector;
        Position across = across(ahead);
        return new StraightLine(from, to, isExchanged, length, ahead, across, across.cross(ahead));
    }

    /**
     * A unit vector across the line.
     *
     * @param angle angle from {@link #up} towards {@link #across}, rad
     */
    Position side(double angle) {
        return up.times(Math.cos(angle)).plus(across.times(Math.sin(angle)));
    }

    /** The greatest sum of the distances from the ends of any point of a box, m. */
    double farthest(AABB box) {
        double farthest = length;
        for (int i = 0; i < 8; i++) {
            Position corner = new Position(
                    (i & 1) == 0 ? box.minX() : box.maxX(),
                    (i & 2) == 0 ? box.minY() : box.maxY(),
                    (i & 4) == 0 ? box.minZ() : box.maxZ());
            farthest = Math.max(farthest, from.distance(corner) + corner.distance(to));
        }
        return farthest;
    }

    private static boolean isAfter(Position one, Position other) {
        if (one.x() != other.x()) {
            return one.x() > other.x();
        }
        return one.y() != other.y() ? one.y() > other.y() : one.z() > other.z();
    }

    /** A horizontal unit vector across a direction; it is horizontal so that the first plane is vertical. */
    private static Position across(Position ahead) {
        Position across = new Position(ahead.y(), -ahead.x(), 0.0);
        double length = across.length();
        return length < 1e-9 ? new Position(1.0, 0.0, 0.0) : across.times(1.0 / length);
    }
}
