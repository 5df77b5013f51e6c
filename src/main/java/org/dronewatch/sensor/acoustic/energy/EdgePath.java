package org.dronewatch.sensor.acoustic.energy;

import org.dronewatch.geometry.Position;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * The diffraction path round the nearest edge of an obstruction of a source. In each of several half-planes through
 * source and sensor, the lowest free rays from either end meet above the edge, or above the highest of several
 * (Bullington, Proceedings of the IRE 35, 1947, for radio over hills); the half-plane with the smallest path difference
 * counts. One per thread.
 */
final class EdgePath {
    private static final int HALF_PLANES = 24;
    private static final double FIRST_SLOPE = 0.01;
    private static final double LARGEST_SLOPE = 12.0;
    private static final int HALVINGS = 24;

    private final Visibility visibility;
    private double pathDifference;
    private double sinElevation;

    EdgePath(World world) {
        this.visibility = new Visibility(world);
    }

    /** Looks for the nearest edge between two points that do not see each other; false where there is no path round. */
    boolean find(Position source, Position sensor) {
        Position vector = sensor.minus(source);
        double straight = vector.length();
        Position ahead = vector.times(1.0 / straight);
        Position across = across(ahead);
        Position up = across.cross(ahead);
        pathDifference = Double.POSITIVE_INFINITY;
        for (int i = 0; i < HALF_PLANES; i++) {
            double angle = 2.0 * Math.PI * i / HALF_PLANES;
            Position side = up.times(Math.cos(angle)).plus(across.times(Math.sin(angle)));
            double ofSource = lowestFree(source, vector, side.times(straight));
            if (!Double.isFinite(ofSource)) {
                continue;
            }
            double ofSensor = lowestFree(sensor, vector.times(-1.0), side.times(straight));
            if (!Double.isFinite(ofSensor)) {
                continue;
            }
            double fraction = ofSensor / (ofSource + ofSensor);
            double first = fraction * Math.hypot(1.0, ofSource);
            double second = (1.0 - fraction) * Math.hypot(1.0, ofSensor);
            double detour = straight * (first + second - 1.0);
            if (detour < pathDifference) {
                pathDifference = detour;
                Position leaving = ahead.plus(side.times(ofSource));
                sinElevation = leaving.z() / leaving.length();
            }
        }
        return Double.isFinite(pathDifference);
    }

    /** Path difference of the last path found: how much longer it is than the straight one, m. */
    double pathDifference() {
        return pathDifference;
    }

    /** Sine of the elevation at which the last path found leaves the source. */
    double sinElevation() {
        return sinElevation;
    }

    /**
     * Slope, relative to the straight path, of the lowest ray that clears all obstructions; infinity where none does.
     */
    private double lowestFree(Position from, Position vector, Position side) {
        double blocked = 0.0;
        double free = FIRST_SLOPE;
        while (isBlocked(from, vector, side, free)) {
            blocked = free;
            free *= 2.0;
            if (free > LARGEST_SLOPE) {
                return Double.POSITIVE_INFINITY;
            }
        }
        for (int i = 0; i < HALVINGS; i++) {
            double middle = 0.5 * (blocked + free);
            if (isBlocked(from, vector, side, middle)) {
                blocked = middle;
            } else {
                free = middle;
            }
        }
        return free;
    }

    private boolean isBlocked(Position from, Position vector, Position side, double slope) {
        return !visibility.isFreeAlong(
                from.x(),
                from.y(),
                from.z(),
                vector.x() + slope * side.x(),
                vector.y() + slope * side.y(),
                vector.z() + slope * side.z(),
                1.0);
    }

    /** A horizontal direction across, so that the first half-plane is vertical; any for a vertical path. */
    private static Position across(Position ahead) {
        Position across = new Position(ahead.y(), -ahead.x(), 0.0);
        double length = across.length();
        return length < 1e-9 ? new Position(1.0, 0.0, 0.0) : across.times(1.0 / length);
    }
}
