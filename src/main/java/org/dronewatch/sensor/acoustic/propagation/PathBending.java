package org.dronewatch.sensor.acoustic.propagation;

import org.dronewatch.geometry.Position;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.world.GroundLevel;
import org.dronewatch.world.World;

/**
 * The wind of a world, and the curvature of sound paths that gradients of wind and temperature cause. Heights are
 * measured from the ground of the site: the profile of the wind does not follow a roof or the crown of a tree. For use
 * by one thread.
 */
public final class PathBending {
    private final Atmosphere air;

    /** The level of the ground; null in uniform air, for which it is not needed. */
    private final GroundLevel ground;

    /** Wind and curvatures in a world. */
    public PathBending(World world) {
        this.air = world.atmosphere();
        this.ground = air.isUniform() ? null : new GroundLevel(world);
    }

    /** The curvature of all sound paths from the source to the sensor in one look. */
    public PathCurvature between(Position source, Position sensor) {
        return air.isUniform()
                ? PathCurvature.NONE
                : PathCurvature.of(air, ground.height(source), ground.height(sensor));
    }

    /** The wind's speed at a position, m/s. */
    public double windAt(Position position) {
        return air.isUniform() ? 0.0 : air.wind().speedAt(ground.height(position));
    }
}
