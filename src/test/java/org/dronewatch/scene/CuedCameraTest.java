package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.dronewatch.Thorough;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.run.AlertResult;
import org.dronewatch.run.PairResult;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A radar points a camera: what the same camera on a fixed mount sees, but cannot identify, is identified. */
class CuedCameraTest {
    private static final Path SCENE = Path.of("scenes/cued-camera.yaml");

    @TempDir
    private Path directory;

    private static SceneRunner runner() {
        return new SceneRunner(new SceneFile(SCENE)).threads(2);
    }

    @Test
    void theCameraThatARadarPointsIdentifiesWhatTheFixedOneMisses() {
        SceneResult result = runner().run();

        assertThat(result.firstDetectionRange("fixed", "intruder")).isEmpty();
        assertThat(result.firstDetectionRange("cued", "intruder").orElseThrow()).isBetween(700.0, 750.0);
        assertThat(result.firstDetectionRange("radar", "intruder").orElseThrow())
                .isGreaterThan(760.0);
    }

    @Test
    void slewingTakesItsTime() {
        double fast = seconds(runner());
        // 160 degrees at 60 degrees a second after half a second of delay.
        assertThat(fast).isBetween(0.5 + 160.0 / 60.0, 0.5 + 160.0 / 60.0 + 1.0);
        // A mount of a sixth of the speed needs 16 s and has not yet turned half way when the fast one is there.
        double slow = seconds(runner().set("sensors.cued.positioner.panSpeed", "10 deg/s"));
        assertThat(slow).isBetween(15.0, 18.0);
    }

    private static double seconds(SceneRunner runner) {
        return runner.run().pairs().stream()
                .filter(pair -> pair.sensor().equals("cued"))
                .map(PairResult::firstDetected)
                .filter(OptionalDouble::isPresent)
                .mapToDouble(OptionalDouble::getAsDouble)
                .findFirst()
                .orElseThrow();
    }

    /**
     * 0.001 lx and 50 m of visibility: the radar points it, but it sees nothing that it could zoom in on and follow.
     */
    @Test
    void inFogAtNightItPointsThereButDoesNotFollow() {
        List<Pointing> pointings = new ArrayList<>();
        SceneResult result = runner().set("world.light.illuminance", "0.001")
                .set("world.light.visibility", "50 m")
                .onFrame(frame -> pointings.addAll(frame.pointings().values()))
                .run();

        assertThat(result.firstDetectionRange("cued", "intruder")).isEmpty();
        assertThat(pointings).anyMatch(one -> one.contact().isPresent() && one.fov() < Math.toRadians(8.001));
        assertThat(pointings).allMatch(one -> one.fov() >= Math.toRadians(7.999));
    }

    @Test
    void withoutTheRadarItSeesNothing() {
        SceneResult blind = runner().set("sensors.radar.minRange", "7 km").run();

        assertThat(blind.firstDetectionRange("cued", "intruder")).isEmpty();
    }

    @Thorough
    @Test
    void itPointsWhereTheDroneIsForAnyNumberOfThreads() {
        List<Pointing> one = new ArrayList<>();
        List<Pointing> two = new ArrayList<>();
        runner().threads(1)
                .onFrame(frame -> one.addAll(frame.pointings().values()))
                .run();
        runner().onFrame(frame -> two.addAll(frame.pointings().values())).run();

        assertThat(one).hasSizeGreaterThan(1000).isEqualTo(two);
        assertThat(one.get(one.size() - 1).contact()).hasValue(1);
        assertThat(one.get(one.size() - 1).fov()).isLessThan(Math.toRadians(2.3));
    }

    @Test
    void aDecoyKeepsTheCameraFromTheIntruder() throws IOException {
        String decoy =
                """
                drones:
                  decoy:
                    model: packaged:quadrotor.obj
                    flight: {kind: orbit, centre: [-60, 500, 170], radius: 150}
                    speed: 12 m/s
                    label: {role: decoy}
                """;
        Path file = directory.resolve("decoyed.yaml");
        Files.writeString(file, Files.readString(SCENE).replaceFirst("drones:\n", decoy));
        SceneResult result = new SceneRunner(new SceneFile(file)).threads(2).run();

        assertThat(result.firstDetectionRange("cued", "decoy")).isPresent();
        assertThat(result.firstDetectionRange("cued", "intruder")).isEmpty();
        // The rule wants two sensors: the radar alone is not enough.
        assertThat(result.alert("intruder").time()).isEmpty();
    }

    @Test
    void anotherCameraTakesItsPlaceOnTheMount() {
        SceneResult result = runner().set("sensors.cued", "cooled-thermal-camera")
                .set("sensors.cued.task", "recognition")
                .set("sensors.cued.positioner.zoom.tracked", "1.8 deg")
                .run();

        assertThat(result.firstDetectionRange("cued", "intruder")).isPresent();
    }

    @Test
    void aPlaceAboveTheMountIsNotInSight() {
        AlertResult below = runner().set("sensors.cued.positioner.maxTilt", "-20 deg")
                .set("sensors.radar.minRange", "7 km")
                .set("sensors.fixed.aim.azimuth", "200 deg")
                .run()
                .alert("intruder");

        assertThat(below.firstSight()).isEmpty();
    }

    @Test
    void pricesCanBeSetAndAdded() {
        SceneSettings settings = runner().set("prices.sensors.cued", "5")
                .set("prices.sensors.radar", "350000")
                .settings();

        assertThat(settings.prices().sensors())
                .containsEntry("cued", 5.0)
                .containsEntry("radar", 350_000.0)
                .containsEntry("fixed", 9000.0);
        assertThatThrownBy(() -> runner().set("prices.sensors.cued", "-5").settings())
                .hasMessageContaining("sensors.cued -5.0 must be 0 to 1e12");
        assertThatThrownBy(() -> runner().set("prices.sensors.cued", "much").settings())
                .hasMessageContaining("prices.sensors.cued=much: 'much' is not a number");
    }

    @Test
    void whatLooksOddAboutAMountIsTold() {
        List<String> notes = new ArrayList<>();
        runner().set("sensors.cued.positioner.hold", "0.4 s")
                .set("sensors.cued.aim.elevation", "-70 deg")
                .set("run.duration", "0.1")
                .notes(notes::add)
                .run();

        assertThat(notes)
                .contains(
                        "warning: sensors.cued.positioner.hold 0.40 s is less than the 5.0 s between looks of 'radar',"
                                + " which cues this positioner: it stops following the drone between cues",
                        "warning: sensor 'cued' aims at an elevation of -70.0 degrees, but its positioner"
                                + " tilts only from -50.0 to 60.0 degrees");
    }

    @Test
    void whoCannotTellWhereADroneIsCannotPointACamera() {
        assertThatThrownBy(() ->
                        runner().set("sensors.cued.positioner.cues", "rdar").settings())
                .isInstanceOf(InputException.class)
                .hasMessageContaining(
                        "sensor 'cued' is cued by 'rdar': there is no such sensor; closest matches: radar");
        assertThatThrownBy(() ->
                        runner().set("sensors.cued.positioner.cues", "cued").settings())
                .hasMessageContaining("is cued by itself");
        assertThatThrownBy(() -> runner().set("sensors.fixed", "droneshield-rfone")
                        .set("sensors.cued.positioner.cues", "fixed")
                        .settings())
                .hasMessageContaining(
                        "is cued by 'fixed', of kind rf, which does not measure the position or direction of a drone");
        assertThatThrownBy(() -> runner().set("sensors.cued.positioner.zoom.cued", "90 deg")
                        .settings())
                .hasMessageContaining("must be at most the camera's own field of view");
    }
}
