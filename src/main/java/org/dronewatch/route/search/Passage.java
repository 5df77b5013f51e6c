package org.dronewatch.route.search;

import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/** Whether a drone can fly straight from one point to another without meeting anything solid. One thread at a time. */
@FunctionalInterface
public interface Passage {
    /** A passage where nothing is solid. */
    Passage EVERYWHERE = (x, y, z, toX, toY, toZ) -> true;

    /** Whether a straight leg is free, m. */
    boolean isFree(double x, double y, double z, double toX, double toY, double toZ);

    /** The passage between the surfaces of a world, for a drone that is a point. */
    static Passage through(World world) {
        return new Visibility(world)::isFree;
    }
}
