package org.dronewatch.jmh;

import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.parallel.Workers;
import org.dronewatch.sensor.acoustic.AcousticSensor;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.acoustic.energy.EnergyModel;
import org.dronewatch.sensor.acoustic.energy.EnergyReading;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.world.World;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/**
 * 30,000 rays of eight bands in an empty room of 10 x 8 x 4 m, all of them traced to a millionth of their energy, as by
 * a ray tracer for room acoustics, for comparison with one.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class ShoeboxReading {
    private static final float[] CORNERS = {0, 0, 0, 10, 0, 0, 10, 8, 0, 0, 8, 0, 0, 0, 4, 10, 0, 4, 10, 8, 4, 0, 8, 4};
    private static final int[] TRIANGLES = {
        0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7
    };

    /** Fraction of what the walls reflect that they scatter. */
    @Param({"0", "0.1"})
    public double scattering;

    /** Threads of a reading: one, or as many as the machine has processors, as the program has by default. */
    @Param({"one", "all"})
    public String threads;

    private Workers workers;
    private AcousticSensor microphone;
    private World world;
    private Drone drone;
    private SplittableRandom random;

    /** Builds the room. */
    @Setup
    public void build() {
        SurfaceMaterial wall = SurfaceMaterial.uniform("wall", 0.2, scattering);
        world = new World(
                KDTree.of(TriangleMesh.of(CORNERS, TRIANGLES)),
                BackgroundNoise.of(20.0),
                List.of(wall),
                Atmosphere.STANDARD);
        drone = DroneSettings.of(
                        ModelSettings.of("quadrotor.obj"), new FlightPathSettings.Hover(new Position(2, 3, 1.5), 0.0))
                .create("drone", KDTree.of(Bench.worldMesh("quadrotor")));
        microphone = AcousticSettings.at(new Position(7, 5, 1.7))
                .withPropagation(
                        EnergyModel.DEFAULT.withRays(30_000).withAccuracy(0.0).withRoulette(1e-6))
                .create();
        random = new SplittableRandom(1);
        workers = new Workers("one".equals(threads) ? 1 : Runtime.getRuntime().availableProcessors());
    }

    /** Stops the threads. */
    @TearDown
    public void stop() {
        workers.close();
    }

    /** One look. */
    @Benchmark
    public EnergyReading read() {
        return workers.call(() -> microphone.read(world, drone, random));
    }
}
