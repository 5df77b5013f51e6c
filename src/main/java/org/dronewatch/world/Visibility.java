package org.dronewatch.world;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.RayTracer;

/** Whether something of a world stands between two places, and what. Keeps scratch memory: one thread at a time. */
public final class Visibility {
    private final World world;
    private final RayTracer tracer;

    /** In a world. */
    public Visibility(World world) {
        this.world = world;
        this.tracer = world.newRayTracer();
    }

    /** The world. */
    public World world() {
        return world;
    }

    /** Whether nothing stands between two places; a surface within {@link World#SURFACE} of either end hides nothing. */
    public boolean isFree(Position from, Position to) {
        Position way = to.minus(from);
        return !tracer.isOccluded(
                from.x(), from.y(), from.z(), way.x(), way.y(), way.z(), World.SURFACE, 1.0 - World.SURFACE);
    }

    /** What stands first between two places, as seen from the first; empty where they see each other. */
    public Optional<Obstacle> obstacle(Position from, Position to) {
        Position way = to.minus(from);
        boolean hidden = tracer.closestHit(
                from.x(), from.y(), from.z(), way.x(), way.y(), way.z(), World.SURFACE, 1.0 - World.SURFACE);
        return hidden ? Optional.of(world.obstacle(tracer.triangle())) : Optional.empty();
    }
}
