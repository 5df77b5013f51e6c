package org.dronewatch.bench;

/**
 * A set of rays for measurements.
 *
 * @param name kind of the rays: {@code camera}, {@code diffuse} or {@code file}
 * @param rays six floats each: origin, then direction
 * @param width pixels in a row if the rays are those of a picture, row by row; otherwise 0
 * @param query what is to be found for each ray
 */
public record RaySet(String name, float[] rays, int width, Query query) {
    /** The number of floats of a ray. */
    public static final int FLOATS = 6;

    /** What is to be found for a ray. */
    public enum Query {
        /** The nearest triangle along the ray. */
        NEAREST,
        /**
         * Whether any triangle lies between the ray's origin and the tip of its direction vector, which then spans the
         * whole segment.
         */
        OCCLUDED
    }

    /** Rays along each of which the nearest triangle is to be found. */
    public RaySet(String name, float[] rays, int width) {
        this(name, rays, width, Query.NEAREST);
    }

    /** The number of rays. */
    public int count() {
        return rays.length / FLOATS;
    }
}
