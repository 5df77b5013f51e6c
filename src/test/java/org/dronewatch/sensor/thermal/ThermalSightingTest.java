package org.dronewatch.sensor.thermal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.open;

import java.util.List;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.HeatSignature;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.positioner.PositionerSettings;
import org.dronewatch.sensor.Discrimination;
import org.dronewatch.sensor.Encounters;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.setting.SettingsForm;
import org.junit.jupiter.api.Test;

/**
 * Which drones a look of a thermal camera gives a direction of: those that it detects and, on a positioner, those of
 * enough pixels that it would detect if that were its task.
 */
class ThermalSightingTest {
    private static final Position ORIGIN = new Position(0, 0, 0);
    private static final ThermalSettings CAMERA = ThermalSettings.at(ORIGIN);
    private static final ThermalSettings RECOGNISING = CAMERA.withTask(Discrimination.RECOGNITION);

    private static Drone warm(double kelvins, double range) {
        DroneSettings settings = DroneSettings.of(ModelSettings.of("cube.obj"), Hover.at(ORIGIN))
                .withHeat(HeatSignature.DEFAULT.withExcess(kelvins));
        return cube(settings, new Position(0, range, 0), ORIGIN);
    }

    private static Observation look(ThermalSettings camera, Drone drone) {
        return look(camera, drone, Look.of(1, "heat", 0, 0.0));
    }

    private static Observation look(ThermalSettings camera, Drone drone, Look look) {
        return camera.create().observe(open(), List.of(drone), look).get(0);
    }

    private static boolean isSighted(ThermalSettings camera, Drone drone) {
        return look(camera, drone).sighting().isPresent();
    }

    private static ThermalSettings tracking(ThermalSettings camera, double lockPixels) {
        return camera.withPositioner(SettingsForm.with(PositionerSettings.DEFAULT, "lockPixels", lockPixels));
    }

    private static ThermalSettings withProbability(ThermalSettings camera, double probability) {
        return SettingsForm.with(camera, "probability", probability);
    }

    @Test
    void aFixedCameraGivesTheDirectionOfJustWhatItDetects() {
        for (ThermalSettings camera : List.of(CAMERA, RECOGNISING)) {
            int detected = 0;
            for (double range = 100.0; range < 1600.0; range += 100.0) {
                Observation seen = look(camera, warm(5.0, range));
                assertThat(seen.sighting().isPresent()).as("%f m", range).isEqualTo(seen.isDetected());
                detected += seen.isDetected() ? 1 : 0;
            }
            assertThat(detected).isBetween(1, 14);
        }
    }

    /** The limits are reached by what equals them: the probability of the settings, and the positioner's pixels. */
    @Test
    void aDroneExactlyAtALimitIsSighted() {
        Drone drone = warm(5.0, 900);
        Observation seen = look(CAMERA, drone);
        double probability = seen.value();
        double pixels = seen.figures().get("pixels");
        assertThat(probability).isBetween(0.5, 0.99);
        assertThat(look(RECOGNISING, drone).value()).isLessThan(0.1);

        Observation equal = look(withProbability(CAMERA, probability), drone);
        assertThat(equal.isDetected()).isTrue();
        assertThat(equal.sighting()).isPresent();
        assertThat(isSighted(withProbability(CAMERA, Math.nextUp(probability)), drone))
                .isFalse();

        ThermalSettings recognising = withProbability(RECOGNISING, probability);
        assertThat(look(tracking(recognising, pixels), drone).isDetected()).isFalse();
        assertThat(isSighted(tracking(recognising, pixels), drone)).isTrue();
        assertThat(isSighted(tracking(recognising, Math.nextUp(pixels)), drone)).isFalse();
        assertThat(isSighted(tracking(withProbability(RECOGNISING, Math.nextUp(probability)), pixels), drone))
                .isFalse();
    }

    /** Many pixels are not enough: a drone that is hardly warmer than what is behind it shows no detail. */
    @Test
    void aPositionerDoesNotFollowALargeDroneWithoutContrast() {
        Observation cool = look(tracking(RECOGNISING, 6.0), warm(0.105, 100));

        assertThat(cool.figures().get("pixels")).isGreaterThan(100.0);
        assertThat(cool.isDetected()).isFalse();
        assertThat(cool.sighting()).isEmpty();
    }

    /**
     * At a ratio of 3.5 and a threshold of 3.9 the program marks a third of the frames, while an observer would detect
     * 200 pixels of which nearly half of the detail is resolved.
     */
    @Test
    void aProgramFollowsOnlyTheSpotsThatItHasFound() {
        Drone drone = warm(5.0, 100);
        ThermalSettings noisy = tracking(CAMERA.withNetd(5.0 * Math.pow(0.85, 0.1) / 3.5), 6.0);
        Observation spot = look(noisy.withPointTargets(PointTargets.DEFAULT), drone);

        assertThat(spot.figures().get("pixels")).isGreaterThan(100.0);
        assertThat(spot.figures().get("snr_threshold")).isBetween(3.9, 4.0);
        assertThat(spot.isDetected()).isFalse();
        assertThat(spot.sighting()).isEmpty();
        assertThat(isSighted(noisy, drone)).isTrue();
    }

    /** With chance, a drone must have been found by a search before it is followed; without, it is seen at once. */
    @Test
    void byChanceADroneIsFollowedOnceAnObserverHasFoundIt() {
        ThermalSettings camera = tracking(CAMERA.withTask(Discrimination.IDENTIFICATION), 6.0);
        ThermalSettings byChance = camera.withChance(true);
        Drone drone = warm(5.0, 330);
        Look start = Look.of(1, "heat", 0, 0.0);

        Observation certain = look(camera, drone, start);
        assertThat(certain.isDetected()).isFalse();
        assertThat(certain.sighting()).isPresent();
        Observation first = look(byChance, drone, start);
        assertThat(first.isDetected()).isFalse();
        assertThat(first.sighting()).as("no time to search").isEmpty();

        Observation located = first.withSighting(certain.sighting());
        Encounters known = Encounters.after(start, byChance.rate(), List.of(located));
        Look next = Look.of(1, "heat", 1, 0.04).withEncounters(known);
        assertThat(look(byChance, drone, next).sighting()).as("found before").isPresent();
    }

    @Test
    void anObservationNamesTheKindOfItsCamera() {
        assertThat(look(CAMERA, warm(5.0, 100)).kind()).isEqualTo("thermal");
        assertThat(CAMERA.create().settings()).isEqualTo(CAMERA);
    }

    /** A drone at the lens has no defined motion across the image, which must not matter if nothing is resolved. */
    @Test
    void aDroneWithoutContrastHasNoProbabilityAtTheLensEither() {
        Observation cool = look(CAMERA, warm(0.01, 0.0));

        assertThat(cool.figures().get("pixels")).isEqualTo(640.0 * 512.0);
        assertThat(cool.value()).isZero();
        assertThat(cool.probability()).isZero();
        assertThat(cool.sighting()).isEmpty();
    }
}
