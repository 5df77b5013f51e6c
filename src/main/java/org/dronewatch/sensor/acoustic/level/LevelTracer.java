package org.dronewatch.sensor.acoustic.level;

import java.util.OptionalInt;
import java.util.random.RandomGenerator;
import org.dronewatch.geometry.IntersectionHandler;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.KDTraversal;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.Directions;
import org.dronewatch.sensor.acoustic.propagation.LevelModel;
import org.dronewatch.world.World;

/**
 * The level model: follows rays breadth first, in a fixed order, from a drone to one sensor. Rays end below the level of
 * detection, at the largest order and with the ray budget; what was cut is counted. One per thread.
 */
public final class LevelTracer {
    /** How far rays that meet nothing are drawn, m. */
    private static final double DRAWN = 1000.0;

    private final LevelModel model;
    private final Position sensor;
    private final double radius;
    private final double detectionLevel;
    private final KDTraversal traversal;
    private final ReflectionGenerator reflections;
    private final RayQueue queue = new RayQueue();
    private final AcousticRay ray = new AcousticRay();

    private double bestLevel;
    private double energy;
    private long received;
    private long traced;
    private long cutByOrder;
    private long cutByBudget;
    private int cutOrder;

    /**
     * A tracer to one sensor.
     *
     * @param sensor its centre, m
     * @param radius rays that pass within this distance are received, m
     * @param detectionLevel the level from which on a sound is detected, dB
     */
    public LevelTracer(LevelModel model, Position sensor, double radius, double detectionLevel, World world) {
        this.model = model;
        this.sensor = sensor;
        this.radius = radius;
        this.detectionLevel = detectionLevel;
        this.traversal = world.newTraversal();
        this.reflections = new ReflectionGenerator(world.mesh(), new SurfaceLevels(world), sensor);
    }

    /**
     * One look.
     *
     * @param source where the drone is
     * @param sourceLevel its level, dB
     * @param fully whether to go on after the first detection
     */
    public Listening trace(
            Position source, double sourceLevel, RandomGenerator random, boolean fully, RayRecorder recorder) {
        reset();
        emit(source, sourceLevel, random);
        while (queue.take(ray)) {
            boolean hit = traversal.closestHit(
                    ray.originX,
                    ray.originY,
                    ray.originZ,
                    ray.directionX,
                    ray.directionY,
                    ray.directionZ,
                    0.0,
                    Double.POSITIVE_INFINITY);
            traced++;
            double distance = hit ? traversal.distance() : Double.POSITIVE_INFINITY;
            if (reachesSensor(distance)) {
                receive(recorder);
                if (!fully && bestLevel >= detectionLevel) {
                    break;
                }
            } else {
                double arriving = ray.level - model.attenuation() * Math.min(distance, DRAWN);
                record(recorder, Math.min(distance, DRAWN), arriving, false);
                if (hit) {
                    reflect(distance, traversal.triangle(), random);
                }
            }
        }
        OptionalInt cutAt = cutByBudget > 0 ? OptionalInt.of(cutOrder) : OptionalInt.empty();
        return new Listening(
                bestLevel, bestLevel >= detectionLevel, energy, received, traced, cutByOrder, cutByBudget, cutAt);
    }

    private void reset() {
        queue.clear();
        bestLevel = Double.NEGATIVE_INFINITY;
        energy = 0.0;
        received = 0;
        traced = 0;
        cutByOrder = 0;
        cutByBudget = 0;
        cutOrder = Integer.MAX_VALUE;
    }

    /** The ray straight at the sensor, which is traced first, and those in random directions. */
    private void emit(Position source, double sourceLevel, RandomGenerator random) {
        ray.originX = source.x();
        ray.originY = source.y();
        ray.originZ = source.z();
        ray.level = sourceLevel;
        ray.energy = 1.0 / (model.initialRays() + 1);
        ray.travelled = 0.0;
        ray.order = 0;
        ray.medium = AcousticRay.AIR;
        Position way = sensor.minus(source);
        double length = way.length();
        ray.directionX = length > 0.0 ? way.x() / length : 1.0;
        ray.directionY = length > 0.0 ? way.y() / length : 0.0;
        ray.directionZ = length > 0.0 ? way.z() / length : 0.0;
        enqueue(ray);
        for (int i = 0; i < model.initialRays(); i++) {
            Directions.draw(random, ray);
            enqueue(ray);
        }
    }

    /** Too quiet a ray is not worth tracing: nothing that comes of it can be detected. */
    private void enqueue(AcousticRay next) {
        if (next.level < detectionLevel && next.order > 0) {
            return;
        }
        if (queue.added() < model.rayBudget()) {
            queue.add(next);
        } else {
            cutByBudget++;
            cutOrder = Math.min(cutOrder, next.order);
        }
    }

    private boolean reachesSensor(double surface) {
        double entry = IntersectionHandler.raySphere(
                ray.originX,
                ray.originY,
                ray.originZ,
                ray.directionX,
                ray.directionY,
                ray.directionZ,
                sensor.x(),
                sensor.y(),
                sensor.z(),
                radius);
        return entry < surface;
    }

    /** Heard at the way to the sensor's centre, so that the range does not grow by the radius. */
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

    private void reflect(double distance, int triangle, RandomGenerator random) {
        double arriving = ray.level - model.attenuation() * distance;
        if (arriving < detectionLevel) {
            return;
        }
        if (ray.order >= model.maxOrder()) {
            cutByOrder += model.reflectionsPerHit();
            return;
        }
        reflections.branch(ray, distance, triangle, arriving, model.reflectionsPerHit(), random, this::enqueue);
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
}
