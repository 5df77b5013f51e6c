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
 * drone if the straight ray and all n rays in random directions, with what comes of each, are too quiet:
 * {@code m = m0 (1 - q)^n}. A ray that hits a surface is missed if the specular ray, that straight at the sensor and
 * the k scattered ones are: {@code m0 = m1 m2 (1 - s)^k}. The probabilities q and s are those of single rays, of which
 * many are traced in directions that are spread evenly, so that far fewer rays are needed than in whole looks. The ray
 * budget must not end any ray. One thread at a time.
 */
final class LookProbability {
    /** Scattered rays of the straight ray that are traced, at most. */
    private static final int SCATTERED = 65_536;

    /** Rays in random directions that are traced. */
    private static final int EMITTED = 4096;

    /** Rays in random directions if at least two of the former detect the drone: then they matter. */
    private static final int EMITTED_IF_HEARD = 16_384;

    private static final int HEARD = 2;

    /** Scattered rays of a specular or aimed ray, as a part of those of the ray before. */
    private static final int PART = 4;

    /** Fewer rays show nothing. */
    private static final int FEWEST = 256;

    /** About as many ray segments are traced at most. */
    private static final long MOST_SEGMENTS = 2_000_000;

    /**
     * A probability is accurate enough once the variance that it would have with independent directions is a quarter of
     * that of the fraction of a thousand looks.
     */
    private static final double VARIANCE = 0.25 / 1000;

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
     * A probability.
     *
     * @param value 0 to 1
     * @param error its standard error, at most: that of as many rays in independent directions
     */
    record Estimate(double value, double error) {}

    /**
     * Estimates the probability for a drone.
     *
     * @param source position of the drone, m
     * @param sourceLevel its level, dB
     */
    Estimate of(Position source, double sourceLevel, RandomGenerator random) {
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
        double missed = ofEmitted(ray);
        aim(ray);
        missed *= miss(ray, SCATTERED);
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
    private double ofEmitted(AcousticRay ray) {
        int traced = 0;
        int heard = 0;
        while (traced < (heard < HEARD ? EMITTED : EMITTED_IF_HEARD) && isLeft(traced)) {
            Directions.draw(even, ray);
            heard += isHeard(ray) ? 1 : 0;
            traced++;
        }
        return missed(heard, traced, model.initialRays());
    }

    private boolean isLeft(int traced) {
        return segments < MOST_SEGMENTS || traced < FEWEST;
    }

    private boolean isHeard(AcousticRay ray) {
        boolean isHeard = tracer.detects(ray, Draws.mix(seed, rays++));
        segments += tracer.traced();
        return isHeard;
    }

    /** The probability that a number of rays are missed, by how many of others have been heard. */
    private double missed(int heard, int traced, int number) {
        variance += variance(heard, traced, number);
        return Math.pow(1.0 - (double) heard / traced, number);
    }

    /** The variance of the logarithm of that probability; with a uniform prior, so that it is never 0. */
    private static double variance(int heard, int traced, int number) {
        double likely = (heard + 1.0) / (traced + 2.0);
        return (double) number * number * likely / (traced * (1.0 - likely));
    }

    /**
     * The probability that a ray, with all that comes of it, is missed.
     *
     * @param number of scattered rays that are traced if it hits a surface
     */
    private double miss(AcousticRay ray, int number) {
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
        Hit hit = new Hit(ray, distance, traversal.triangle(), arriving);
        while (hit.scattered() > 0
                && hit.traced() < number
                && isLeft(hit.traced())
                && (hit.traced() < FEWEST || !hit.isAccurate())) {
            hit.scatter();
        }
        double missed = hit.missed();
        AcousticRay next = new AcousticRay();
        for (int i = 0; i < hit.certain.added() && missed > 0.0; i++) {
            hit.certain.get(i, next);
            missed *= decisive.include(next) ? miss(next, Math.max(FEWEST, number / PART)) : 1.0;
        }
        return missed;
    }

    /** A hit of a surface, and the rays from there. */
    private final class Hit {
        private final AcousticRay ray;
        private final double distance;
        private final int triangle;
        private final double arriving;

        /** The rays whose directions are not random. */
        private final RayQueue certain = new RayQueue();

        /** Scattered rays of a look on either side of the surface. */
        private final int ahead;

        private final int behind;

        /** The number of rays that have come from the surface in a look. */
        private int made;

        private int tracedAhead;
        private int heardAhead;
        private int tracedBehind;
        private int heardBehind;

        Hit(AcousticRay ray, double distance, int triangle, double arriving) {
            this.ray = ray;
            this.distance = distance;
            this.triangle = triangle;
            this.arriving = arriving;
            distribute(branch -> ScatteredRays.Wanted.NONE, certain::add);
            distribute(branch -> ScatteredRays.Wanted.ALL, branch -> made++);
            boolean isTransmitted = made > model.reflectionsPerHit();
            this.behind = isTransmitted ? made - model.reflectionsPerHit() - 1 : 0;
            this.ahead = made - behind - certain.added();
        }

        private void distribute(ScatteredRays.Choice wanted, ReflectionGenerator.Branches target) {
            reflections.acousticDistribution(
                    ray, distance, triangle, arriving, new ReflectionGenerator.Draw(even, target, wanted));
        }

        int scattered() {
            return ahead + behind;
        }

        int traced() {
            return tracedAhead + tracedBehind;
        }

        /** Traces the scattered rays of one more look. */
        void scatter() {
            made = 0;
            int aimed = model.reflectionsPerHit() - ahead;
            distribute(branch -> ScatteredRays.Wanted.ALL, branch -> {
                if (made >= aimed && made < model.reflectionsPerHit()) {
                    tracedAhead++;
                    heardAhead += isHeardIfDecisive(branch) ? 1 : 0;
                } else if (made > model.reflectionsPerHit()) {
                    tracedBehind++;
                    heardBehind += isHeardIfDecisive(branch) ? 1 : 0;
                }
                made++;
            });
        }

        private boolean isHeardIfDecisive(AcousticRay branch) {
            return branch.level >= detectionLevel && decisive.include(branch) && isHeard(branch);
        }

        boolean isAccurate() {
            double missed = Math.pow(1.0 - (double) (heardAhead + heardBehind) / traced(), scattered());
            return missed * variance(heardAhead + heardBehind, traced(), scattered()) <= VARIANCE * (1.0 - missed);
        }

        double missed() {
            return (ahead > 0 ? LookProbability.this.missed(heardAhead, tracedAhead, ahead) : 1.0)
                    * (behind > 0 ? LookProbability.this.missed(heardBehind, tracedBehind, behind) : 1.0);
        }
    }
}
