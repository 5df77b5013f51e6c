package org.dronewatch.sensor.camera;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.world.Light;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * What a camera sees beyond the drones: the sun, and the background of a drone. Keeps scratch memory: for use by one
 * thread at a time.
 */
final class Beyond {
    private final World world;
    private final Visibility visibility;
    private final Position camera;

    /**
     * What is seen beyond the drones from the position of a camera.
     *
     * @param camera position of the camera, m
     */
    Beyond(World world, Position camera) {
        this.world = world;
        this.visibility = new Visibility(world);
        this.camera = camera;
    }

    /** The vector to the sun if nothing hides the sun from the position of the camera; it may lie outside the image. */
    Optional<Position> sun() {
        return world.light().sun().map(Light.Sun::direction).filter(vector -> vector.z() >= 0.0 && isFree(vector));
    }

    private boolean isFree(Position vector) {
        return visibility.isFreeAlong(
                camera.x(), camera.y(), camera.z(), vector.x(), vector.y(), vector.z(), Double.POSITIVE_INFINITY);
    }

    /**
     * The distance behind a drone at which the line of sight meets the ground or a building; beyond the edge of the
     * site, the ground is taken to be level, at the height of the site's lowest point.
     *
     * @param at origin of the drone, m
     * @return 0 or more, m; infinite for the sky
     */
    double background(Position at) {
        Position vector = at.minus(camera);
        if (visibility.findFirstAlong(
                at.x(), at.y(), at.z(), vector.x(), vector.y(), vector.z(), Double.POSITIVE_INFINITY)) {
            return visibility.distance() * vector.length();
        }
        double height = Math.max(0.0, at.z() - world.bounds().minZ());
        return vector.z() < 0.0 ? height / -vector.z() * vector.length() : Double.POSITIVE_INFINITY;
    }
}
