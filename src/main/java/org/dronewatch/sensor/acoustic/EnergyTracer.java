package org.dronewatch.sensor.acoustic;

import java.util.Arrays;
import java.util.List;
import java.util.random.RandomGenerator;
import java.util.stream.DoubleStream;
import org.dronewatch.geometry.IntersectionHandler;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTraversal;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.World;

/**
 * The energy model: rays that each carry a share of the source's power in every band. A surface absorbs its share; the
 * rest goes on as one ray, reflected like a mirror, scattered by Lambert's law or passed on through the wall, chosen by
 * chance so that the mean is right. What a ray brings to the sensor is its energy times the length of its chord through
 * the sensor's ball over the ball's volume. Direct paths and single mirror reflections are exact and not counted again.
 * One per thread.
 */
final class EnergyTracer {
    private static final int BANDS = OctaveBands.COUNT;
    private static final double STAND_OFF = 1e-9;
    private static final double SURVIVAL = 0.5;

    /** How far rays that meet nothing are drawn, m. */
    private static final double DRAWN = 1000.0;

    /** Rays with this history are the mirror reflections that are counted exactly. */
    private static final int DIRECT = 0;

    private static final int MIRRORED_ONCE = 1;
    private static final int OTHER = 2;

    private final EnergyModel model;
    private final Position sensor;
    private final double radius;
    private final double ballVolume;
    private final TriangleMesh mesh;
    private final KDTraversal traversal;
    private final BandSurfaces surfaces;
    private final ExactPaths exact;
    private final double[] airLoss = new double[BANDS];
    private final double soundSpeed;
    private final AcousticRay ray = new AcousticRay();
    private final double[] energy = new double[BANDS];
    private final double[] received = new double[BANDS];
    private final double[] normal = new double[3];
    private final DecayCurve decay = new DecayCurve();

    private int history;
    private double emitted;
    private double rayScore;
    private double gained;
    private double absorbed;
    private double air;
    private double escaped;
    private double lost;
    private double residual;

    EnergyTracer(EnergyModel model, Position sensor, double radius, World world) {
        this.model = model;
        this.sensor = sensor;
        this.radius = radius;
        this.ballVolume = 4.0 / 3.0 * Math.PI * radius * radius * radius;
        this.mesh = world.mesh();
        this.traversal = world.newTraversal();
        this.surfaces = new BandSurfaces(world.surfaces());
        double[] attenuations = world.atmosphere().attenuations();
        for (int band = 0; band < BANDS; band++) {
            // Energy factor exp(-m d) for a loss in dB/m.
            airLoss[band] = attenuations[band] * Math.log(10.0) / 10.0;
        }
        this.soundSpeed = world.atmosphere().speedOfSound();
        this.exact = new ExactPaths(world, surfaces, airLoss);
    }

    /**
     * One look.
     *
     * @param source where the drone is
     * @param power sound power level in each band, dB re 1 pW; minus infinity for silence
     * @param recorder is told every piece of every ray
     */
    EnergyReading trace(Position source, List<Double> power, RandomGenerator random, RayRecorder recorder) {
        reset();
        double[] watts = power.stream().mapToDouble(Levels::toRatio).toArray();
        double total = Arrays.stream(watts).sum();
        emitted = total;
        double[] direct = exact.direct(source, sensor, watts);
        double[] mirrored = exact.mirrored(source, sensor, watts);
        double sum = 0.0;
        double squares = 0.0;
        for (int i = 0; i < model.rays(); i++) {
            for (int band = 0; band < BANDS; band++) {
                energy[band] = watts[band] / total / model.rays();
            }
            follow(source, random, recorder);
            sum += rayScore;
            squares += rayScore * rayScore;
        }
        double[] reverberant = new double[BANDS];
        for (int band = 0; band < BANDS; band++) {
            reverberant[band] = received[band] * total / ballVolume;
        }
        addExactToDecay(source, direct, mirrored, total);
        double all = Arrays.stream(direct).sum()
                + Arrays.stream(mirrored).sum()
                + Arrays.stream(reverberant).sum();
        double variance = Math.max(0.0, squares - sum * sum / model.rays());
        double error = Math.sqrt(variance) * total / ballVolume;
        return new EnergyReading(
                boxed(direct),
                boxed(mirrored),
                boxed(reverberant),
                all > 0.0 ? Levels.ofRatio(1.0 + error / all) : 0.0,
                new EnergyAudit(1.0, gained, absorbed, air, escaped, lost, residual),
                decay.copy());
    }

    private static List<Double> boxed(double[] values) {
        return DoubleStream.of(values).boxed().toList();
    }

    private void reset() {
        Arrays.fill(received, 0.0);
        decay.clear();
        gained = 0.0;
        absorbed = 0.0;
        air = 0.0;
        escaped = 0.0;
        lost = 0.0;
        residual = 0.0;
    }

    /** In the units of what the rays bring: energy over the ball's volume. */
    private void addExactToDecay(Position source, double[] direct, double[] mirrored, double total) {
        double scale = ballVolume / total;
        decay.add(
                source.distance(sensor) / soundSpeed,
                scale * Arrays.stream(direct).sum());
        exact.forEachMirror((way, heard) -> decay.add(way / soundSpeed, scale * heard));
    }

    /** Follows one ray to its end. */
    private void follow(Position source, RandomGenerator random, RayRecorder recorder) {
        ray.originX = source.x();
        ray.originY = source.y();
        ray.originZ = source.z();
        Directions.draw(random, ray);
        ray.travelled = 0.0;
        ray.order = 0;
        ray.medium = AcousticRay.AIR;
        history = DIRECT;
        rayScore = 0.0;
        double first = sum();
        while (true) {
            boolean hit = traversal.closestHit(
                    ray.originX,
                    ray.originY,
                    ray.originZ,
                    ray.directionX,
                    ray.directionY,
                    ray.directionZ,
                    0.0,
                    Double.POSITIVE_INFINITY);
            double distance = hit ? traversal.distance() : Double.POSITIVE_INFINITY;
            score(distance);
            record(recorder, Math.min(distance, DRAWN));
            if (!hit) {
                escaped += sum();
                return;
            }
            fly(distance);
            if (ray.order >= model.maxOrder()) {
                residual += sum();
                return;
            }
            meet(traversal.triangle(), distance, random);
            if (!survives(first, random)) {
                return;
            }
        }
    }

    /** The level of a piece is that of the share of the source's power which it carries. */
    private void record(RayRecorder recorder, double length) {
        if (recorder != RayRecorder.NONE) {
            recorder.record(
                    ray.originX,
                    ray.originY,
                    ray.originZ,
                    ray.originX + length * ray.directionX,
                    ray.originY + length * ray.directionY,
                    ray.originZ + length * ray.directionZ,
                    Levels.ofRatio(sum() * emitted),
                    ray.order,
                    false);
        }
    }

    private double sum() {
        double sum = 0.0;
        for (double share : energy) {
            sum += share;
        }
        return sum;
    }

    /** What the ray brings to the sensor on this piece of its way. */
    private void score(double end) {
        if (history != OTHER) {
            return;
        }
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
        if (entry >= end) {
            return;
        }
        double x = sensor.x() - ray.originX;
        double y = sensor.y() - ray.originY;
        double z = sensor.z() - ray.originZ;
        double middle = x * ray.directionX + y * ray.directionY + z * ray.directionZ;
        double besideSquared = Math.max(0.0, x * x + y * y + z * z - middle * middle);
        double exit = Math.min(end, middle + Math.sqrt(Math.max(0.0, radius * radius - besideSquared)));
        double chord = exit - entry;
        double at = 0.5 * (entry + exit);
        double score = 0.0;
        for (int band = 0; band < BANDS; band++) {
            double brought = energy[band] * Math.exp(-airLoss[band] * at) * chord;
            received[band] += brought;
            score += brought;
        }
        rayScore += score;
        decay.add((ray.travelled + at) / soundSpeed, score);
    }

    private void fly(double distance) {
        for (int band = 0; band < BANDS; band++) {
            double left = energy[band] * Math.exp(-airLoss[band] * distance);
            air += energy[band] - left;
            energy[band] = left;
        }
        ray.travelled += distance;
    }

    private void meet(int triangle, double distance, RandomGenerator random) {
        int material = mesh.material(triangle);
        Normals.facing(mesh, triangle, ray, normal);
        ray.originX += distance * ray.directionX;
        ray.originY += distance * ray.directionY;
        ray.originZ += distance * ray.directionZ;
        ray.order++;
        if (ray.medium == material) {
            // Out of a solid: its loss was taken on the way in.
            ray.medium = AcousticRay.AIR;
            history = OTHER;
            standOff(-1.0);
            return;
        }
        double reflected = 0.0;
        double transmitted = 0.0;
        for (int band = 0; band < BANDS; band++) {
            double r = energy[band] * surfaces.reflected(material, band);
            double t = energy[band] * surfaces.transmitted(material, band);
            reflected += r;
            transmitted += t;
            absorbed += energy[band] - r - t;
        }
        double onward = reflected + transmitted;
        double chance = onward > 0.0 ? transmitted / onward : 0.0;
        boolean passes = surfaces.transmits(material) && random.nextDouble() < chance;
        for (int band = 0; band < BANDS; band++) {
            energy[band] *= passes
                    ? surfaces.transmitted(material, band) / chance
                    : surfaces.reflected(material, band) / (1.0 - chance);
        }
        settle(onward);
        if (passes) {
            ray.medium = surfaces.isSheet(material) ? ray.medium : material;
            history = OTHER;
            standOff(-1.0);
        } else {
            reflect(material, random);
            standOff(1.0);
        }
    }

    /** Books what a choice among branches has added to or taken from the energy that went on. */
    private void settle(double before) {
        double after = sum();
        gained += Math.max(0.0, after - before);
        lost += Math.max(0.0, before - after);
    }

    private void reflect(int material, RandomGenerator random) {
        double before = sum();
        double scattered = 0.0;
        for (int band = 0; band < BANDS; band++) {
            scattered += energy[band] * surfaces.scattered(material, band);
        }
        double chance = before > 0.0 ? scattered / before : 0.0;
        boolean diffuse = random.nextDouble() < chance;
        for (int band = 0; band < BANDS; band++) {
            double share = surfaces.scattered(material, band);
            energy[band] *= diffuse ? share / chance : (1.0 - share) / (1.0 - chance);
        }
        settle(before);
        if (diffuse) {
            Directions.drawLambert(random, normal, ray);
            history = OTHER;
        } else {
            double twice = 2.0 * (ray.directionX * normal[0] + ray.directionY * normal[1] + ray.directionZ * normal[2]);
            ray.directionX -= twice * normal[0];
            ray.directionY -= twice * normal[1];
            ray.directionZ -= twice * normal[2];
            history = history == DIRECT ? MIRRORED_ONCE : OTHER;
        }
    }

    private void standOff(double side) {
        double far = 1.0 + Math.abs(ray.originX) + Math.abs(ray.originY) + Math.abs(ray.originZ);
        double step = side * STAND_OFF * far;
        ray.originX += step * normal[0];
        ray.originY += step * normal[1];
        ray.originZ += step * normal[2];
    }

    /** Ends faint rays by chance and strengthens those that survive, which leaves the mean as it is. */
    private boolean survives(double first, RandomGenerator random) {
        double left = sum();
        if (left >= model.roulette() * first) {
            return true;
        }
        if (left == 0.0 || random.nextDouble() >= SURVIVAL) {
            lost += left;
            return false;
        }
        for (int band = 0; band < BANDS; band++) {
            energy[band] /= SURVIVAL;
        }
        gained += sum() - left;
        return true;
    }
}
