package org.dronewatch.sensor.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.look;
import static org.dronewatch.sensor.Walls.open;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.Wilson;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.PositionerSettings;
import org.dronewatch.positioner.Sighting;
import org.dronewatch.sensor.Discrimination;
import org.dronewatch.sensor.Encounters;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Which drones a camera sights: those that it detects and, on a positioner, those that it can follow. */
class CameraFollowingTest {
    private static final World OPEN = open();
    private static final CameraSettings FIXED = CameraSettings.at(new Position(0, 0, 0));
    private static final Drone DRONE = cube(new Position(0, 600, 0));
    private static final int PIXELS = FIXED.create().pixels(OPEN, DRONE);

    private static CameraSettings mounted(DetectionFunction detection, double lockPixels) {
        return FIXED.withDetection(detection)
                .withPositioner(SettingsForm.with(PositionerSettings.DEFAULT, "lockPixels", lockPixels));
    }

    private static boolean isSighted(CameraSettings camera) {
        return look(camera, OPEN, DRONE, 1).sighting().isPresent();
    }

    @Test
    void aFixedCameraSightsWhatItDetects() {
        assertThat(PIXELS).isBetween(4, 9);
        assertThat(isSighted(FIXED)).isFalse();
        assertThat(isSighted(FIXED.withThreshold(PIXELS))).isTrue();
    }

    /** The direction of the drone; a square of its pixels at the focal length is as wide as its size. */
    @Test
    void aSightingTellsDirectionAndSize() {
        Drone drone = cube(new Position(10, 100, 5));
        Observation seen = look(FIXED, OPEN, drone, 1);
        Sighting sighting = seen.sighting().orElseThrow();
        double focalLength = new CameraObject(FIXED).focalLength();

        assertThat(sighting.direction().azimuth()).isCloseTo(Math.atan(0.1), within(1e-12));
        assertThat(sighting.direction().elevation()).isCloseTo(Math.atan(5 / Math.hypot(10, 100)), within(1e-12));
        assertThat(sighting.range()).isEmpty();
        assertThat(sighting.size().orElseThrow())
                .isCloseTo(Math.sqrt(seen.value()) / focalLength, within(0.03 * Math.sqrt(seen.value()) / focalLength));
    }

    @Test
    void aPositionerFollowsFromItsOwnNumberOfPixelsOn() {
        assertThat(isSighted(mounted(PixelThreshold.DEFAULT, PIXELS))).isTrue();
        assertThat(isSighted(mounted(PixelThreshold.DEFAULT, PIXELS + 1))).isFalse();
        assertThat(isSighted(mounted(new PixelThreshold(PIXELS), PIXELS + 1)))
                .as("detected anyway")
                .isTrue();
        assertThat(look(mounted(PixelThreshold.DEFAULT, 1), OPEN, DRONE, 1).isDetected())
                .isFalse();
    }

    /** A function that says nothing about following: what is not detected is not followed. */
    @Test
    void byDefaultOnlyADetectedDroneIsFollowed() {
        assertThat(isSighted(mounted(new ViewRecorder(new ArrayList<>()), 1))).isFalse();
        Observation near =
                look(mounted(new ViewRecorder(new ArrayList<>()), 1e6), OPEN, cube(new Position(0, 100, 0)), 1);
        assertThat(near.isDetected()).isTrue();
        assertThat(near.sighting()).isPresent();
    }

    /** The probability of detection must reach the threshold, whatever the task is, in every look. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10})
    void aDroneIsFollowedIfItWouldBeDetected(long seed) {
        TargetTask detection = TargetTask.DEFAULT;
        TargetTask identification = detection.withTask(Discrimination.IDENTIFICATION);
        double exact = look(FIXED.withDetection(detection), OPEN, DRONE, seed).value();
        assertThat(exact).isBetween(0.5, Math.nextDown(1.0));

        Observation followed = look(mounted(identification.withProbability(exact), 1), OPEN, DRONE, seed);
        assertThat(followed.isDetected()).isFalse();
        assertThat(followed.sighting()).isPresent();
        Observation lost = look(mounted(identification.withProbability(Math.nextUp(exact)), 1), OPEN, DRONE, seed);
        assertThat(lost.sighting()).isEmpty();
        assertThat(isSighted(mounted(identification.withProbability(exact), PIXELS + 1)))
                .as("too few pixels")
                .isFalse();
    }

    /**
     * Who has found a drone that does not change knows where it is in all later looks, although it cannot be
     * identified; P (1 - exp(-P t / 3.4 s)) have found it after the time t, with the probability P of detection.
     */
    @Test
    void anObserverWhoKnowsWhereADroneIsKeepsFollowingIt() {
        TargetTask identification = TargetTask.DEFAULT.withTask(Discrimination.IDENTIFICATION);
        CameraSettings camera = mounted(identification.withChance(true), 1);
        CameraSensor sensor = camera.create();
        int found = 0;
        for (long seed = 1; seed <= 200; seed++) {
            Encounters encounters = Encounters.NONE;
            boolean isKnown = false;
            for (int i = 0; i <= 60; i++) {
                Look look = Look.of(seed, "camera", i, i / camera.rate()).withEncounters(encounters);
                List<Observation> seen = sensor.observe(OPEN, List.of(DRONE), look);
                boolean isSighted = seen.get(0).sighting().isPresent();
                assertThat(isSighted || !isKnown)
                        .as("seed %d, look %d", seed, i)
                        .isTrue();
                isKnown = isSighted;
                encounters = Encounters.after(look, camera.rate(), seen);
            }
            found += isKnown ? 1 : 0;
        }
        double p = look(FIXED.withDetection(TargetTask.DEFAULT), OPEN, DRONE, 1).value();
        double[] interval = Wilson.interval(found, 200, 3.3);
        assertThat(p * (1.0 - Math.exp(-p * 6.0 / 3.4))).isBetween(interval[0], interval[1]);
    }

    /** What a sighting's direction is measured from: a camera elsewhere, turned elsewhere. */
    @Test
    void directionsAreThoseFromTheCamera() {
        CameraSettings camera = CameraSettings.at(new Position(50, -20, 7)).withLookAt(new Position(150, -20, 7));
        Sighting sighting = look(camera, OPEN, cube(new Position(150, -20, 7)), 1)
                .sighting()
                .orElseThrow();

        assertThat(sighting.from()).isEqualTo(camera.position());
        assertThat(sighting.direction().unit().distance(new Direction(Math.PI / 2, 0).unit()))
                .isCloseTo(0.0, within(1e-12));
    }
}
