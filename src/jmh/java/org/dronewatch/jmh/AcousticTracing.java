package org.dronewatch.jmh;

import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.AcousticSensor;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.acoustic.energy.EnergyModel;
import org.dronewatch.sensor.acoustic.level.LevelModel;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.acoustic.propagation.Directions;
import org.dronewatch.sensor.acoustic.propagation.Normals;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.world.SurfaceSettings;
import org.dronewatch.world.World;
import org.openjdk.jmh.annotations.AuxCounters;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * The number of pieces of sound rays traced per second in the church, beside the kernel's own rate for rays that bounce
 * about the same church at random; {@code -t 2} runs both on two threads, each with its own sensor.
 */
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 3)
@Measurement(iterations = 5, time = 3)
@State(Scope.Benchmark)
public class AcousticTracing {
    private static final int RAYS = 200_000;
    private static final int NUMBERS = 6;
    private static final Position MICROPHONE = new Position(-5, 0, 5);
    private static final Position DRONE = new Position(5, 0, 5);

    private World world;
    private Drone drone;
    private double[] rays;

    /** Counts pieces of rays; JMH shows their number per second. */
    @State(Scope.Thread)
    @AuxCounters(AuxCounters.Type.OPERATIONS)
    public static class Pieces {
        /** Straight pieces of rays. */
        public long pieces;
    }

    /** The state of each thread. */
    @State(Scope.Thread)
    public static class Ears {
        private SplittableRandom random;
        private AcousticSensor energies;
        private AcousticSensor levels;
        private RayTracer traversal;

        /** Sensors with separate scratch memory. */
        @Setup(Level.Trial)
        public void listen(AcousticTracing site) {
            random = new SplittableRandom(1);
            energies = AcousticSettings.at(MICROPHONE)
                    .withPropagation(EnergyModel.DEFAULT.withRays(1000))
                    .create();
            levels = AcousticSettings.at(MICROPHONE)
                    .withPropagation(LevelModel.DEFAULT.withRays(20, 20))
                    .create();
            traversal = site.world.newRayTracer();
        }
    }

    /** Loads the church and lets rays bounce about it. */
    @Setup
    public void load() {
        KDTree tree = KDTree.of(Bench.worldMesh("cathedral"));
        world = new World(tree, BackgroundNoise.of(20.0), SurfaceSettings.DEFAULT, Atmosphere.STANDARD);
        DroneSettings settings =
                DroneSettings.of(ModelSettings.of("quadrotor.obj"), new FlightPathSettings.Hover(DRONE, 0.0));
        drone = settings.create("drone", KDTree.of(Bench.worldMesh("quadrotor")));
        rays = bouncingRays();
    }

    private double[] bouncingRays() {
        double[] numbers = new double[NUMBERS * RAYS];
        SplittableRandom random = new SplittableRandom(2);
        RayTracer traversal = world.newRayTracer();
        Normals normals = new Normals(world.mesh());
        double[] normal = new double[3];
        AcousticRay ray = new AcousticRay();
        for (int i = 0; i < RAYS; i++) {
            if (i % 100 == 0) {
                ray.originX = MICROPHONE.x();
                ray.originY = MICROPHONE.y();
                ray.originZ = MICROPHONE.z();
                Directions.draw(random, ray);
            }
            int at = NUMBERS * i;
            numbers[at] = ray.originX;
            numbers[at + 1] = ray.originY;
            numbers[at + 2] = ray.originZ;
            numbers[at + 3] = ray.directionX;
            numbers[at + 4] = ray.directionY;
            numbers[at + 5] = ray.directionZ;
            if (!closestHit(traversal, numbers, at)) {
                throw new IllegalStateException("the church has a hole");
            }
            normals.facing(traversal.triangle(), ray, normal);
            double stop = traversal.distance() - 1e-6;
            ray.originX += stop * ray.directionX;
            ray.originY += stop * ray.directionY;
            ray.originZ += stop * ray.directionZ;
            Directions.drawLambert(random, normal, ray);
        }
        return numbers;
    }

    private static boolean closestHit(RayTracer traversal, double[] r, int i) {
        return traversal.closestHit(
                r[i], r[i + 1], r[i + 2], r[i + 3], r[i + 4], r[i + 5], 0.0, Double.POSITIVE_INFINITY);
    }

    /** The kernel alone. */
    @Benchmark
    public double kernel(Ears ears, Pieces pieces) {
        double sum = 0.0;
        for (int i = 0; i < rays.length; i += NUMBERS) {
            closestHit(ears.traversal, rays, i);
            sum += ears.traversal.distance();
        }
        pieces.pieces += RAYS;
        return sum;
    }

    /** A look by the energy model. */
    @Benchmark
    public double energyModel(Ears ears, Pieces pieces) {
        double traced = ears.energies.read(world, drone, ears.random).traced();
        pieces.pieces += (long) traced;
        return traced;
    }

    /** A look by the level model, everything traced. */
    @Benchmark
    public double levelModel(Ears ears, Pieces pieces) {
        long traced = ears.levels
                .listenFully(world, drone, ears.random, RayRecorder.NONE)
                .traced();
        pieces.pieces += traced;
        return traced;
    }
}
