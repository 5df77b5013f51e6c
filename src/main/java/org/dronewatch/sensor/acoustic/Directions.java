package org.dronewatch.sensor.acoustic;

import java.util.random.RandomGenerator;

/** Random directions. */
final class Directions {
    private Directions() {}

    /** Gives a ray a direction drawn uniformly from the sphere (Archimedes: the height is uniform). */
    static void draw(RandomGenerator random, AcousticRay ray) {
        double z = 2.0 * random.nextDouble() - 1.0;
        double angle = 2.0 * Math.PI * random.nextDouble();
        double radius = Math.sqrt(Math.max(0.0, 1.0 - z * z));
        ray.directionX = radius * Math.cos(angle);
        ray.directionY = radius * Math.sin(angle);
        ray.directionZ = z;
    }
}
