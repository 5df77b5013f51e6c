package org.dronewatch.route.search;

import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/** Whether a drone can fly straight from one point to another without hitting anything solid. Thread-safe. */
@FunctionalInterface
public interface Passage {
    /** A passage through a world in which nothing is solid. */
    Passage EVERYWHERE = (x, y, z, toX, toY, toZ) -> true;

    /** Whether the straight leg between two points is free of anything solid; all coordinates in m. */
    boolean isFree(double x, double y, double z, double toX, double toY, double toZ);

    /** The passage between the surfaces of a world, for a drone treated as a point. */
    static Passage through(World world) {
        // A ray tracer serves one thread.
        ThreadLocal<Visibility> here = ThreadLocal.withInitial(() -> new Visibility(world));
        return (x, y, z, toX, toY, toZ) -> here.get().isFree(x, y, z, toX, toY, toZ);
    }
}
