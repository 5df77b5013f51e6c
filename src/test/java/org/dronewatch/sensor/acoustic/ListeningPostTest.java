package org.dronewatch.sensor.acoustic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.positioner.Direction;
import org.dronewatch.run.Frame;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.DirectionFinding;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.acoustic.array.ArraySettings;
import org.dronewatch.sensor.acoustic.array.ArraySettings.Shape;
import org.dronewatch.sensor.acoustic.energy.EnergyModel;
import org.dronewatch.sensor.acoustic.energy.EnergyModel.Criterion;
import org.dronewatch.sensor.acoustic.level.LevelModel;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.sound.DroneSound;
import org.dronewatch.sound.DroneSounds;
import org.dronewatch.sound.surface.SurfaceMaterials;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** An array of microphones hears a drone and turns a camera to it. */
class ListeningPostTest {
    private static final Path SCENE = Path.of("src/test/resources/org/dronewatch/sensor/acoustic/listening-post.yaml");
    private static final AcousticSettings MICROPHONE =
            AcousticSettings.at(new Position(0, 0, 2)).withPropagation(EnergyModel.DEFAULT);
    private static final ArraySettings ARRAY = ArraySettings.of(32, 1.0);

    private static SceneRunner scene() {
        return new SceneRunner(new SceneFile(SCENE));
    }

    /** The camera looks south at first, and the drone comes from the north-east. */
    @Test
    void theArrayTurnsTheCameraToTheDrone() {
        assertThat(scene().run().firstDetectionRange("eye", "quadrotor").orElseThrow())
                .isGreaterThan(200.0);
        assertThat(scene().set("sensors.ears.threshold", "60 dB").run().firstDetectionRange("eye", "quadrotor"))
                .isEmpty();
    }

    /**
     * The direction is that to where the drone was when the sound left it, with errors as stated, drawn anew in each
     * look.
     */
    @Test
    void directionsAreThoseOfTheSoundAsItLeft() {
        List<Frame> frames = new ArrayList<>();
        scene().set("sensors.ears.array.accuracy", "0.1 deg")
                .set("sensors.ears.rate", "5 Hz")
                .onFrame(frames::add)
                .run();
        Frame first = frames.get(0);
        Frame last = frames.get(frames.size() - 1);
        Position start = first.drones().get(0).origin();
        Position velocity = last.drones().get(0).origin().minus(start).times(1.0 / (last.time() - first.time()));
        double heard = 0.0;
        double seen = 0.0;
        int count = 0;
        for (Frame frame : frames) {
            for (Observation look : frame.observations()) {
                if (look.sensor().equals("ears") && look.isDetected()) {
                    Direction believed = look.sighting().orElseThrow().direction();
                    double error = Math.toRadians(look.figures().get("bearing_error_deg"));
                    Position here = look.sighting().orElseThrow().from();
                    heard += square(
                            offBearing(believed, start.plus(velocity.times(look.time() - first.time())), here) / error);
                    seen += square(offBearing(believed, start.plus(velocity.times(frame.time() - first.time())), here)
                            / error);
                    count++;
                }
            }
        }

        assertThat(count).isGreaterThan(120);
        assertThat(Math.sqrt(heard / count)).isBetween(0.8, 1.25);
        assertThat(seen).isGreaterThan(heard);
    }

    private static double square(double value) {
        return value * value;
    }

    private static double offBearing(Direction believed, Position drone, Position here) {
        double truth = Direction.of(drone.minus(here)).azimuth();
        return Math.IEEEremainder(believed.azimuth() - truth, 2.0 * Math.PI);
    }

    /** 32 microphones gain 15.05 dB, in place of a stated gain, and both at once are refused. */
    @Test
    void theGainIsThatOfTheArray() {
        AcousticSettings array = MICROPHONE.withArray(ARRAY);

        assertThat(array.gain()).isEqualTo(10.0 * Math.log10(32));
        assertThat(array.detectionLevel(30.0)).isEqualTo(30.0 + 15.0 - array.gain());
        assertThat(MICROPHONE.withArrayGain(12.0).gain()).isEqualTo(12.0);
        assertThat(MICROPHONE.withArrayGain(12.0).withArray(ARRAY).arrayGain()).isZero();
        assertThatThrownBy(() -> array.withArrayGain(5.0))
                .hasMessageContaining("arrayGain 5 dB and an array of 32 microphones: set one of them");
    }

    /**
     * 64 microphones of 3.4 m heard quadrotors at 300 to 700 m (Altena and others, Applied Acoustics 2026), sound
     * powers and backgrounds unknown: here at 85 and 90 dB(A), 50 m above grass, over 35 dB(A) by 6 dB.
     */
    @ParameterizedTest
    @CsvSource({"A_WEIGHTED, 85", "A_WEIGHTED, 90", "BEST_BAND, 85", "BEST_BAND, 90"})
    void rangesOfALargeArrayAreThoseOfMeasurements(Criterion criterion, double power) {
        float far = 3000;
        TriangleMesh ground = TriangleMesh.of(
                new float[] {-far, -far, 0, far, -far, 0, far, far, 0, -far, far, 0}, new int[] {0, 1, 2, 0, 2, 3});
        World site = new World(
                KDTree.of(ground),
                BackgroundNoise.of(35.0),
                List.of(SurfaceMaterials.get("grass_turf")),
                Atmosphere.STANDARD);
        AcousticSensor ears = AcousticSettings.at(new Position(0, 0, 2))
                .withThreshold(6.0)
                .withArray(ArraySettings.of(64, 3.4))
                .withPropagation(EnergyModel.DEFAULT.withCriterion(criterion))
                .create();
        DroneSettings settings = DroneSettings.of(ModelSettings.of("none.obj"), new Hover(new Position(0, 0, 50), 0.0))
                .withSound(quadrotorOf(power));
        Drone drone = new Drone("drone", settings, KDTree.of(ground));
        double near = 50;
        double lost = 2000;
        while (lost - near > 5) {
            double middle = 0.5 * (near + lost);
            Drone there = drone.at(
                    new FlightState(new Position(middle, 0, 50), new Position(0, 0, 0), 0.0, OptionalDouble.empty()));
            boolean isHeard = ears.observe(site, List.of(there), Look.of(1, "ears", 0, 10.0))
                    .get(0)
                    .isDetected();
            near = isHeard ? middle : near;
            lost = isHeard ? lost : middle;
        }

        assertThat(near).isBetween(270.0, 700.0);
    }

    private static DroneSound quadrotorOf(double power) {
        DroneSound small = DroneSounds.get(DroneSounds.SMALL_QUADROTOR);
        return new DroneSound(small.name(), power, small.shape(), small.basis(), small.source());
    }

    /**
     * A line has no directions to tell, a single microphone neither, nor has the level model bands in which to find
     * them.
     */
    @Test
    void onlyArraysThatFindDirectionsCanCue() {
        assertThat(MICROPHONE.as(DirectionFinding.class)).isEmpty();
        assertThat(MICROPHONE.withArray(ARRAY).as(DirectionFinding.class)).isPresent();
        assertThat(MICROPHONE.withArray(ARRAY.withShape(Shape.LINE)).as(DirectionFinding.class))
                .isEmpty();
        assertThat(MICROPHONE
                        .withPropagation(LevelModel.DEFAULT)
                        .withArray(ARRAY)
                        .as(DirectionFinding.class))
                .isEmpty();
    }
}
