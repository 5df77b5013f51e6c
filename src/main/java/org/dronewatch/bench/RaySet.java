package org.dronewatch.bench;

/**
 * A set of rays for measurements.
 *
 * @param name their kind: {@code camera}, {@code diffuse} or {@code file}
 * @param rays six floats each: origin, then direction
 * @param width pixels in a row when the rays are a picture, row by row; 0 when they are not
 * @param query what is asked of each ray
 */
public record RaySet(String name, float[] rays, int width, Query query) {
    /** The number of floats of a ray. */
    public static final int FLOATS = 6;

    /** What is asked of a ray. */
    public enum Query {
        /** The nearest triangle along it. */
        NEAREST,
        /**
         * Whether any triangle lies between its origin and the end of its direction, which then spans the whole
         * segment.
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
