package org.dronewatch.bvh;

import org.dronewatch.kdtree.RayTracer;

/**
 * Four rays, unrelated to each other, that are traced together. Each hits what it would hit alone (see
 * {@link TracingIndex#newIncoherentRayTracer()}), at the same distance; inside a convex room, the distance may differ
 * by rounding. What a ray hits does not depend on the other rays. For use by one thread.
 */
public abstract class RayPacket {
    /** Number of rays. */
    public static final int RAYS = 4;

    private final int[] numbers;
    private final boolean[] hits = new boolean[RAYS];
    private final double[] distances = new double[RAYS];
    private final int[] hitTriangles = new int[RAYS];

    /**
     * A packet for a mesh.
     *
     * @param numbers of its triangles, in leaf order
     */
    RayPacket(int[] numbers) {
        this.numbers = numbers;
    }

    /**
     * Sets one of the rays.
     *
     * @param ray index of the ray, 0 to 3
     * @param ox x of the origin, m
     * @param oy y of the origin, m
     * @param oz z of the origin, m
     * @param dx x of the direction, a unit vector
     * @param dy y of the direction
     * @param dz z of the direction
     */
    public abstract void set(int ray, double ox, double oy, double oz, double dx, double dy, double dz);

    /**
     * Finds the nearest triangle along each of the first {@code count} rays.
     *
     * @param count number of rays to trace, 1 to 4
     */
    public abstract void trace(int count);

    /** Records whether a ray hits a triangle, which is given by its index in leaf order. */
    final void keep(int ray, boolean isHit, int indexInLeafOrder, double distance) {
        hits[ray] = isHit;
        distances[ray] = distance;
        hitTriangles[ray] = numbers[indexInLeafOrder];
    }

    /** Records that a ray hits a triangle, which is given by its number in the mesh. */
    final void keepHit(int ray, int triangle, double distance) {
        hits[ray] = true;
        distances[ray] = distance;
        hitTriangles[ray] = triangle;
    }

    final void keep(int ray, boolean isHit, RayTracer tracer) {
        hits[ray] = isHit;
        distances[ray] = tracer.distance();
        hitTriangles[ray] = tracer.triangle();
    }

    /** Whether a ray hits anything. */
    public final boolean isHit(int ray) {
        return hits[ray];
    }

    /** The distance from the origin of a ray to the triangle that it hits, m; undefined if it hits none. */
    public final double distance(int ray) {
        return distances[ray];
    }

    /** The index in the mesh of the triangle that a ray hits; undefined if it hits none. */
    public final int triangle(int ray) {
        return hitTriangles[ray];
    }
}
