package org.dronewatch.sensor.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dronewatch.sensor.Walls.assess;
import static org.dronewatch.sensor.Walls.behind;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.look;
import static org.dronewatch.sensor.Walls.open;
import static org.dronewatch.sensor.Walls.wall;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.SplittableRandom;
import org.dronewatch.Wilson;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Draws;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.world.Light;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What a camera has of a drone before chance decides, and why that is not enough. */
class CameraAssessmentTest {
    private static final CameraSettings CAMERA = CameraSettings.at(new Position(0, 0, 0));
    private static final TargetTask BY_CHANCE = TargetTask.DEFAULT.withChance(true);
    private static final double FOCAL = new CameraObject(CAMERA).focalLength();

    /** A cube of 1 m to the north covers {@code (f / d)^2} pixels, f in pixels, within a row and a column. */
    private static double pixels(double distance) {
        return Math.pow(FOCAL / (distance - 0.5), 2);
    }

    @ParameterizedTest
    @ValueSource(doubles = {100, 300, 380})
    void aDroneOfEnoughPixelsIsDetected(double distance) {
        Assessment one = assess(CAMERA, open(), cube(new Position(0, distance, 0)));

        assertThat(one.cause()).isEqualTo(Cause.DETECTED);
        assertThat(one.probability()).isEqualTo(1.0);
        assertThat(one.quantity()).isCloseTo(pixels(distance), within(2.0 * FOCAL / distance + 1.0));
        assertThat(one.margin()).isEqualTo(one.quantity() - 12.0);
        assertThat(one.marginDb()).isCloseTo(10.0 * Math.log10(one.quantity() / 12.0), within(1e-12));
        assertThat(one.isEstimated()).isFalse();
    }

    @Test
    void aDroneOfTooFewPixelsIsTooWeak() {
        Assessment one = assess(CAMERA, open(), cube(new Position(0, 700, 0)));

        assertThat(one.cause()).isEqualTo(Cause.TOO_WEAK);
        assertThat(one.probability()).isZero();
        assertThat(one.quantity()).isBetween(1.0, 9.0);
        assertThat(one.margin()).isNegative();
        assertThat(one.obstacle()).isEmpty();
    }

    @ParameterizedTest
    @EnumSource(ModelRole.class)
    void aDroneBehindAWallIsHiddenByItsModel(ModelRole role) {
        Assessment one = assess(CAMERA, behind(wall(50, -9, 9), role), cube(new Position(0, 100, 0)));

        assertThat(one.cause()).isEqualTo(Cause.hiddenBy(role));
        assertThat(one.obstacle().orElseThrow().model().file()).isEqualTo("wall.obj");
        assertThat(one.obstacle().orElseThrow().material()).isEqualTo("stuff");
        assertThat(one.probability()).isZero();
        assertThat(one.quantity()).isZero();
    }

    @Test
    void aDroneOfWhichNothingIsVisibleIsHiddenEvenWhereItWouldBeTooSmall() {
        World world = behind(wall(50, -9, 9), ModelRole.TERRAIN);

        assertThat(assess(CAMERA, world, cube(new Position(0, 700, 0))).cause()).isEqualTo(Cause.HIDDEN_BY_TERRAIN);
        assertThat(assess(CAMERA, world, cube(new Position(0, 9000, 0))).cause())
                .isEqualTo(Cause.HIDDEN_BY_TERRAIN);
    }

    /** The wall reaches up to the drone's middle: half of 16 pixels is less than 12, half of 200 is more. */
    @Test
    void halfADroneIsHiddenWhereTheWholeWouldBeDetectedAndTooWeakWhereItWouldNot() {
        World world = behind(wall(20, -9, 0), ModelRole.BUILDING);

        assertThat(assess(CAMERA, world, cube(new Position(0, 100, 0))).cause()).isEqualTo(Cause.DETECTED);
        assertThat(assess(CAMERA, world, cube(new Position(0, 360, 0))).cause()).isEqualTo(Cause.HIDDEN_BY_BUILDING);
        Assessment weak = assess(CAMERA, world, cube(new Position(0, 600, 0)));
        assertThat(weak.quantity()).isPositive();
        assertThat(weak.cause()).isEqualTo(Cause.TOO_WEAK);
    }

    @Test
    void outOfViewCountsBeforeHidden() {
        World world = behind(wall(50, -9, 9), ModelRole.TERRAIN);
        Position aside = new Position(200, 100, 0);

        assertThat(assess(CAMERA, open(), cube(aside)).cause()).isEqualTo(Cause.OUT_OF_VIEW);
        assertThat(assess(CAMERA, world, cube(aside)).cause()).isEqualTo(Cause.OUT_OF_VIEW);
        assertThat(assess(CAMERA, open(), cube(new Position(0, -100, 0))).cause())
                .isEqualTo(Cause.OUT_OF_VIEW);
    }

    @Test
    void aPositionerBringsIntoViewWhatTheOwnAimMisses() {
        Drone east = cube(new Position(100, 0, 0));
        Pointing pointing = Pointing.still(new Direction(Math.PI / 2, 0), CAMERA.fov(), OptionalInt.empty());
        CameraSensor sensor = CAMERA.create();

        assertThat(sensor.assess(open(), east, Optional.empty(), new SplittableRandom(1))
                        .cause())
                .isEqualTo(Cause.OUT_OF_VIEW);
        assertThat(sensor.assess(open(), east, Optional.of(pointing), new SplittableRandom(1))
                        .cause())
                .isEqualTo(Cause.DETECTED);
    }

    @Test
    void hazeMakesItTooWeak() {
        CameraSettings camera = CAMERA.withDetection(TargetTask.DEFAULT);
        Drone drone = cube(new Position(0, 150, 0));

        assertThat(assess(camera, open(), drone).cause()).isEqualTo(Cause.DETECTED);
        World haze = open().withLight(Light.DAY.withVisibility(100));
        Assessment one = assess(camera, haze, drone);
        assertThat(one.cause()).isEqualTo(Cause.TOO_WEAK);
        assertThat(one.unit()).isEmpty();
        assertThat(one.probability()).isZero();
        assertThat(one.threshold()).isEqualTo(0.5);
        assertThat(assess(camera, behind(wall(50, -9, 9), ModelRole.OTHER).withLight(haze.light()), drone)
                        .cause())
                .isEqualTo(Cause.HIDDEN_BY_OTHER);
    }

    /** A picture every five seconds: 1 - exp(-P 5/3.4) of those find the drone in one who can at all. */
    @ParameterizedTest
    @ValueSource(doubles = {900, 1100, 1400})
    void byChanceALookFindsAsOftenAsObserversCanAndHaveTime(double distance) {
        CameraSettings camera = CAMERA.withDetection(BY_CHANCE).withRate(0.2);
        Drone drone = cube(new Position(0, distance, 0.2));
        Assessment one = assess(camera, open(), drone);
        CameraSensor sensor = camera.create();
        int hits = 0;
        for (int i = 0; i < 2000; i++) {
            Observation look = sensor.observe(open(), List.of(drone), Look.of(Draws.mix(7, i), "sensor", 1, 5.0))
                    .get(0);
            assertThat(look.value()).isEqualTo(one.quantity());
            hits += look.isDetected() ? 1 : 0;
        }
        double[] interval = Wilson.interval(hits, 2000, 3.3);
        double p = one.probability();
        assertThat(p).isBetween(0.02, 0.98);
        assertThat(p * (1.0 - Math.exp(-p * 5.0 / 3.4))).isBetween(interval[0], interval[1]);
        assertThat(one.cause()).isEqualTo(one.probability() >= 0.5 ? Cause.DETECTED : Cause.TOO_WEAK);
    }

    @Test
    void aLookAndAnAssessmentAgreeToTheLastBit() {
        for (CameraSettings camera : List.of(CAMERA, CAMERA.withDetection(TargetTask.DEFAULT))) {
            SplittableRandom random = new SplittableRandom(3);
            for (int i = 0; i < 50; i++) {
                Drone drone = cube(
                        new Position(random.nextDouble(-90, 90), random.nextDouble(20, 600), random.nextDouble(-3, 9)));
                World world = behind(wall(15, -9, 0.05), ModelRole.TERRAIN);
                Observation look = look(camera, world, drone, i);
                Assessment one = assess(camera, world, drone);
                assertThat(one.quantity()).isEqualTo(look.value());
                assertThat(one.threshold()).isEqualTo(look.threshold());
                assertThat(one.cause() == Cause.DETECTED).isEqualTo(look.isDetected());
            }
        }
    }
}
