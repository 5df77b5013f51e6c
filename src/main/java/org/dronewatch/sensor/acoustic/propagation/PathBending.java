package org.dronewatch.sensor.acoustic.propagation;

import org.dronewatch.geometry.Position;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/** The curvature of sound paths by the air of a world. One per thread. */
public final class PathBending {
    private final Atmosphere air;
    private final Visibility visibility;

    /** Curvatures in a world. */
    public PathBending(World world) {
        this.air = world.atmosphere();
        this.visibility = new Visibility(world);
    }

    /** The curvature of all paths of one look. */
    public PathCurvature between(Position source, Position sensor) {
        return air.isUniform() ? PathCurvature.NONE : PathCurvature.of(air, height(source), height(sensor));
    }

    /** The wind's speed at a position, m/s. */
    public double windAt(Position position) {
        return air.wind().speedAt(height(position));
    }

    /** Over what is below; where nothing is, over z = 0. */
    private double height(Position at) {
        boolean isOverGround =
                visibility.findFirstAlong(at.x(), at.y(), at.z(), 0.0, 0.0, -1.0, Double.POSITIVE_INFINITY);
        return isOverGround ? visibility.distance() : Math.max(0.0, at.z());
    }
}
