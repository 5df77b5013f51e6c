package org.dronewatch.jmh;

import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneClass;
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
import org.dronewatch.sensor.radar.BeamPattern;
import org.dronewatch.sensor.radar.Clutter;
import org.dronewatch.sensor.radar.LinkBudget;
import org.dronewatch.sensor.radar.RadarDetection;
import org.dronewatch.sensor.radar.RadarSensor;
import org.dronewatch.sensor.radar.RadarSettings;
import org.dronewatch.sensor.radar.SurfaceReflectivity.LandCover;
import org.dronewatch.sensor.radio.ReflectingGround;
import org.dronewatch.world.Ground;
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

/**
 * Time of a look of a radar at one drone over the hill; the goals are 20 us with one pulse, 100 us with reflecting
 * ground and clutter. In all cases, radar and drone are where the ground does reflect and is in sight below the drone.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 2, time = 1)
@Measurement(iterations = 3, time = 1)
public class RadarLook {
    /** The number of pulses that are integrated. */
    @Param({"1", "10", "1000"})
    public int pulses;

    /** The fluctuation of the drone's cross-section. */
    @Param({"STEADY", "SWERLING_1", "SWERLING_3"})
    public Fluctuation fluctuation;

    /** Whether the ground reflects. */
    @Param({"false", "true"})
    public boolean ground;

    /** Whether the drone has the log-normal cross-section of its class instead of a fluctuation. */
    @Param({"false", "true"})
    public boolean ofClass;

    /** Whether the wave goes round edges instead of a fraction of the drone being visible. */
    @Param({"false", "true"})
    public boolean edges;

    /** Whether the antenna has a pattern. */
    @Param({"false", "true"})
    public boolean beam;

    /** Whether the echoes of the ground compete with that of the drone, through an antenna with a pattern. */
    @Param({"false", "true"})
    public boolean clutter;

    private World world;
    private RadarSensor radar;
    private List<Drone> drones;
    private int index;

    /** Loads the hill, and places radar and drone above its ground. */
    @Setup
    public void load() {
        world = World.of(Bench.worldMesh("hill"));
        DroneSettings drone = DroneSettings.of(ModelSettings.of("quadrotor.obj"), Hover.at(new Position(0, 0, 0)))
                .withRadar(
                        ofClass
                                ? RadarSignature.of(DroneClass.SMALL_UAV)
                                : RadarSignature.DEFAULT.withFluctuation(fluctuation));
        Drone model = new Drone("drone", drone, KDTree.of(Bench.worldMesh("quadrotor")));
        Ground heights = world.newGround();
        // Places where the ground reflects and scatters; elsewhere, a look is over before this is computed.
        for (double east = -600.0; east <= 600.0 && drones == null; east += 50.0) {
            RadarSettings settings = RadarSettings.at(
                            new Position(
                                    east, -600.0, heights.height(east, -600.0).orElseThrow() + 10.0),
                            LinkBudget.Hardware.of(4.0, 33.0, 0.02))
                    .withFieldOfView(2.0 * Math.PI, Math.PI)
                    .withDetection(new RadarDetection.Chance(1e-6, pulses))
                    .withDiffraction(edges);
            RadarSettings shaped = settings.withBeam(BeamPattern.of(Math.toRadians(3.0), Math.toRadians(10.0)));
            RadarSettings cluttered = shaped.withClutter(Clutter.of(new LandCover(LandCover.Cover.FARMLAND), 40.0));
            settings = clutter ? cluttered : beam ? shaped : settings;
            RadarSettings reflected = settings.withGroundReflection(ReflectingGround.DEFAULT);
            Position place = new Position(east, 0.0, heights.height(east, 0.0).orElseThrow() + 60.0);
            drones = List.of(model.at(new FlightState(place, new Position(0.0, -10.0, 0.0), 0.0)));
            Map<String, Double> seen = cluttered
                    .withGroundReflection(ReflectingGround.DEFAULT)
                    .create()
                    .observe(world, drones, Look.of(1L, "radar", 0, 0))
                    .get(0)
                    .figures();
            boolean isShadow = Double.isInfinite(seen.get("clutter_to_noise_db"));
            if (isShadow || seen.get("ground_reflection_db") == 0.0) {
                drones = null;
            } else {
                radar = (ground ? reflected : settings).create();
            }
        }
        if (drones == null) {
            throw new IllegalStateException("the ground reflects nowhere");
        }
    }

    /** One look. */
    @Benchmark
    public List<Observation> look() {
        index++;
        return radar.observe(world, drones, Look.of(1L, "radar", index, index));
    }
}
