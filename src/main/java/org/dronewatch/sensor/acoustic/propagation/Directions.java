package org.dronewatch.sensor.acoustic.propagation;

import java.util.random.RandomGenerator;

/** Random directions. */
public final class Directions {
    private Directions() {}

    /** Gives a ray a direction drawn uniformly from the sphere (Archimedes: the height is uniform). */
    public static void draw(RandomGenerator random, AcousticRay ray) {
        double z = 2.0 * random.nextDouble() - 1.0;
        double angle = 2.0 * Math.PI * random.nextDouble();
        double radius = Math.sqrt(Math.max(0.0, 1.0 - z * z));
        ray.directionX = radius * Math.cos(angle);
        ray.directionY = radius * Math.sin(angle);
        ray.directionZ = z;
    }

    /** Gives a ray a direction by Lambert's law about a unit normal: a uniform point of the sphere that touches it. */
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
