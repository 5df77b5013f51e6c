package org.dronewatch.sensor.acoustic.energy;

import java.util.Arrays;
import java.util.List;
import java.util.random.RandomGenerator;
import java.util.stream.DoubleStream;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTraversal;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.Directions;
import org.dronewatch.sensor.acoustic.propagation.EnergyModel;
import org.dronewatch.sensor.acoustic.propagation.Normals;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.world.World;

/**
 * The energy model: rays that each carry a share of the source's power in every band. A surface absorbs its share; the
 * rest goes on as one ray, reflected like a mirror, scattered by Lambert's law or passed on through the wall, chosen by
 * chance so that the mean is right. Rays that pass a ball about the sensor are counted there; direct paths and single
 * mirror reflections are exact and not counted again.
 * One per thread.
 */
public final class EnergyTracer {
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
    private final TriangleMesh mesh;
    private final KDTraversal traversal;
    private final BandSurfaces surfaces;
    private final ExactPaths exact;
    private final ReceiverBall ball;
    private final EnergyBooks books = new EnergyBooks();
    private final double[] airLoss = new double[BANDS];
    private final AcousticRay ray = new AcousticRay();
    private final double[] energy = new double[BANDS];
    private final double[] normal = new double[3];

    private int history;
    private double emitted;

    public EnergyTracer(EnergyModel model, Position sensor, double radius, World world) {
        this.model = model;
        this.sensor = sensor;
        this.mesh = world.mesh();
        this.traversal = world.newTraversal();
        this.surfaces = new BandSurfaces(world.surfaces());
        double[] attenuations = world.atmosphere().attenuations();
        for (int band = 0; band < BANDS; band++) {
            // Energy factor exp(-m d) for a loss in dB/m.
            airLoss[band] = attenuations[band] * Math.log(10.0) / 10.0;
        }
        this.exact = new ExactPaths(world, surfaces, airLoss);
        this.ball = new ReceiverBall(sensor, radius, airLoss, world.atmosphere().speedOfSound());
    }

    /**
     * One look.
     *
     * @param source where the drone is
     * @param power sound power level in each band, dB re 1 pW; minus infinity for silence
     * @param recorder is told every piece of every ray
     */
    public EnergyReading trace(Position source, List<Double> power, RandomGenerator random, RayRecorder recorder) {
        books.clear();
        ball.clear();
        double[] watts = power.stream().mapToDouble(Levels::toRatio).toArray();
        emitted = Arrays.stream(watts).sum();
        for (int i = 0; i < model.rays(); i++) {
            for (int band = 0; band < BANDS; band++) {
                energy[band] = watts[band] / emitted / model.rays();
            }
            follow(source, random, recorder);
            ball.endRay();
        }
        double[] direct = exact.direct(source, sensor, watts);
        double[] mirrored = exact.mirrored(source, sensor, watts);
        double[] reverberant = ball.intensities();
        for (int band = 0; band < BANDS; band++) {
            reverberant[band] *= emitted;
        }
        ball.addExact(source.distance(sensor), sum(direct) / emitted);
        exact.forEachMirror((way, heard) -> ball.addExact(way, heard / emitted));
        double all = sum(direct) + sum(mirrored) + sum(reverberant);
        double error = ball.standardError() * emitted;
        return new EnergyReading(
                boxed(direct),
                boxed(mirrored),
                boxed(reverberant),
                all > 0.0 ? Levels.ofRatio(1.0 + error / all) : 0.0,
                books.audit(),
                ball.decay());
    }

    private static List<Double> boxed(double[] values) {
        return DoubleStream.of(values).boxed().toList();
    }

    private static double sum(double[] values) {
        double sum = 0.0;
        for (double value : values) {
            sum += value;
        }
        return sum;
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
        double first = sum(energy);
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
            if (history == OTHER) {
                ball.count(ray, energy, distance);
            }
            record(recorder, Math.min(distance, DRAWN));
            if (!hit) {
                books.escape(sum(energy));
                return;
            }
            fly(distance);
            if (ray.order >= model.maxOrder()) {
                books.giveUp(sum(energy));
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
                    Levels.ofRatio(sum(energy) * emitted),
                    ray.order,
                    false);
        }
    }

    private void fly(double distance) {
        double before = sum(energy);
        for (int band = 0; band < BANDS; band++) {
            energy[band] *= Math.exp(-airLoss[band] * distance);
        }
        books.leaveToAir(before - sum(energy));
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
        }
        double onward = reflected + transmitted;
        books.absorb(sum(energy) - onward);
        double chance = onward > 0.0 ? transmitted / onward : 0.0;
        boolean passes = surfaces.transmits(material) && random.nextDouble() < chance;
        for (int band = 0; band < BANDS; band++) {
            energy[band] *= passes
                    ? surfaces.transmitted(material, band) / chance
                    : surfaces.reflected(material, band) / (1.0 - chance);
        }
        books.exchange(onward, sum(energy));
        if (passes) {
            ray.medium = surfaces.isSheet(material) ? ray.medium : material;
            history = OTHER;
            standOff(-1.0);
        } else {
            reflect(material, random);
            standOff(1.0);
        }
    }

    private void reflect(int material, RandomGenerator random) {
        double before = sum(energy);
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
        books.exchange(before, sum(energy));
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
        double left = sum(energy);
        if (left >= model.roulette() * first) {
            return true;
        }
        if (left == 0.0 || random.nextDouble() >= SURVIVAL) {
            books.exchange(left, 0.0);
            return false;
        }
        for (int band = 0; band < BANDS; band++) {
            energy[band] /= SURVIVAL;
        }
        books.exchange(left, sum(energy));
        return true;
    }
}
