package org.dronewatch.bench;

/**
 * A set of rays for measurements.
 *
 * @param name their kind: {@code camera}, {@code diffuse} or {@code file}
 * @param rays six floats each: origin, then unit direction
 * @param width pixels in a row when the rays are a picture, row by row; 0 when they are not
 */
public record RaySet(String name, float[] rays, int width) {
    /** The number of floats of a ray. */
    public static final int FLOATS = 6;

    /** The number of rays. */
    public int count() {
        return rays.length / FLOATS;
    }
}
