package org.dronewatch.bench;

/**
 * Rays to measure with.
 *
 * @param name what kind they are: {@code camera}, {@code diffuse} or {@code file}
 * @param rays six floats each: origin, then unit direction
 * @param width pixels in a row when the rays are a picture, row by row; 0 when they are not
 */
public record RaySet(String name, float[] rays, int width) {
    /** How many floats a ray has. */
    public static final int FLOATS = 6;

    /** How many rays there are. */
    public int count() {
        return rays.length / FLOATS;
    }
}
