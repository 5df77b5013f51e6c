package org.dronewatch.world;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.RayTracer;

/**
 * Whether something in a world stands between two points, and what.
 *
 * <p>A surface that a segment meets within {@link #MARGIN} of an end is taken for the one on which the end lies, and
 * hides nothing: sensors on walls and microphones on the ground see and hear as they do just in front of it, and so do
 * drones that touch it. What is met farther away counts. So a sensor within the margin of a wall sees out on both sides
 * of the wall, and one farther behind it is blind to what lies in front of it. The margin is a length and not a
 * fraction of the segment, since neither the position of a sensor nor the rounding of coordinates becomes less exact
 * with the distance of what it looks at: whether a sensor on a wall is blind does not depend on the range. Nothing
 * counts as standing between points closer together than twice the margin.
 *
 * <p>Whether two points of one oblique face see each other depends on the rounding of their coordinates;
 * {@link Clearance} moves points off their surfaces where that matters.
 *
 * <p>The methods that take primitives allocate nothing. Keeps scratch memory: one thread at a time.
 */
public final class Visibility {
    /**
     * How far along a segment, from either end, surfaces do not count, m. It is above the rounding of a mesh's
     * coordinates, which are of single precision, within 100 m of the origin (4e-6 m), and far above that of computed
     * points; and it is below the distance to which {@link Clearance} moves what lies on a surface, on the far side of
     * which it stays hidden.
     */
    public static final double MARGIN = 1e-5;

    /** The same between points that are known to lie off all surfaces, m: above the rounding of computed distances. */
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

    /** In a world. */
    public Visibility(World world) {
        this(world, world.newRayTracer(), MARGIN);
    }

    private Visibility(World world, RayTracer tracer, double skipped) {
        this.world = world;
        this.tracer = tracer;
        this.skipped = skipped;
    }

    /**
     * In a world, for segments that are unrelated to each other, such as the paths of diffuse sound (see {@link
     * World#newIncoherentRayTracer()}), and end at points that have been moved off the surfaces on which they lie.
     * There no surface is skipped: in a corner, another wall may be nearer than {@link #MARGIN}, and sound would leak
     * through it.
     */
    public static Visibility ofClearPoints(World world) {
        return new Visibility(world, world.newIncoherentRayTracer(), MARGIN_OF_CLEAR_POINTS);
    }

    /** The world. */
    public World world() {
        return world;
    }

    /** Whether nothing stands between two points, m. */
    public boolean isFree(Position from, Position to) {
        return isFree(from.x(), from.y(), from.z(), to.x(), to.y(), to.z());
    }

    /** Whether nothing stands between two points, m. */
    public boolean isFree(double fromX, double fromY, double fromZ, double toX, double toY, double toZ) {
        return isFreeAlong(fromX, fromY, fromZ, toX - fromX, toY - fromY, toZ - fromZ, 1.0);
    }

    /**
     * Whether nothing stands along a vector from a point.
     *
     * @param fromX of the point, m
     * @param alongX of the vector, m
     * @param end which multiple of the vector leads to the end of the segment, 0 or more; infinite for one without end
     */
    public boolean isFreeAlong(
            double fromX, double fromY, double fromZ, double alongX, double alongY, double alongZ, double end) {
        double room = margin(alongX, alongY, alongZ);
        return !tracer.isOccluded(fromX, fromY, fromZ, alongX, alongY, alongZ, room, end - room);
    }

    /** What stands first between two points, as seen from the first; empty where they see each other. */
    public Optional<Obstacle> obstacle(Position from, Position to) {
        Position along = to.minus(from);
        boolean hidden = findFirstAlong(from.x(), from.y(), from.z(), along.x(), along.y(), along.z(), 1.0);
        return hidden ? Optional.of(world.obstacle(tracer.triangle())) : Optional.empty();
    }

    /**
     * Looks for the first surface along a vector from a point.
     *
     * @param fromX of the point, m
     * @param alongX of the vector, m
     * @param end which multiple of the vector leads to the end of the segment, 0 or more; infinite for one without end
     * @return whether there is one, whose number {@link #triangle()} then is
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
     * Looks for the next surface behind the one that was found last; two that are met within {@link #MARGIN} of each
     * other, or between clear points within 1e-10 m, count as one.
     *
     * @return whether there is one
     */
    public boolean findNext() {
        return find(tracer.distance() + margin);
    }

    /** The number of the triangle that was found last. */
    public int triangle() {
        return tracer.triangle();
    }

    /** Which multiple of the vector leads to what was found last. */
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
