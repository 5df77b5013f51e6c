package org.dronewatch.sensor.acoustic.level;

import java.util.random.RandomGenerator;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.sensor.Draws;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.Directions;
import org.dronewatch.world.World;

/**
 * The probability that a look of the level model detects a drone. The rays of a look are independent, so it misses the
 * drone if the straight ray and all n rays in random directions, with all rays that descend from each, are too quiet:
 * {@code m = m0 (1 - q)^n}. A ray that hits a surface is missed if the specular ray, the ray straight to the sensor and
 * the k scattered rays are all missed: {@code m0 = m1 m2 (1 - s)^k}. The probabilities q and s are those of single
 * rays, of which many are traced in directions that are spread evenly, so that far fewer rays are needed than in whole
 * looks. The ray budget must not end any ray. Not thread-safe.
 */
final class LookProbability {
    /** Maximum number of scattered rays of the straight ray that are traced. */
    private static final int SCATTERED = 65_536;

    /** Maximum number of rays in random directions that are traced. */
    private static final int EMITTED = 65_536;

    /** The number of scattered rays is divided by this for each specular or aimed ray that follows from another ray. */
    private static final int PART = 4;

    /** A number of rays below which they show nothing. */
    private static final int FEWEST = 256;

    /** The approximate maximum number of ray segments that are traced. */
    private static final long MOST_SEGMENTS = 2_000_000;

    /**
     * A probability is accurate enough once its variance is 0.15 times that of the fraction of a thousand looks. With a
     * factor of 0.25, 1.5 % of cells were outside the 99 % interval of a thousand looks; with 0.15, 1.4 %; and with
     * rays up to the limit, 1.15 %.
     */
    private static final double VARIANCE = 0.15 / 1000;

    /** Probabilities need not be more accurate than this one. */
    private static final double LEAST = 0.004;

    /**
     * The factor by which the variance is greater in the first estimate that may show on which side of a boundary a
     * probability lies.
     */
    private static final double FIRST_VARIANCE = 256.0;

    /** The factor by which the variance decreases with each further estimate. */
    private static final double STEP = 1.0 / 16.0;

    /** The distance from the boundary, in standard errors, at which the side is certain enough. */
    private static final double SURE = 3.0;

    private final LevelModel model;
    private final Position sensor;
    private final double radius;
    private final double detectionLevel;
    private final LevelTracer tracer;
    private final RayTracer traversal;
    private final ReflectionGenerator reflections;
    private final DecisiveRays decisive;

    private EvenPairs even;
    private long seed;
    private long rays;
    private long segments;

    /** The sum of the variances of the logarithms of the factors. */
    private double variance;

    /** The variance and the probability that are small enough. */
    private double sufficient;

    private double least;

    /** The probability of which only the side matters; NaN for none. */
    private double boundary;

    LookProbability(LevelModel model, Position sensor, double radius, double detectionLevel, World world) {
        this.model = model;
        this.sensor = sensor;
        this.radius = radius;
        this.detectionLevel = detectionLevel;
        SurfaceLevels surfaces = new SurfaceLevels(world);
        this.tracer = new LevelTracer(model, sensor, radius, detectionLevel, world);
        this.traversal = world.newRayTracer();
        this.decisive = new DecisiveRays(model, sensor, radius, detectionLevel, surfaces);
        this.reflections = new ReflectionGenerator(model, world, surfaces, sensor, decisive.radius());
    }

    /**
     * An estimate of a probability.
     *
     * @param value the probability, 0 to 1
     * @param error upper estimate of its standard error: the scatter between blocks of rays, which are less evenly
     *     spread than all rays
     */
    record Estimate(double value, double error) {}

    /**
     * Estimates the probability for a drone.
     *
     * @param source position of the drone, m
     * @param sourceLevel level of the drone, dB
     */
    Estimate of(Position source, double sourceLevel, RandomGenerator random) {
        boundary = Double.NaN;
        return estimate(source, sourceLevel, random, VARIANCE, LEAST);
    }

    /**
     * Estimates the probability until it is clear whether it reaches a boundary, and at most as accurately as
     * {@link #of}: the nearer the probability is to the boundary, the more rays are traced.
     *
     * @param reached the boundary, above 0 and at most 1
     */
    Estimate sideOf(double reached, Position source, double sourceLevel, RandomGenerator random) {
        boundary = reached;
        double coarse = FIRST_VARIANCE;
        double small = Math.max(LEAST, boundary / 2.0);
        Estimate found = estimate(source, sourceLevel, random, coarse * VARIANCE, small);
        while (coarse > 1.0 && !isClear(found.value(), found.error())) {
            coarse *= STEP;
            found = estimate(source, sourceLevel, random, coarse * VARIANCE, small);
        }
        return found;
    }

    /** Whether it is clear on which side of the boundary a probability lies. */
    private boolean isClear(double value, double error) {
        return Math.abs(value - boundary) > SURE * error;
    }

    private Estimate estimate(
            Position source, double sourceLevel, RandomGenerator random, double enough, double small) {
        sufficient = enough;
        least = small;
        even = new EvenPairs(random);
        seed = random.nextLong();
        rays = 0;
        segments = 0;
        variance = 0.0;
        AcousticRay ray = new AcousticRay();
        ray.originX = source.x();
        ray.originY = source.y();
        ray.originZ = source.z();
        ray.level = sourceLevel;
        ray.medium = AcousticRay.AIR;
        aim(ray);
        double missed = miss(ray, SCATTERED, 1.0);
        missed *= ofEmitted(ray, missed);
        return new Estimate(1.0 - missed, missed * Math.sqrt(variance));
    }

    private void aim(AcousticRay ray) {
        Position along = sensor.minus(new Position(ray.originX, ray.originY, ray.originZ));
        double length = along.length();
        ray.directionX = length > 0.0 ? along.x() / length : 1.0;
        ray.directionY = length > 0.0 ? along.y() / length : 0.0;
        ray.directionZ = length > 0.0 ? along.z() / length : 0.0;
    }

    /** The probability that all rays in random directions are missed. */
    private double ofEmitted(AcousticRay ray, double others) {
        RayShare share = new RayShare(model.initialRays());
        while (isWorthwhile(share.traced(), EMITTED, others * share.missed(), share.variance())
                && !(share.traced() >= FEWEST && isClear(others, share))) {
            Directions.draw(even, ray);
            share.add(isHeard(ray));
        }
        variance += share.variance();
        return share.missed();
    }

    private boolean isClear(double others, RayShare share) {
        double missed = others * share.missed();
        return isClear(1.0 - missed, missed * Math.sqrt(variance + share.variance()));
    }

    private boolean isHeard(AcousticRay ray) {
        boolean isHeard = tracer.detects(ray, Draws.mix(seed, rays++));
        segments += tracer.traced();
        return isHeard;
    }

    private boolean isHeardIfDecisive(AcousticRay branch) {
        return branch.level >= detectionLevel && decisive.include(branch) && isHeard(branch);
    }

    /**
     * The probability that a ray, together with all rays that descend from it, is missed.
     *
     * @param number maximum number of scattered rays that are traced if it hits a surface
     * @param others the probability that all other rays so far are missed
     */
    private double miss(AcousticRay ray, int number, double others) {
        boolean isHit = ray.meets(traversal);
        double distance = isHit ? traversal.distance() : Double.POSITIVE_INFINITY;
        if (ray.entry(sensor, radius) < distance) {
            double toCentre = sensor.distance(new Position(ray.originX, ray.originY, ray.originZ));
            return ray.level - model.attenuation() * toCentre >= detectionLevel ? 0.0 : 1.0;
        }
        double arriving = ray.level - model.attenuation() * distance;
        if (!isHit || arriving < detectionLevel || ray.order >= model.maxOrder()) {
            return 1.0;
        }
        ScatteringHit hit = new ScatteringHit(
                reflections, model.reflectionsPerHit(), even, ray, distance, traversal.triangle(), arriving);
        while (hit.scattered() > 0 && isWorthwhile(hit.traced(), number, others * hit.missed(), hit.variance())) {
            hit.scatter(this::isHeardIfDecisive);
        }
        variance += hit.variance();
        double missed = hit.missed();
        AcousticRay next = new AcousticRay();
        for (int i = 0; i < hit.certain().added() && missed > 0.0; i++) {
            hit.certain().get(i, next);
            missed *= decisive.include(next) ? miss(next, Math.max(FEWEST, number / PART), others * missed) : 1.0;
        }
        return missed;
    }

    /**
     * Whether to trace more rays.
     *
     * @param traced number of rays that have been traced
     * @param missed the probability that these rays and all others so far are missed
     * @param variance variance of the logarithm of that probability, as far as it depends on these rays
     */
    private boolean isWorthwhile(int traced, int most, double missed, double variance) {
        boolean isLeft = traced < most && segments < MOST_SEGMENTS;
        return traced < FEWEST || isLeft && missed * variance > sufficient * Math.max(least, 1.0 - missed);
    }
}
