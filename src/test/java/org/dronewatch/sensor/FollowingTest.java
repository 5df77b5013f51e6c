package org.dronewatch.sensor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.open;

import java.util.List;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.HeatSignature;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.positioner.PositionerSettings;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.camera.PixelThreshold;
import org.dronewatch.sensor.camera.TargetTask;
import org.dronewatch.sensor.thermal.ThermalSettings;
import org.dronewatch.world.Light;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What a camera on a positioner follows: what it sees by its own rule, for the task of detection. */
class FollowingTest {
    private static final Position ORIGIN = new Position(0, 0, 0);
    private static final CameraSettings CAMERA = CameraSettings.at(ORIGIN).withPositioner(PositionerSettings.DEFAULT);
    private static final CameraSettings BY_CONTRAST = CAMERA.withDetection(TargetTask.DEFAULT);
    private static final Light NIGHT_IN_FOG = Light.DAY.withIlluminance(0.001).withVisibility(50.0);

    /** A cube of 1 m has some 190 pixels at 110 m, where a camera's positioner needs 6. */
    private static final Drone NEAR = cube(new Position(0, 110, 0));

    private static Observation look(SensorSettings<?> camera, World world, Drone drone) {
        Observation seen = camera.create()
                .observe(world, List.of(drone), Look.of(1, "camera", 1, 1.0))
                .get(0);
        assertThat(seen.isDetected())
                .as("whatever is detected is followed")
                .isIn(false, seen.sighting().isPresent());
        return seen;
    }

    private static boolean isFollowed(SensorSettings<?> camera, World world, Drone drone) {
        return look(camera, world, drone).sighting().isPresent();
    }

    @Test
    void nothingIsFollowedInFogAtNight() {
        World world = open().withLight(NIGHT_IN_FOG);

        assertThat(look(BY_CONTRAST, world, NEAR).value()).isZero();
        assertThat(isFollowed(BY_CONTRAST, world, NEAR)).isFalse();
        assertThat(isFollowed(BY_CONTRAST, open(), NEAR)).isTrue();
        assertThat(isFollowed(BY_CONTRAST.withDetection(TargetTask.DEFAULT.withChance(true)), world, NEAR))
                .isFalse();
    }

    /** A count of pixels knows no light: six of them are followed, twelve reported. */
    @Test
    void aCountOfPixelsFollowsFewerThanItReports() {
        World world = open().withLight(NIGHT_IN_FOG);
        CameraSettings counting = CAMERA.withDetection(PixelThreshold.DEFAULT);
        Observation nine = look(counting, world, cube(new Position(0, 500, 0.5)));

        assertThat(nine.value()).isBetween(6.0, 11.0);
        assertThat(nine.isDetected()).isFalse();
        assertThat(nine.sighting()).isPresent();
        assertThat(isFollowed(counting, world, cube(new Position(0, 1200, 0.5))))
                .isFalse();
    }

    /**
     * 9 pixels are an even chance of detection and none of identification: it is followed, so that the lens can zoom
     * in.
     */
    @ParameterizedTest
    @ValueSource(strings = {"RECOGNITION", "IDENTIFICATION"})
    void whatIsDetectedIsFollowedThoughItIsNotIdentified(String task) {
        TargetTask higher = TargetTask.DEFAULT.withTask(Discrimination.valueOf(task));
        Observation seen = look(CAMERA.withDetection(higher), open(), cube(new Position(0, 500, 0.5)));

        assertThat(seen.isDetected()).isFalse();
        assertThat(seen.sighting()).isPresent();
        assertThat(isFollowed(
                        CAMERA.withDetection(higher.withProbability(0.999)), open(), cube(new Position(0, 500, 0.5))))
                .as("not to its own probability")
                .isFalse();
    }

    /** An observer who has found it, though he cannot identify it yet, does not search it again in each frame. */
    @Test
    void whatAnObserverHasFoundIsFollowedFromThenOn() {
        CameraSettings camera = CAMERA.withDetection(
                TargetTask.DEFAULT.withTask(Discrimination.IDENTIFICATION).withChance(true));
        Drone drone = cube(new Position(0, 330, 0.5));
        Sensor sensor = camera.create();
        Encounters before = Encounters.NONE;
        int first = -1;
        int followed = 0;
        int looks = 600;
        for (int i = 0; i < looks; i++) {
            Look look = Look.of(4, "camera", i, i / camera.rate()).withEncounters(before);
            Observation seen = sensor.observe(open(), List.of(drone), look).get(0);
            assertThat(seen.probability()).isLessThan(0.1);
            assertThat(seen.isDetected()).isFalse();
            boolean isFollowed = seen.sighting().isPresent();
            first = first < 0 && isFollowed ? i : first;
            followed += isFollowed ? 1 : 0;
            before = Encounters.after(look, camera.rate(), List.of(seen));
        }
        assertThat(first).as("a search takes time").isBetween(2, 300);
        assertThat(followed).isEqualTo(looks - first);
    }

    private static Drone warm(double kelvins, double range) {
        DroneSettings settings = DroneSettings.of(ModelSettings.of("cube.obj"), Hover.at(ORIGIN))
                .withHeat(HeatSignature.DEFAULT.withExcess(kelvins));
        Drone cube = cube(new Position(0, range, 0));
        return new Drone("warm", settings, cube.tree()).at(new FlightState(new Position(0, range, 0), ORIGIN, 0.0));
    }

    @Test
    void aThermalCameraFollowsWhatItDetects() {
        ThermalSettings camera = ThermalSettings.at(ORIGIN).withPositioner(PositionerSettings.DEFAULT);
        ThermalSettings identifying = camera.withTask(Discrimination.IDENTIFICATION);

        // 0.11 K of noise 0.05 K: more than the least ratio of 2, but only a twentieth of its 225 pixels is resolved.
        Observation cool = look(camera, open(), warm(0.105, 100));
        assertThat(cool.figures().get("pixels")).isGreaterThan(100.0);
        assertThat(cool.figures().get("signal_to_noise")).isGreaterThan(2.0);
        assertThat(cool.value()).isLessThan(0.5);
        assertThat(cool.sighting()).isEmpty();
        assertThat(isFollowed(camera, open(), warm(5.0, 100))).isTrue();
        assertThat(look(identifying, open(), warm(5.0, 300)).isDetected()).isFalse();
        assertThat(isFollowed(identifying, open(), warm(5.0, 300))).isTrue();
        assertThat(isFollowed(identifying.withChance(true), open(), warm(5.0, 3000)))
                .isFalse();
    }
}
