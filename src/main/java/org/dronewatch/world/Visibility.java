package org.dronewatch.world;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.RayTracer;

/**
 * Whether something of a world stands between two points, and what. The methods that take primitives allocate nothing.
 * Keeps scratch memory: one thread at a time.
 */
public final class Visibility {
    /**
     * How near to an end of a segment, as a fraction of its length, a surface counts as that on which the end lies: far
     * above rounding.
     */
    public static final double SURFACE = 1e-9;

    private final World world;
    private final RayTracer tracer;

    /** In a world. */
    public Visibility(World world) {
        this(world, world.newRayTracer());
    }

    private Visibility(World world, RayTracer tracer) {
        this.world = world;
        this.tracer = tracer;
    }

    /**
     * In a world, for segments that are unrelated to each other, such as the paths of diffuse sound; see {@link
     * World#newIncoherentRayTracer()}.
     */
    public static Visibility ofUnrelatedSegments(World world) {
        return new Visibility(world, world.newIncoherentRayTracer());
    }

    /** The world. */
    public World world() {
        return world;
    }

    /** Whether nothing stands between two points, m; a surface within {@link #SURFACE} of either end hides nothing. */
    public boolean isFree(Position from, Position to) {
        return isFree(from.x(), from.y(), from.z(), to.x(), to.y(), to.z());
    }

    /** The same in coordinates, m. */
    public boolean isFree(double fromX, double fromY, double fromZ, double toX, double toY, double toZ) {
        return isFreeAlong(fromX, fromY, fromZ, toX - fromX, toY - fromY, toZ - fromZ, SURFACE, 1.0 - SURFACE);
    }

    /**
     * Whether nothing stands along a vector from a point.
     *
     * @param x of the point, m
     * @param dx of the vector, which may have any length but 0, m
     * @param first from which multiple of the vector on surfaces count
     * @param last up to which multiple of the vector surfaces count; may be infinite
     */
    public boolean isFreeAlong(
            double x, double y, double z, double dx, double dy, double dz, double first, double last) {
        return !tracer.isOccluded(x, y, z, dx, dy, dz, first, last);
    }

    /** What stands first between two points, as seen from the first; empty where they see each other. */
    public Optional<Obstacle> obstacle(Position from, Position to) {
        Position way = to.minus(from);
        boolean hidden = findFirst(from.x(), from.y(), from.z(), way.x(), way.y(), way.z(), SURFACE, 1.0 - SURFACE);
        return hidden ? Optional.of(world.obstacle(tracer.triangle())) : Optional.empty();
    }

    /**
     * Looks for the first surface along a vector from a point.
     *
     * @param x of the point, m
     * @param dx of the vector, which may have any length but 0, m
     * @param first from which multiple of the vector on surfaces count
     * @param last up to which multiple of the vector surfaces count; may be infinite
     * @return whether there is one; {@link #triangle()} and {@link #distance()} then describe it
     */
    public boolean findFirst(double x, double y, double z, double dx, double dy, double dz, double first, double last) {
        return tracer.closestHit(x, y, z, dx, dy, dz, first, last);
    }

    /** The number of the triangle that was found last. */
    public int triangle() {
        return tracer.triangle();
    }

    /** Which multiple of the vector leads to the triangle that was found last. */
    public double distance() {
        return tracer.distance();
    }
}
