package org.dronewatch.jmh;

import java.util.List;
import java.util.concurrent.TimeUnit;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.RadarSignature;
import org.dronewatch.drone.RadarSignature.Fluctuation;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.radar.LinkBudget;
import org.dronewatch.sensor.radar.RadarDetection;
import org.dronewatch.sensor.radar.RadarSensor;
import org.dronewatch.sensor.radar.RadarSettings;
import org.dronewatch.sensor.radio.ReflectingGround;
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

/** Time of a look of a radar at one drone over the hill; the goals are 20 us with one pulse, 100 us with
 * reflecting ground. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 2, time = 1)
@Measurement(iterations = 3, time = 1)
public class RadarLook {
    /** How many pulses are integrated. */
    @Param({"1", "10", "1000"})
    public int pulses;

    /** How the drone's cross-section changes. */
    @Param({"STEADY", "SWERLING_1", "SWERLING_3"})
    public Fluctuation fluctuation;

    /** Whether the ground reflects. */
    @Param({"false", "true"})
    public boolean ground;

    private World world;
    private RadarSensor radar;
    private List<Drone> drones;
    private int index;

    /** Loads the hill, and places radar and drone above it. */
    @Setup
    public void load() {
        world = World.of(Bench.mesh("hill"));
        double top = world.bounds().maxZ();
        RadarSettings settings = RadarSettings.at(
                        new Position(0.0, 0.0, top + 10.0), LinkBudget.Hardware.of(4.0, 33.0, 0.02))
                .withDetection(new RadarDetection.Chance(1e-6, pulses));
        radar = (ground ? settings.withGroundReflection(ReflectingGround.DEFAULT) : settings).create();
        DroneSettings drone = DroneSettings.of(ModelSettings.of("quadrotor.obj"), Hover.at(new Position(0, 0, 0)))
                .withRadar(RadarSignature.DEFAULT.withFluctuation(fluctuation));
        drones = List.of(new Drone("drone", drone, KDTree.of(Bench.mesh("quadrotor")))
                .at(new FlightState(new Position(0.0, 800.0, top + 30.0), new Position(0.0, -10.0, 0.0), 0.0)));
    }

    /** One look. */
    @Benchmark
    public List<Observation> look() {
        index++;
        return radar.observe(world, drones, Look.of(1L, "radar", index, index));
    }
}
