package org.dronewatch.kdtree;

import java.util.Optional;
import org.dronewatch.geometry.Hit;
import org.dronewatch.geometry.Ray;
import org.jogamp.vecmath.Point3d;
import org.jogamp.vecmath.Vector3d;

/**
 * A ray tracer of a mesh. One per thread: it holds the ray and the hit of its most recent query. The methods that take
 * primitives do not allocate.
 *
 * <p>Origins (ox, oy, oz) are in metres in the mesh's frame. A direction (dx, dy, dz) may have any length but zero;
 * distances are ray parameters, which are metres for a unit direction. Triangles are hit from either side. The
 * protected members are for the ray tracers of this library, in this package and in bvh.
 */
public abstract class RayTracer {
    /** Origin of the current ray; subclasses only read it. */
    protected final double[] origin = new double[3];

    /** Direction of the current ray; subclasses only read it. */
    protected final double[] direction = new double[3];

    /** One over each component of the direction; subclasses only read it. */
    protected final double[] inverse = new double[3];

    final TriangleIntersection intersection;

    /** Whether the hit was kept without its barycentrics: few callers want them. */
    private boolean lacksBarycentrics;

    /**
     * A tracer without a ray.
     *
     * @param triangles triangles of the mesh
     */
    protected RayTracer(LeafOrderTriangles triangles) {
        this.intersection = new TriangleIntersection(triangles);
    }

    /**
     * Finds the nearest triangle along a ray. Of several triangles with the same corners, the one with the lowest index
     * is reported. If a ray hits an edge or a corner shared by several triangles, which of them is reported may depend
     * on the tracer.
     *
     * @param tMin the smallest ray parameter that counts, 0 or more
     * @param tMax the largest ray parameter that counts
     * @return whether there is a hit; its {@link #distance()}, {@link #triangle()}, {@link #u()} and {@link #v()} can
     *     be read until the next query
     */
    public final boolean closestHit(
            double ox, double oy, double oz, double dx, double dy, double dz, double tMin, double tMax) {
        setRay(ox, oy, oz, dx, dy, dz);
        intersection.begin(tMax);
        lacksBarycentrics = false;
        trace(tMin, tMax, false);
        return intersection.found();
    }

    /**
     * The nearest triangle along a ray, or empty. Allocates memory; inner loops use the method that takes primitives.
     */
    public final Optional<Hit> closestHit(Ray ray) {
        Point3d o = ray.origin();
        Vector3d d = ray.direction();
        return closestHit(o.x, o.y, o.z, d.x, d.y, d.z, ray.tMin(), ray.tMax())
                ? Optional.of(new Hit(distance(), triangle(), u(), v()))
                : Optional.empty();
    }

    /**
     * Whether any triangle lies strictly between two ray parameters. Since rounding moves computed points slightly off
     * their surface, leave a margin at both ends of a segment between points on surfaces.
     *
     * @param tMin the lower ray parameter, 0 or more, exclusive
     * @param tMax the upper ray parameter, exclusive
     */
    public final boolean isOccluded(
            double ox, double oy, double oz, double dx, double dy, double dz, double tMin, double tMax) {
        double first = Math.nextUp(tMin);
        double last = Math.nextDown(tMax);
        if (!(first <= last)) {
            return false;
        }
        setRay(ox, oy, oz, dx, dy, dz);
        intersection.begin(last);
        trace(first, last, true);
        return intersection.found();
    }

    /** Ray parameter of the closest hit found by the most recent query. */
    public final double distance() {
        return intersection.distance();
    }

    /** Index in the mesh of the triangle of the closest hit found by the most recent query. */
    public final int triangle() {
        return intersection.triangle();
    }

    /** Barycentric weight of the triangle's second corner at the closest hit found by the most recent query. */
    public final double u() {
        findMissingBarycentrics();
        return intersection.u();
    }

    /** Barycentric weight of the triangle's third corner at the closest hit found by the most recent query. */
    public final double v() {
        findMissingBarycentrics();
        return intersection.v();
    }

    private void findMissingBarycentrics() {
        if (lacksBarycentrics) {
            findBarycentrics();
            lacksBarycentrics = false;
        }
    }

    private void setRay(double ox, double oy, double oz, double dx, double dy, double dz) {
        origin[0] = ox;
        origin[1] = oy;
        origin[2] = oz;
        direction[0] = dx;
        direction[1] = dy;
        direction[2] = dz;
        for (int axis = 0; axis < 3; axis++) {
            inverse[axis] = Ray.inverse(direction[axis]);
        }
    }

    /**
     * Traces the current ray and stores the hit; tracers in other packages do so with {@link #setHit}.
     *
     * @param tMin the smallest ray parameter that counts
     * @param tMax the largest ray parameter that counts
     * @param anyHit whether any hit suffices, or the nearest is required
     */
    protected abstract void trace(double tMin, double tMax, boolean anyHit);

    /**
     * Whether the ray misses a triangle although all edge functions have the same sign, which happens only for edge-on
     * triangles; tracers check their hits with this method. The corners are relative to the ray's origin and sheared so
     * that the ray lies along the third axis; the arguments are the other two coordinates of each corner.
     */
    protected static boolean isBeside(double ax, double ay, double bx, double by, double cx, double cy) {
        return TriangleIntersection.isBeside(ax, ay, bx, by, cx, cy);
    }

    /**
     * Computes the barycentrics of the hit of the current ray and passes them to {@link #setBarycentrics}; for tracers
     * that store hits without barycentrics.
     */
    protected void findBarycentrics() {
        throw new IllegalStateException("hits are kept with their barycentrics");
    }

    /**
     * Stores a hit of the current ray that was found with the same arithmetic as this package's triangle test, without
     * its barycentrics.
     *
     * @param triangle index of the triangle in the mesh
     * @param distance ray parameter of the hit
     */
    protected final void setHit(int triangle, double distance) {
        intersection.setHit(triangle, distance);
        lacksBarycentrics = true;
    }

    /** Adds the barycentric weights of the second and third corners to the hit of the current ray. */
    protected final void setBarycentrics(double u, double v) {
        intersection.setBarycentrics(u, v);
        lacksBarycentrics = false;
    }
}
