package org.dronewatch.sensor.thermal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dronewatch.sensor.Walls.assess;
import static org.dronewatch.sensor.Walls.behind;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.look;
import static org.dronewatch.sensor.Walls.open;
import static org.dronewatch.sensor.Walls.wall;

import java.util.List;
import java.util.SplittableRandom;
import org.dronewatch.Thorough;
import org.dronewatch.Wilson;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Draws;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What a thermal camera has of a drone before chance decides, and why that is not enough. */
class ThermalAssessmentTest {
    private static final ThermalSettings CAMERA = ThermalSettings.at(new Position(0, 0, 0));

    @Test
    void aDroneIsDetectedNearAndTooWeakFarAway() {
        Assessment near = assess(CAMERA, open(), cube(new Position(0, 200, 0)));
        assertThat(near.cause()).isEqualTo(Cause.DETECTED);
        assertThat(near.probability()).isEqualTo(1.0);

        Assessment far = assess(CAMERA, open(), cube(new Position(0, 4000, 0)));
        assertThat(far.cause()).isEqualTo(Cause.TOO_WEAK);
        assertThat(far.probability()).isZero();
        assertThat(far.quantity()).isLessThan(0.5);
        assertThat(far.threshold()).isEqualTo(0.5);
    }

    @ParameterizedTest
    @EnumSource(ModelRole.class)
    void aDroneBehindAWallIsHiddenByItsModelUnlessItIsOutOfView(ModelRole role) {
        World world = behind(wall(50, -99, 99), role);

        assertThat(assess(CAMERA, world, cube(new Position(0, 200, 0))).cause()).isEqualTo(Cause.hiddenBy(role));
        assertThat(assess(CAMERA, world, cube(new Position(0, 4000, 0))).cause())
                .isEqualTo(Cause.hiddenBy(role));
        assertThat(assess(CAMERA, world, cube(new Position(300, 200, 0))).cause())
                .isEqualTo(Cause.OUT_OF_VIEW);
        assertThat(assess(CAMERA, open(), cube(new Position(0, -200, 0))).cause())
                .isEqualTo(Cause.OUT_OF_VIEW);
    }

    @Test
    void noiseMakesItTooWeak() {
        ThermalSettings noisy = CAMERA.withNetd(50.0).withTransmission(0.85);

        assertThat(assess(noisy, open(), cube(new Position(0, 200, 0))).cause()).isEqualTo(Cause.TOO_WEAK);
    }

    /** At 25 frames a second: a frame finds the drone for 1 - exp(-P 0.04/3.4) of those observers who can at all. */
    @Thorough
    @ParameterizedTest
    @ValueSource(doubles = {700, 900, 1200})
    void byChanceALookFindsAsOftenAsObserversCanAndHaveTime(double distance) {
        ThermalSettings camera = CAMERA.withChance(true);
        Drone drone = cube(new Position(0, distance, 0));
        Assessment one = assess(camera, open(), drone);
        ThermalSensor sensor = camera.create();
        World world = open();
        int hits = 0;
        int looks = 5000;
        for (int i = 0; i < looks; i++) {
            Observation look = sensor.observe(world, List.of(drone), Look.of(Draws.mix(7, i), "sensor", 9, 0.36))
                    .get(0);
            assertThat(look.value()).isEqualTo(one.quantity());
            hits += look.isDetected() ? 1 : 0;
        }
        double[] interval = Wilson.interval(hits, looks, 3.3);
        double p = one.probability();
        assertThat(p).isBetween(0.02, 0.98);
        assertThat(p * (1.0 - Math.exp(-p * 0.04 / 3.4))).isBetween(interval[0], interval[1]);
        assertThat(one.cause()).isEqualTo(one.probability() >= 0.5 ? Cause.DETECTED : Cause.TOO_WEAK);
    }

    @Test
    void aLookAndAnAssessmentAgreeToTheLastBit() {
        SplittableRandom random = new SplittableRandom(3);
        World world = behind(wall(15, -9, 0.05), ModelRole.TERRAIN);
        for (int i = 0; i < 50; i++) {
            Drone drone = cube(
                    new Position(random.nextDouble(-90, 90), random.nextDouble(20, 2000), random.nextDouble(-3, 9)));
            Observation look = look(CAMERA, world, drone, i);
            Assessment one = assess(CAMERA, world, drone);
            assertThat(one.quantity()).isEqualTo(look.value());
            assertThat(one.threshold()).isEqualTo(look.threshold());
            assertThat(one.cause() == Cause.DETECTED).isEqualTo(look.isDetected());
        }
    }
}
