package org.dronewatch.world;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.RayTracer;

/**
 * Line-of-sight queries: whether a world has an obstacle between two points, and which.
 *
 * <p>A surface that a segment meets within {@link #MARGIN} of an end is taken to be the one on which that end lies, and
 * hides nothing: sensors on walls and microphones on the ground, and drones that touch a surface, are treated as if
 * they were just in front of it. Surfaces met farther away count. So a sensor within the margin of a wall sees what is
 * on both sides of it, and one farther behind the wall sees nothing in front of it. The margin is a length, not a
 * fraction of the segment, since neither the position of a sensor nor the rounding of coordinates depends on the range:
 * whether a sensor on a wall is blind does not depend on the range either. Points closer together than twice the margin
 * are always mutually visible.
 *
 * <p>Whether two points on one oblique face are mutually visible depends on the rounding of their coordinates;
 * {@link Clearance} moves points off their surfaces where that matters.
 *
 * <p>The methods that take primitives do not allocate. Keeps scratch memory: one thread at a time.
 */
public final class Visibility {
    /**
     * Distance from either end of a segment within which surfaces do not count, m. It is above the rounding error of a
     * mesh's single-precision coordinates within 100 m of the origin (4e-6 m), and far above that of computed points;
     * and it is below the distance by which {@link Clearance} moves points off a surface, so that they stay hidden from
     * the other side.
     */
    public static final double MARGIN = 1e-5;

    /**
     * As {@link #MARGIN}, but between points that are known to lie off all surfaces, m: above the rounding of computed
     * distances.
     */
    private static final double MARGIN_OF_CLEAR_POINTS = 1e-10;

    private final World world;
    private final RayTracer tracer;
    private final double skipped;

    /**
     * The segment along which surfaces are searched for: its beginning, its vector, and the multiple of that where it
     * ends.
     */
    private double x;

    private double y;
    private double z;
    private double dx;
    private double dy;
    private double dz;
    private double margin;
    private double last;

    /** Visibility in a world. */
    public Visibility(World world) {
        this(world, world.newRayTracer(), MARGIN);
    }

    private Visibility(World world, RayTracer tracer, double skipped) {
        this.world = world;
        this.tracer = tracer;
        this.skipped = skipped;
    }

    /**
     * Visibility in a world for incoherent segments, such as the paths of diffuse sound (see
     * {@link World#newIncoherentRayTracer()}), that end at points moved off the surfaces on which they lie. No surface
     * is skipped: in a corner, another wall may be nearer than {@link #MARGIN}, and sound would leak through it.
     */
    public static Visibility ofClearPoints(World world) {
        return new Visibility(world, world.newIncoherentRayTracer(), MARGIN_OF_CLEAR_POINTS);
    }

    /** The world. */
    public World world() {
        return world;
    }

    /** Whether two points, m, are mutually visible. */
    public boolean isFree(Position from, Position to) {
        return isFree(from.x(), from.y(), from.z(), to.x(), to.y(), to.z());
    }

    /** Whether two points, m, are mutually visible. */
    public boolean isFree(double fromX, double fromY, double fromZ, double toX, double toY, double toZ) {
        return isFreeAlong(fromX, fromY, fromZ, toX - fromX, toY - fromY, toZ - fromZ, 1.0);
    }

    /**
     * Whether a segment is free of obstacles.
     *
     * @param fromX x coordinate of the start of the segment, m
     * @param alongX x component of the vector along the segment, m
     * @param end the segment ends at this multiple of the vector, 0 or more; infinite for a ray without end
     */
    public boolean isFreeAlong(
            double fromX, double fromY, double fromZ, double alongX, double alongY, double alongZ, double end) {
        double room = margin(alongX, alongY, alongZ);
        return !tracer.isOccluded(fromX, fromY, fromZ, alongX, alongY, alongZ, room, end - room);
    }

    /**
     * The first obstacle on the line from one point to another; on the ground, its material is that of the land cover.
     * Empty if the points are mutually visible.
     */
    public Optional<Obstacle> obstacle(Position from, Position to) {
        Position along = to.minus(from);
        if (!findFirstAlong(from.x(), from.y(), from.z(), along.x(), along.y(), along.z(), 1.0)) {
            return Optional.empty();
        }
        Position at = from.plus(along.times(tracer.distance()));
        return Optional.of(world.obstacle(tracer.triangle(), at.x(), at.y()));
    }

    /**
     * Looks for the first surface along a vector from a point.
     *
     * @param fromX x coordinate of the start of the segment, m
     * @param alongX x component of the vector along the segment, m
     * @param end the segment ends at this multiple of the vector, 0 or more; infinite for a ray without end
     * @return whether there is one; {@link #triangle()} is its number
     */
    public boolean findFirstAlong(
            double fromX, double fromY, double fromZ, double alongX, double alongY, double alongZ, double end) {
        x = fromX;
        y = fromY;
        z = fromZ;
        dx = alongX;
        dy = alongY;
        dz = alongZ;
        margin = margin(alongX, alongY, alongZ);
        last = end - margin;
        return find(margin);
    }

    /**
     * Finds the next surface behind the last one found. Two surfaces that the segment meets within {@link #MARGIN} of
     * each other count as one; for {@linkplain #ofClearPoints clear points}, within 1e-10 m.
     *
     * @return whether there is one
     */
    public boolean findNext() {
        return findBeyond(tracer.distance());
    }

    /**
     * Finds the next surface beyond a point of the segment.
     *
     * @param distance distance of the point from the beginning, as a multiple of the vector
     * @return whether there is one
     */
    public boolean findBeyond(double distance) {
        return find(distance + margin);
    }

    /** The number of the last triangle found. */
    public int triangle() {
        return tracer.triangle();
    }

    /** The number of the material of the last surface found, at the point where it was found. */
    public int material() {
        double along = tracer.distance();
        return world.material(tracer.triangle(), x + along * dx, y + along * dy);
    }

    /** The distance to the last surface found, as a multiple of the vector. */
    public double distance() {
        return tracer.distance();
    }

    private boolean find(double first) {
        return first < last && tracer.closestHit(x, y, z, dx, dy, dz, first, last);
    }

    /** The multiple of a vector that is as long as what is skipped; infinite for one without length. */
    private double margin(double alongX, double alongY, double alongZ) {
        return skipped / Math.sqrt(alongX * alongX + alongY * alongY + alongZ * alongZ);
    }
}
