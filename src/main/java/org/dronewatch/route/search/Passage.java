package org.dronewatch.route.search;

import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * Whether a drone can fly straight from one point to another without hitting anything solid. For one thread at a time.
 */
@FunctionalInterface
public interface Passage {
    /** A passage through a world in which nothing is solid. */
    Passage EVERYWHERE = (x, y, z, toX, toY, toZ) -> true;

    /** Whether the straight leg between two points is free of anything solid; all coordinates in m. */
    boolean isFree(double x, double y, double z, double toX, double toY, double toZ);

    /** The passage between the surfaces of a world, for a drone treated as a point. */
    static Passage through(World world) {
        return new Visibility(world)::isFree;
    }
}
