package org.dronewatch.sensor.radar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dronewatch.sensor.Walls.assess;
import static org.dronewatch.sensor.Walls.behind;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.look;
import static org.dronewatch.sensor.Walls.open;
import static org.dronewatch.sensor.Walls.wall;

import java.util.Optional;
import java.util.random.RandomGenerator;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.RadarSignature.Fluctuation;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.radar.DopplerFilter.HighPass;
import org.dronewatch.sensor.radar.LinkBudget.Hardware;
import org.dronewatch.sensor.radar.RadarDetection.Chance;
import org.dronewatch.sensor.radar.RadarDetection.Decision;
import org.dronewatch.sensor.radar.RadarDetection.FixedThreshold;
import org.dronewatch.sensor.radar.SurfaceReflectivity.ConstantGamma;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Limits of a radar belong to what it detects; and figures of looks that are limited. */
class RadarLimitsTest {
    private static final Hardware BUDGET = new Hardware(4, 33, 0.02, 10e6, 0, 0);
    private static final RadarSettings RADAR =
            RadarSettings.at(new Position(0, 0, 0), BUDGET).withFieldOfView(Math.toRadians(60), Math.toRadians(20));

    private static Drone northwards(double speed) {
        return cube(new Position(0, 1000, 0), new Position(0, speed, 0));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, -1, 200, -200})
    void aDroneAtALimitOfRadialSpeedIsDetected(double speed) {
        assertThat(look(RADAR, open(), northwards(speed), 0).isDetected()).isTrue();
        assertThat(assess(RADAR, open(), northwards(speed)).cause()).isEqualTo(Cause.DETECTED);
    }

    /** Detected, with a sighting, at a probability of one: to the last bit. */
    @Test
    void anEchoThatReachesTheThresholdIsDetected() {
        double echo = look(RADAR, open(), northwards(-10), 0).value();
        RadarSettings reached = RADAR.withDetection(new FixedThreshold(echo));
        Observation seen = look(reached, open(), northwards(-10), 0);
        assertThat(seen.isDetected()).isTrue();
        assertThat(seen.sighting()).isPresent();
        assertThat(seen.probability()).isEqualTo(1.0);
        RadarSettings missed = RADAR.withDetection(new FixedThreshold(Math.nextUp(echo)));
        Observation unseen = look(missed, open(), northwards(-10), 0);
        assertThat(unseen.isDetected()).isFalse();
        assertThat(unseen.sighting()).isEmpty();
        assertThat(unseen.probability()).isZero();
    }

    /** What hides a drone is named if the whole of it would reach the threshold, and the notch if it would without. */
    @Test
    void aMissIsExplainedByWhatKeepsTheEchoFromTheThreshold() {
        double echo = look(RADAR, open(), northwards(-10), 0).value();
        RadarSettings reached = RADAR.withDetection(new FixedThreshold(echo));
        RadarSettings missed = RADAR.withDetection(new FixedThreshold(Math.nextUp(echo)));
        World half = behind(wall(500, -99, 0), ModelRole.BUILDING);
        assertThat(assess(reached, half, northwards(-10)).cause()).isEqualTo(Cause.HIDDEN_BY_BUILDING);
        assertThat(assess(missed, half, northwards(-10)).cause()).isEqualTo(Cause.TOO_WEAK);
        HighPass notch = new HighPass(5, 2);
        assertThat(assess(reached.withNotch(notch), open(), northwards(-1)).cause())
                .isEqualTo(Cause.TOO_SLOW);
        assertThat(assess(missed.withNotch(notch), open(), northwards(-1)).cause())
                .isEqualTo(Cause.TOO_WEAK);
    }

    /** Random numbers that ask for the least that a look may need: a probability near 0, and a strong look. */
    private static RandomGenerator easiest() {
        return new RandomGenerator() {
            @Override
            public long nextLong() {
                return -1;
            }

            @Override
            public double nextDouble() {
                return Math.nextDown(1.0);
            }

            @Override
            public double nextGaussian() {
                return 5;
            }
        };
    }

    /** A look by chance may detect an echo at the least threshold that may be drawn, but none below it. */
    @Test
    void theProbabilityIsZeroOnlyBelowTheLeastThreshold() {
        Chance chance = new Chance(1e-3, 4);
        for (Decision decision : new Decision[] {chance.on(Fluctuation.STEADY), chance.on(4.0)}) {
            double least = decision.threshold(easiest());
            assertThat(least).isFinite();
            assertThat(decision.probability(least)).isCloseTo(1e-3, within(1e-6));
            assertThat(decision.probability(Math.nextDown(least))).isZero();
        }
    }

    @Test
    void theFiguresTellWhetherADroneIsInTheField() {
        assertThat(look(RADAR, open(), northwards(-10), 0).figures()).containsEntry("in_field", 1.0);
        assertThat(look(RADAR, open(), northwards(0), 0).figures())
                .as("too slow")
                .containsEntry("in_field", 1.0)
                .containsEntry("visible_share", 0.0);
        Drone aside = cube(new Position(1000, 1000, 0), new Position(-10, -10, 0));
        assertThat(look(RADAR, open(), aside, 0).figures()).containsEntry("in_field", 0.0);
    }

    /** Outside the field the heading does not matter, whatever the radial speed; inside, it does. */
    @Test
    void headingsMatterOnlyInTheField() {
        RadarSensor sensor = RADAR.create();
        Drone behind = cube(new Position(0, -1000, 0), new Position(0, 10, 0));
        assertThat(sensor.isSameAtAllHeadings(open(), behind, Optional.empty())).isTrue();
        Drone far = cube(new Position(0, 10_001, 0), new Position(0, -10, 0));
        assertThat(sensor.isSameAtAllHeadings(open(), far, Optional.empty())).isTrue();
        assertThat(sensor.isSameAtAllHeadings(open(), northwards(-10), Optional.empty()))
                .isFalse();
        assertThat(sensor.isSameAtAllHeadings(open(), northwards(0), Optional.empty()))
                .isFalse();
    }

    /** A miss is explained at the site that is asked about, whether or not the sensor has looked there before. */
    @Test
    void aMissIsExplainedAtTheSiteItself() {
        RadarSensor sensor = RADAR.create();
        World walled = behind(wall(500, -99, 99), ModelRole.BUILDING);
        assertThat(sensor.explainMiss(walled, northwards(-10), Optional.empty()).cause())
                .isEqualTo(Cause.HIDDEN_BY_BUILDING);
        assertThat(sensor.explainMiss(open(), northwards(-10), Optional.empty()).cause())
                .isEqualTo(Cause.TOO_WEAK);
    }

    /** The specific attenuation is that of the path's elevation: 30 degrees, both ways. */
    @Test
    void rainOnARisingPathIsThatOfItsElevation() {
        RadarSettings wide = RADAR.withFieldOfView(Math.PI, Math.PI);
        Position place = new Position(0, 2000 * Math.cos(Math.PI / 6), 2000 * 0.5);
        Drone drone = cube(place, place.times(-0.01));
        double loss = look(wide, open(), drone, 0).value()
                - look(wide, open().withRain(25), drone, 0).value();
        double expected = 2 * 2000 * Rain.attenuation(10e9, 25, Math.PI / 6, Rain.Polarisation.HORIZONTAL);
        assertThat(loss).isCloseTo(expected, within(1e-9));
    }

    /** What the notch takes from the drone it takes from both ratios: N / S + C / S = (N + C) / S. */
    @Test
    void theRatioToTheClutterIsThatBehindTheNotch() {
        World wet = open().withRain(25);
        RadarSettings radar = RADAR.withBeam(BeamPattern.of(0.05, 0.2))
                .withNotch(new HighPass(5, 2))
                .withClutter(Clutter.of(new ConstantGamma(-13), 20));
        Observation seen = look(radar, wet, northwards(-4), 0);
        double clutter = Math.pow(10, 0.1 * seen.figures().get("clutter_to_noise_db"));
        assertThat(seen.figures().get("notch_db")).isLessThan(-1);
        assertThat(seen.figures().get("signal_to_clutter_db") + 10 * Math.log10(clutter / (1 + clutter)))
                .isCloseTo(seen.value(), within(1e-9));
    }
}
