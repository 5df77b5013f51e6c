package org.dronewatch.sensor.acoustic.level;

import java.util.function.Predicate;
import java.util.random.RandomGenerator;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;

/**
 * A hit of a ray on a surface, and the rays that leave the surface there: some in fixed directions, the others
 * scattered.
 */
final class ScatteringHit {
    private final ReflectionGenerator reflections;
    private final RandomGenerator random;
    private final AcousticRay ray;
    private final double distance;
    private final int triangle;
    private final double arriving;

    /** The number of rays that leave the surface on the side of the ray. */
    private final int perHit;

    /** The rays whose directions are not random. */
    private final RayQueue certain = new RayQueue();

    /** The scattered rays on the side of the ray, and behind the surface. */
    private final RayShare ahead;

    private final RayShare behind;

    /** The number of rays that have left the surface in a look. */
    private int made;

    /**
     * A hit.
     *
     * @param perHit number of rays that leave a surface on the side of the ray
     * @param random draws the directions of scattered rays
     * @param ray the ray; it must not change
     * @param distance distance from its origin to the triangle, m
     * @param triangle index of the triangle in the world's mesh
     * @param arriving level of the ray at the triangle, dB
     */
    ScatteringHit(
            ReflectionGenerator reflections,
            int perHit,
            RandomGenerator random,
            AcousticRay ray,
            double distance,
            int triangle,
            double arriving) {
        this.reflections = reflections;
        this.perHit = perHit;
        this.random = random;
        this.ray = ray;
        this.distance = distance;
        this.triangle = triangle;
        this.arriving = arriving;
        distribute(branch -> ScatteredRays.Wanted.NONE, certain::add);
        distribute(branch -> ScatteredRays.Wanted.ALL, branch -> made++);
        // Behind a surface, the first ray is the refracted one.
        int transmitted = Math.max(0, made - perHit - 1);
        this.behind = new RayShare(transmitted);
        this.ahead = new RayShare(made - transmitted - certain.added());
    }

    private void distribute(ScatteredRays.Choice wanted, ReflectionGenerator.Branches target) {
        reflections.acousticDistribution(
                ray, distance, triangle, arriving, new ReflectionGenerator.Draw(random, target, wanted));
    }

    /** The rays whose directions are not random. */
    RayQueue certain() {
        return certain;
    }

    /** The number of scattered rays in a look. */
    int scattered() {
        return ahead.number() + behind.number();
    }

    /** The number of scattered rays that were traced. */
    int traced() {
        return ahead.traced() + behind.traced();
    }

    /** Traces the scattered rays of one more look. */
    void scatter(Predicate<AcousticRay> isHeard) {
        made = 0;
        int aimed = perHit - ahead.number();
        distribute(branch -> ScatteredRays.Wanted.ALL, branch -> {
            if (made >= aimed && made < perHit) {
                ahead.add(isHeard.test(branch));
            } else if (made > perHit) {
                behind.add(isHeard.test(branch));
            }
            made++;
        });
    }

    /** The probability that all scattered rays of a look are missed. */
    double missed() {
        return ahead.missed() * behind.missed();
    }

    /** The variance of the logarithm of that probability. */
    double variance() {
        return ahead.variance() + behind.variance();
    }
}
