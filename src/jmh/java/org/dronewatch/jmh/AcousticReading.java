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
import org.dronewatch.sensor.acoustic.AcousticSensor;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.acoustic.energy.EnergyModel;
import org.dronewatch.sensor.acoustic.energy.EnergyReading;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.world.SurfaceSettings;
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
 * Time of one reading by the energy model with its default settings; it fails unless its standard error is below 0.5
 * dB.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 2, time = 3)
@Measurement(iterations = 5, time = 3)
public class AcousticReading {
    private static final double ACCURACY = 0.5;

    /** Where the microphone and the drone are. */
    @Param
    public Place place;

    private World world;
    private AcousticSensor microphone;
    private Drone drone;
    private SplittableRandom random;

    /** Sites with a microphone and a drone. */
    public enum Place {
        /** On a mast on the hill, the drone 500 m away. */
        MAST(List.of("hill"), new Position(0, 0, 144), new Position(0, 500, 144)),
        /** On the ground of the hill, the drone 500 m away. */
        GROUND(List.of("hill"), new Position(0, 0, 133.5), new Position(0, 500, 144)),
        /** At the wall of the house on the hill, the drone 300 m away. */
        WALL(List.of("hill", "house"), new Position(0, 10, 134), new Position(20, 300, 150)),
        /** Behind the house on the hill, the drone 100 m away in front of it. */
        SHADOW(List.of("hill", "house"), new Position(0, -12, 134), new Position(5, 100, 140)),
        /** In the church, 10 m from the drone. */
        CHURCH(List.of("cathedral"), new Position(-5, 0, 5), new Position(5, 0, 5)),
        /** In a street between two houses of brick, the drone behind one of them: late specular reflections. */
        CANYON(List.of("canyon"), new Position(10, -3, 1.5), new Position(-60, 5, 15));

        private final List<String> models;
        private final Position microphone;
        private final Position drone;

        Place(List<String> models, Position microphone, Position drone) {
            this.models = models;
            this.microphone = microphone;
            this.drone = drone;
        }
    }

    /** Loads the site; checks that the reading is accurate. */
    @Setup
    public void load() {
        List<TriangleMesh> meshes = place.models.stream().map(this::mesh).toList();
        SurfaceSettings surfaces = SurfaceSettings.DEFAULT
                .with("grass", "grass_turf")
                .with("dry_meadow", "pasture_uncompacted")
                .with("forest_floor", "forest_floor")
                .with("rock", "limestone");
        world = new World(KDTree.of(World.merge(meshes)), BackgroundNoise.of(20.0), surfaces, Atmosphere.STANDARD);
        DroneSettings settings =
                DroneSettings.of(ModelSettings.of("quadrotor.obj"), new FlightPathSettings.Hover(place.drone, 0.0));
        drone = settings.create("drone", KDTree.of(Bench.worldMesh("quadrotor")));
        microphone = AcousticSettings.at(place.microphone)
                .withPropagation(EnergyModel.DEFAULT)
                .create();
        random = new SplittableRandom(1);
        double error = read().standardError();
        if (!(error < ACCURACY)) {
            throw new IllegalStateException("standard error " + error + " dB");
        }
    }

    private TriangleMesh mesh(String model) {
        return switch (model) {
            case "house" -> Bench.worldMesh(model, new Position(0, 0, 132));
            case "canyon" -> Bench.canyon();
            default -> Bench.worldMesh(model);
        };
    }

    /** One look. */
    @Benchmark
    public EnergyReading read() {
        return microphone.read(world, drone, random);
    }
}
