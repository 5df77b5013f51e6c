package org.dronewatch.sensor.radar;

import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.Position;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * The fraction of a drone that is visible from a position: of nine points in its bounding box, the centre and the eight
 * points half-way to the corners, the fraction to which nothing in the world obstructs the line of sight.
 */
final class VisibleFraction {
    private static final int POINTS = 9;
    private static final double HALF_WAY = 0.5;

    private final Position position;
    private final Visibility visibility;

    VisibleFraction(World world, Position position) {
        this.position = position;
        this.visibility = new Visibility(world);
    }

    /** The fraction, 0 to 1. */
    double of(Drone drone) {
        AABB box = drone.modelBounds();
        int visible = 0;
        for (int i = 0; i < POINTS; i++) {
            // The last of the points is the centre.
            double reach = i == POINTS - 1 ? 0.0 : HALF_WAY;
            Position point = new Position(
                    between(box.minX(), box.maxX(), (i & 1) == 0 ? -reach : reach),
                    between(box.minY(), box.maxY(), (i & 2) == 0 ? -reach : reach),
                    between(box.minZ(), box.maxZ(), (i & 4) == 0 ? -reach : reach));
            visible += visibility.isFree(position, drone.toWorld(point)) ? 1 : 0;
        }
        return (double) visible / POINTS;
    }

    private static double between(double low, double high, double side) {
        return 0.5 * (low + high) + 0.5 * side * (high - low);
    }
}
