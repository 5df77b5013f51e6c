package org.dronewatch.jmh;

import java.util.List;
import java.util.concurrent.TimeUnit;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.camera.CameraSensor;
import org.dronewatch.sensor.camera.CameraSettings;
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
import org.openjdk.jmh.annotations.Warmup;

/** Time of one frame of a full HD camera on the hill that looks at a drone on its way. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 2, time = 2)
@Measurement(iterations = 3, time = 2)
public class CameraFrame {
    private static final int FRAMES = 100;
    private static final double FRAMES_PER_SECOND = 10.0;

    /** The distance of the drone from the camera when it passes, m. */
    @Param({"10", "50"})
    public double distance;

    private World world;
    private CameraSensor camera;
    private CameraSensor otherWay;
    private Drone drone;
    private FlightPath flight;
    private long frame;

    /** Puts a camera on the hill and a drone in front of it. */
    @Setup
    public void load() {
        world = World.of(Bench.worldMesh("hill"));
        double x = world.bounds().center().x;
        double y = world.bounds().center().y;
        double z = world.surfaceHeight(x, y).orElseThrow() + 2.0;
        Position eye = new Position(x, y, z);
        Position middle = new Position(x, y + distance, z + 1.0);
        camera = CameraSettings.at(eye).withLookAt(middle).create();
        otherWay = CameraSettings.at(eye)
                .withLookAt(eye.minus(new Position(0, distance, 0)))
                .create();

        FlightPathSettings path = new FlightPathSettings.Approach(
                middle.plus(new Position(-2.0, 0, 0)), middle.plus(new Position(2.0, 0, 0)));
        DroneSettings settings =
                DroneSettings.of(ModelSettings.of("quadrotor.obj"), path).withSpeed(0.4);
        drone = settings.create("drone", KDTree.of(Bench.worldMesh("quadrotor")));
        flight = settings.createFlight(world.newGround());
    }

    /** The next frame of the flight, which starts again when it is over. */
    @Benchmark
    public List<Observation> observe() {
        return look(camera);
    }

    /** The same frame by a camera that looks the other way. */
    @Benchmark
    public List<Observation> lookTheOtherWay() {
        return look(otherWay);
    }

    /** The part of the frame's time that needs no camera: the drone's place and pose. */
    @Benchmark
    public Drone drone() {
        return drone.at(flight.at(frame++ % FRAMES / FRAMES_PER_SECOND));
    }

    private List<Observation> look(CameraSensor by) {
        long index = frame++ % FRAMES;
        double time = index / FRAMES_PER_SECOND;
        return by.observe(world, List.of(drone.at(flight.at(time))), Look.of(1, "camera", index, time));
    }
}
