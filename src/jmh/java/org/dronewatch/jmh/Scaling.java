package org.dronewatch.jmh;

import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.parallel.Workers;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.AcousticSensor;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.acoustic.energy.EnergyModel;
import org.dronewatch.sensor.acoustic.energy.EnergyReading;
import org.dronewatch.sensor.acoustic.level.LevelModel;
import org.dronewatch.sensor.acoustic.level.LevelReading;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.optics.DepthImage;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.world.SurfaceSettings;
import org.dronewatch.world.World;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/** The speed of one sensor's work in the church on several threads. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 3)
@Measurement(iterations = 5, time = 3)
public class Scaling {
    private static final Position SENSOR = new Position(-5, 0, 5);
    private static final Position DRONE = new Position(5, 0, 5);

    /** The number of threads that work. */
    @Param({"1", "2"})
    public int threads;

    private Workers workers;
    private TriangleMesh mesh;
    private World world;
    private Drone drone;
    private AcousticSensor energies;
    private AcousticSensor levels;
    private SplittableRandom random;

    /** Loads the church. */
    @Setup(Level.Trial)
    public void load() {
        workers = new Workers(threads);
        mesh = Bench.worldMesh("cathedral");
        KDTree tree = workers.call(() -> KDTree.of(mesh));
        world = new World(tree, BackgroundNoise.of(20.0), SurfaceSettings.DEFAULT, Atmosphere.STANDARD);
        DroneSettings settings =
                DroneSettings.of(ModelSettings.of("quadrotor.obj"), new FlightPathSettings.Hover(DRONE, 0.0));
        drone = settings.create("drone", KDTree.of(Bench.worldMesh("quadrotor")));
        energies =
                AcousticSettings.at(SENSOR).withPropagation(EnergyModel.DEFAULT).create();
        levels = AcousticSettings.at(SENSOR)
                .withPropagation(LevelModel.DEFAULT.withRays(20, 20))
                .create();
        random = new SplittableRandom(1);
    }

    /** Stops the threads. */
    @TearDown
    public void close() {
        workers.close();
    }

    private <T> T call(Callable<T> work) {
        return workers.call(work);
    }

    /** The tree of the church. */
    @Benchmark
    public KDTree treeBuild() {
        return call(() -> KDTree.of(mesh));
    }

    /** The whole static view of a full HD camera. */
    @Benchmark
    public DepthImage staticView() {
        return call(() -> CameraSettings.at(SENSOR)
                .withResolution(1920, 1080)
                .withLookAt(DRONE)
                .create()
                .depthImage(world, List.of()));
    }

    /** A look by the energy model. */
    @Benchmark
    public EnergyReading energyModel() {
        return call(() -> energies.read(world, drone, random));
    }

    /** A look by the level model, everything traced. */
    @Benchmark
    public LevelReading levelModel() {
        return call(() -> levels.listenFully(world, drone, random, RayRecorder.NONE));
    }
}
