package org.dronewatch.sensor.acoustic.level;

import java.util.random.RandomGenerator;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.world.World;

/**
 * Traces a chunk of the queued rays: finds their contributions at the sensor, and the rays that leave the surfaces that
 * they hit. For use by one thread.
 */
final class RayChunk {
    /** The length at which rays that hit nothing are drawn, m. */
    private static final double DRAWN = 1000.0;

    private final LevelModel model;
    private final Position sensor;
    private final double radius;
    private final double detectionLevel;
    private final RayTracer traversal;
    private final ReflectionGenerator reflections;
    private final DecisiveRays decisive;
    private final RayQueue branches = new RayQueue();
    private final AcousticRay ray = new AcousticRay();

    private TracedRays extent = TracedRays.ALL;
    private double bestLevel;
    private double energy;
    private long received;
    private long traced;
    private long cutByOrder;
    private long mostOfLastOrder;

    RayChunk(
            LevelModel model,
            Position sensor,
            double radius,
            double detectionLevel,
            World world,
            SurfaceLevels surfaces) {
        this.model = model;
        this.sensor = sensor;
        this.radius = radius;
        this.detectionLevel = detectionLevel;
        this.traversal = world.newRayTracer();
        this.decisive = new DecisiveRays(model, sensor, radius, detectionLevel, surfaces);
        this.reflections = new ReflectionGenerator(model, world, surfaces, sensor, decisive.radius());
    }

    /**
     * Traces rays of a queue; discards the results of the previous ones.
     *
     * @param from index of the first ray
     * @param to index of the first ray that is not traced
     * @param wanted which rays are traced
     */
    void trace(RayQueue queue, int from, int to, RandomGenerator random, TracedRays wanted, RayRecorder recorder) {
        extent = wanted;
        branches.clear();
        bestLevel = Double.NEGATIVE_INFINITY;
        energy = 0.0;
        received = 0;
        traced = 0;
        cutByOrder = 0;
        mostOfLastOrder = 0;
        ReflectionGenerator.Draw draw = new ReflectionGenerator.Draw(random, this::keep, this::wanted);
        for (int i = from; i < to; i++) {
            queue.get(i, ray);
            if (isOfUseOnlyAtSensor()) {
                traced++;
                if (isFreeToSensor()) {
                    receive(recorder);
                    if (bestLevel >= detectionLevel) {
                        return;
                    }
                }
                continue;
            }
            double audible = isQuick() ? audible() : Double.POSITIVE_INFINITY;
            boolean hit = ray.meets(traversal, audible);
            traced++;
            double distance = hit ? traversal.distance() : audible;
            if (reachesSensor(distance)) {
                receive(recorder);
                if (extent != TracedRays.ALL && bestLevel >= detectionLevel) {
                    return;
                }
            } else {
                double arriving = ray.level - model.attenuation() * Math.min(distance, DRAWN);
                record(recorder, Math.min(distance, DRAWN), arriving, false);
                if (hit) {
                    reflect(distance, traversal.triangle(), draw);
                }
            }
        }
    }

    /** Whether the ray comes from a surface, ends at the next surface, and needs no figures. */
    private boolean isOfUseOnlyAtSensor() {
        return isQuick() && ray.order > 0 && ray.order == model.maxOrder();
    }

    private boolean isQuick() {
        return extent == TracedRays.DECISIVE || extent == TracedRays.DECISIVE_OF_LOOK;
    }

    /** The distance up to which the ray is loud enough, m: anything that it meets farther away does not matter. */
    private double audible() {
        return model.attenuation() > 0.0
                ? Math.max(0.0, ray.level - detectionLevel + DecisiveRays.ROUNDING) / model.attenuation()
                : Double.POSITIVE_INFINITY;
    }

    private boolean isFreeToSensor() {
        double entry = ray.entry(sensor, radius);
        return entry < Double.POSITIVE_INFINITY && !ray.meets(traversal, entry);
    }

    private boolean reachesSensor(double surface) {
        return ray.entry(sensor, radius) < surface;
    }

    /**
     * Receives the ray, with its level at the distance of the sensor's centre, so that the range does not increase by
     * the radius.
     */
    private void receive(RayRecorder recorder) {
        double x = sensor.x() - ray.originX;
        double y = sensor.y() - ray.originY;
        double z = sensor.z() - ray.originZ;
        double toCentre = Math.sqrt(x * x + y * y + z * z);
        double level = ray.level - model.attenuation() * toCentre;
        bestLevel = Math.max(bestLevel, level);
        energy += ray.energy * Math.pow(10.0, -0.1 * model.attenuation() * (ray.travelled + toCentre));
        received++;
        record(recorder, toCentre, level, true);
    }

    private void reflect(double distance, int triangle, ReflectionGenerator.Draw draw) {
        double arriving = ray.level - model.attenuation() * distance;
        if (arriving < detectionLevel) {
            return;
        }
        if (ray.order >= model.maxOrder()) {
            cutByOrder += model.reflectionsPerHit();
            return;
        }
        if (ray.order + 1 == model.maxOrder()) {
            mostOfLastOrder += model.reflectionsPerHit() + model.transmittedRays();
        }
        reflections.acousticDistribution(ray, distance, triangle, arriving, draw);
    }

    /** Queues a branch, unless it is too quiet: then nothing that descends from it can be detected. */
    private void keep(AcousticRay branch) {
        if (branch.level >= detectionLevel && (!areOnlyDecisiveWanted(branch) || decisive.include(branch))) {
            branches.add(branch);
        }
    }

    /** Which scattered rays would be kept. */
    private ScatteredRays.Wanted wanted(AcousticRay branch) {
        if (branch.level < detectionLevel) {
            return ScatteredRays.Wanted.NONE;
        }
        return areOnlyDecisiveWanted(branch) ? decisive.of(branch) : ScatteredRays.Wanted.ALL;
    }

    /**
     * Whether only decisive rays are wanted: of the decisive rays of a given look, those before the last order are
     * needed for their random numbers.
     */
    private boolean areOnlyDecisiveWanted(AcousticRay branch) {
        return extent == TracedRays.DECISIVE
                || extent == TracedRays.DECISIVE_OF_LOOK && branch.order == model.maxOrder();
    }

    private void record(RayRecorder recorder, double length, double level, boolean atSensor) {
        recorder.record(
                ray.originX,
                ray.originY,
                ray.originZ,
                ray.originX + length * ray.directionX,
                ray.originY + length * ray.directionY,
                ray.originZ + length * ray.directionZ,
                level,
                ray.order,
                atSensor);
    }

    /** The best level that reached the sensor, dB; minus infinity for none. */
    double bestLevel() {
        return bestLevel;
    }

    /** Fraction of the emitted energy that reached the sensor. */
    double energy() {
        return energy;
    }

    /** The number of rays that reached the sensor. */
    long received() {
        return received;
    }

    /** The number of rays that were traced. */
    long traced() {
        return traced;
    }

    /** The number of rays that were not created because of the maximum order. */
    long cutByOrder() {
        return cutByOrder;
    }

    /** An upper bound on the number of rays of the last order that left the surfaces, kept or not. */
    long mostOfLastOrder() {
        return mostOfLastOrder;
    }

    /** The rays that leave the surfaces, in the order of the rays that hit these. */
    RayQueue branches() {
        return branches;
    }
}
