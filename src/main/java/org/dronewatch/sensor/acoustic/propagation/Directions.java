package org.dronewatch.sensor.acoustic.propagation;

import java.util.random.RandomGenerator;

/** Sets the directions of rays, evenly spread or drawn at random. */
public final class Directions {
    private static final double GOLDEN_ANGLE = Math.PI * (3.0 - Math.sqrt(5.0));

    private Directions() {}

    /**
     * Sets a ray's direction to one of {@code count} directions that are spread evenly over the sphere (Fibonacci
     * lattice).
     *
     * @param number index of the direction, 0 to {@code count} - 1
     */
    public static void ofLattice(int number, int count, AcousticRay ray) {
        double z = 1.0 - (2.0 * number + 1.0) / count;
        double radius = Math.sqrt(Math.max(0.0, 1.0 - z * z));
        ray.directionX = radius * Math.cos(GOLDEN_ANGLE * number);
        ray.directionY = radius * Math.sin(GOLDEN_ANGLE * number);
        ray.directionZ = z;
    }

    /** Draws a ray's direction uniformly from the sphere (Archimedes: the height is uniform). */
    public static void draw(RandomGenerator random, AcousticRay ray) {
        set(ray, 2.0 * random.nextDouble() - 1.0, random.nextDouble());
    }

    /**
     * Sets a ray's direction.
     *
     * @param z vertical component of the direction, -1 to 1
     * @param turn azimuth of the direction, from the x axis towards the y axis, as a fraction of a full turn, 0 to 1
     */
    public static void set(AcousticRay ray, double z, double turn) {
        double angle = 2.0 * Math.PI * turn;
        double radius = Math.sqrt(Math.max(0.0, 1.0 - z * z));
        ray.directionX = radius * Math.cos(angle);
        ray.directionY = radius * Math.sin(angle);
        ray.directionZ = z;
    }

    /**
     * Draws a ray's direction by Lambert's law about a unit normal: towards a uniformly distributed point of a unit
     * sphere that touches the surface.
     */
    public static void drawLambert(RandomGenerator random, double[] normal, AcousticRay ray) {
        double length;
        do {
            draw(random, ray);
            ray.directionX += normal[0];
            ray.directionY += normal[1];
            ray.directionZ += normal[2];
            length = Math.sqrt(ray.directionX * ray.directionX
                    + ray.directionY * ray.directionY
                    + ray.directionZ * ray.directionZ);
        } while (length < 1e-6);
        ray.directionX /= length;
        ray.directionY /= length;
        ray.directionZ /= length;
    }
}
