package org.dronewatch.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.PairResult;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.world.Ground;
import org.jogamp.vecmath.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The site with thirteen sensors: ranges stay what they are, from every side. */
class MultiSensorTest {
    private static SceneRunner from(String bearing) {
        return new SceneRunner(new MultiSensor()).set("drones.quadrotor.flight.bearing", bearing);
    }

    private static List<PairResult> detected(SceneResult result) {
        return result.pairs().stream().filter(pair -> pair.range().isPresent()).toList();
    }

    @Test
    void theRangesAreWhatTheyWere() {
        SceneResult result = new SceneRunner(new MultiSensor()).run();

        assertThat(result.firstDetectionRange(0, "microphone", "quadrotor").orElseThrow())
                .isCloseTo(100.0, within(0.5));
        assertThat(result.firstDetectionRange(0, "north-east-1", "quadrotor").orElseThrow())
                .isBetween(118.0, 123.0);
        assertThat(detected(result).stream().map(PairResult::sensor))
                .containsExactly("north-east-1", "north-west-3", "microphone");
    }

    /**
     * A silhouette of A m2 at an angle t off the axis covers {@code A (f/d)^2 / cos^3 t} pixels on average; thin arms
     * alias, so the first detection is at 0.8 to 1.55 times the range that this law gives.
     */
    @ParameterizedTest
    @CsvSource({"0 deg", "45 deg", "100 deg", "225 deg", "310 deg"})
    void everySideIsSeenWhereTheLawSays(String bearing) {
        SceneRunner runner = from(bearing);
        SceneSettings settings = runner.settings();
        SceneResult result = runner.run();
        List<PairResult> cameras = detected(result).stream()
                .filter(pair -> pair.kind().equals("camera"))
                .toList();

        int byLaw = 0;
        FlightPath flight = settings.drones().get("quadrotor").createFlight(Ground.NONE);
        for (PairResult pair : cameras) {
            CameraSettings camera = (CameraSettings) settings.sensors().get(pair.sensor());
            Position place = flight.at(pair.firstDetected().orElseThrow()).position();
            Vector3d way = place.minus(camera.position()).toVector3d();
            double angle = way.angle(camera.aim().from(camera.position()).toVector3d());
            double law =
                    camera.focalLength() * Math.sqrt(CameraRange.FRONTAL_AREA / 12.0 / Math.pow(Math.cos(angle), 3));
            double before = pair.firstDetected().orElseThrow() - 0.1;
            if (isInThePicture(camera, flight.at(before).position())) {
                assertThat(pair.range().orElseThrow() / law)
                        .as("%s from %s, %.0f deg off its axis", pair.sensor(), bearing, Math.toDegrees(angle))
                        .isBetween(0.8, 1.55);
                byLaw++;
            } else {
                // It came into the picture from the side, too near for the law.
                assertThat(pair.range().orElseThrow()).isLessThan(law);
            }
        }
        assertThat(byLaw).isPositive();
        assertThat(result.firstDetectionRange(0, "microphone", "quadrotor").orElseThrow())
                .isCloseTo(100.0, within(0.5));
    }

    /** Whole, with the half metre that the drone reaches to each side. */
    private static boolean isInThePicture(CameraSettings camera, Position place) {
        double margin = camera.focalLength() * 0.5 / place.distance(camera.position());
        return new CameraObject(camera)
                .pixelOf(place.toPoint3d())
                .filter(pixel -> pixel.x > margin
                        && pixel.x < camera.width() - margin
                        && pixel.y > margin
                        && pixel.y < camera.height() - margin)
                .isPresent();
    }

    @Test
    void aLouderDroneIsHeardFartherAndALargerSeenFarther() {
        SceneResult louder = new SceneRunner(new MultiSensor())
                .set("drones.quadrotor.soundLevel", "54 dB")
                .run();
        assertThat(louder.firstDetectionRange(0, "microphone", "quadrotor").orElseThrow())
                .isCloseTo(140.0, within(0.5));
        SceneResult larger = new SceneRunner(new MultiSensor())
                .set("drones.quadrotor.model.scale", "1.3")
                .run();
        assertThat(larger.firstDetectionRange(0, "north-east-1", "quadrotor").orElseThrow())
                .isGreaterThan(140.0);
    }
}
