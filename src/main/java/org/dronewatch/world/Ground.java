package org.dronewatch.world;

import java.util.OptionalDouble;

/**
 * The ground below a flight. {@link World#newGround()} gives that of a world; it is for use by one thread, and only for
 * the creation of paths: finished paths no longer query it.
 */
@FunctionalInterface
public interface Ground {
    /** A ground without any surface, for flights that do not follow the ground. */
    Ground NONE = (x, y) -> OptionalDouble.empty();

    /**
     * The height of the highest surface at a point: ground, roof or tree.
     *
     * @param x east, m
     * @param y north, m
     * @return its z in metres; empty where there is no surface
     */
    OptionalDouble height(double x, double y);
}
