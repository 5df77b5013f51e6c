package org.dronewatch.sensor.radar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Sighting;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Outline;
import org.dronewatch.sensor.Reading;
import org.dronewatch.sensor.Walls;
import org.dronewatch.sensor.alarm.AzimuthSpan;
import org.dronewatch.sensor.radar.LinkBudget.Hardware;
import org.dronewatch.sensor.radar.RadarDetection.Chance;
import org.dronewatch.sensor.radar.RadarDetection.FixedThreshold;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Where noise is taken for a target, and how strong it appears. */
class RadarNoiseTest {
    private static final long SEED = 20_261_201;
    private static final Position PLACE = new Position(30, -20, 10);
    private static final RadarSettings RADAR = RadarSettings.at(PLACE, new Hardware(4, 33, 0.02, 10e6, 0, 0))
            .withAim(new Aim.Direction(0.7, 0.3))
            .withFieldOfView(1.2, 0.8)
            .withRanges(100, 900);

    private static Sighting noise(RadarSettings radar, double u, double v, double w) {
        return radar.falseSighting(u, v, w).orElseThrow();
    }

    /** Three numbers, one for each: range and azimuth go with them in proportion, from one end to the other. */
    @Test
    void cellsAreEquallyDeepAndEquallyWide() {
        assertThat(RADAR.dimensions()).isEqualTo(3);
        for (double part : new double[] {0, 0.25, 0.5, 1}) {
            Sighting deep = noise(RADAR, part, 0.5, 0.5);
            assertThat(deep.range().orElseThrow()).isCloseTo(100 + 800 * part, within(1e-9));
            assertThat(deep.direction().azimuth()).isCloseTo(0.7, within(1e-9));
            Sighting aside = noise(RADAR, 0.5, part, 0.5);
            assertThat(aside.direction().azimuth()).isCloseTo(0.1 + 1.2 * part, within(1e-9));
            assertThat(aside.range().orElseThrow()).isCloseTo(500, within(1e-9));
            assertThat(aside.from()).isEqualTo(PLACE);
        }
        assertThat(RADAR.falseBearings()).contains(new AzimuthSpan(0.7, 1.2));
    }

    /** The solid angle between two elevations goes with the difference of their sines (Archimedes). */
    @Test
    void cellsHaveEqualSolidAngles() {
        double below = Math.sin(0.3 - 0.4);
        double whole = Math.sin(0.3 + 0.4) - below;
        for (double part : new double[] {0, 0.25, 0.5, 1}) {
            Sighting seen = noise(RADAR, 0.5, 0.5, part);
            assertThat((Math.sin(seen.direction().elevation()) - below) / whole).isCloseTo(part, within(1e-12));
            assertThat(seen.hasElevation()).isTrue();
        }
    }

    /** A field that would reach over the zenith, or below the nadir, ends there. */
    @Test
    void aSteepFieldEndsOverheadOrBelow() {
        RadarSettings up = RADAR.withAim(new Aim.Direction(0.7, 1.4));
        assertThat(noise(up, 0.5, 0.5, 0).direction().elevation()).isCloseTo(1.0, within(1e-9));
        assertThat(noise(up, 0.5, 0.5, 1).direction().elevation()).isCloseTo(0.5 * Math.PI, within(1e-7));
        RadarSettings down = RADAR.withAim(new Aim.Direction(0.7, -1.4));
        assertThat(noise(down, 0.5, 0.5, 0).direction().elevation()).isCloseTo(-0.5 * Math.PI, within(1e-7));
        assertThat(noise(down, 0.5, 0.5, 1).direction().elevation()).isCloseTo(-1.0, within(1e-9));
    }

    @Test
    void noiseIsSeenWithinTheFieldOfView() {
        SplittableRandom random = new SplittableRandom(SEED);
        Outline.Sector field = RADAR.outline();
        for (int i = 0; i < 1000; i++) {
            Position seen = noise(RADAR, random.nextDouble(), random.nextDouble(), random.nextDouble())
                    .position()
                    .orElseThrow();
            assertThat(field.contains(seen.minus(PLACE)))
                    .as("seed %d, alarm %d", SEED, i)
                    .isTrue();
        }
    }

    @Test
    void aRadarThatMeasuresNoElevationAssumesThatOfItsAim() {
        RadarSettings fan = RADAR.withAccuracy(Accuracy.DEFAULT.withoutElevation());
        Sighting seen = noise(fan, 0, 0, 0);
        assertThat(seen.hasElevation()).isFalse();
        assertThat(seen.direction().elevation()).isCloseTo(0.3, within(1e-12));
    }

    private static double ratio(double decibels) {
        return Math.pow(10, 0.1 * decibels);
    }

    /** For one pulse, the excess is that of the power over the threshold, in units of the mean noise. */
    @ParameterizedTest
    @CsvSource({"0", "0.5", "3"})
    void theExcessAddsToThePowerOfTheThreshold(double excess) {
        Reading fixed = RADAR.withDetection(new FixedThreshold(12)).falseReading(Walls.open(), excess);
        assertThat(fixed.threshold()).isEqualTo(12.0);
        assertThat(ratio(fixed.value()) - ratio(12)).isCloseTo(excess, within(1e-9));
        Reading chance = RADAR.withDetection(new Chance(1e-4, 1)).falseReading(Walls.open(), excess);
        assertThat(Math.exp(-ratio(chance.threshold()))).isCloseTo(1e-4, within(1e-15));
        assertThat(ratio(chance.value()) - ratio(chance.threshold())).isCloseTo(excess, within(1e-9));
        assertThat(fixed.isDetected() && chance.isDetected()).isTrue();
        assertThat(fixed.unit()).isEqualTo("dB").isEqualTo(chance.unit());
    }

    /**
     * For several pulses, the sum exceeds the threshold with the probability of a false alarm, and the reading with
     * that times {@code exp(-excess)}: nearly so just above the threshold, and never more often, since the tail of the
     * sum falls ever more steeply.
     */
    @ParameterizedTest
    @CsvSource({"2, 1e-3", "10, 1e-6", "300, 1e-6"})
    void sumsOfNoiseExceedTheThresholdExponentially(int pulses, double falseAlarm) {
        RadarSettings radar = RADAR.withDetection(new Chance(falseAlarm, pulses));
        double threshold = radar.falseReading(Walls.open(), 0).threshold();
        assertThat(DetectabilityTest.erlangTail(pulses, pulses * ratio(threshold)) / falseAlarm)
                .isCloseTo(1, within(1e-9));
        for (double excess : new double[] {0, 0.01, 1, 5}) {
            Reading reading = radar.falseReading(Walls.open(), excess);
            double share = DetectabilityTest.erlangTail(pulses, pulses * ratio(reading.value()))
                    / falseAlarm
                    / Math.exp(-excess);
            assertThat(reading.threshold()).isEqualTo(threshold);
            assertThat(share).isLessThanOrEqualTo(1 + 1e-9);
            assertThat(share).isGreaterThan(excess < 0.1 ? 1 - 1e-4 : 0.3);
        }
    }
}
