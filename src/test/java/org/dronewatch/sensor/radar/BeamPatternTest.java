package org.dronewatch.sensor.radar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.look;
import static org.dronewatch.sensor.Walls.open;

import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.Sighting;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.radar.BeamPattern.Steering;
import org.dronewatch.sensor.radar.LinkBudget.Hardware;
import org.dronewatch.sensor.radio.AntennaPattern;
import org.dronewatch.sensor.radio.ReflectingGround;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Main lobe and side lobes after 3GPP TR 38.901, table 7.3-1; the loss of a steered array; echoes through the beam. */
class BeamPatternTest {
    private static final Direction NORTH = new Direction(0, 0);
    private static final BeamPattern BEAM = BeamPattern.of(rad(3), rad(10));
    private static final long SEED = 20_261_125;
    private static final Hardware BUDGET = new Hardware(4, 25, 0.02, 10e6, 5, 6);
    private static final RadarSettings RADAR =
            RadarSettings.at(new Position(0, 0, 0), BUDGET).withFieldOfView(rad(178), rad(40));

    private static double rad(double degrees) {
        return Math.toRadians(degrees);
    }

    /** Half power at half the width, -12 dB at the width, both planes together, and the side lobes beyond. */
    @ParameterizedTest
    @CsvSource({
        "0, 0, 0",
        "1.5, 0, -3",
        "-1.5, 0, -3",
        "0, 5, -3",
        "3, 0, -12",
        "1.5, -5, -6",
        "6, 0, -25",
        "180, 0, -25",
        "358.5, 0, -3"
    })
    void aBeamThatStaysHasTheShapeOfThePattern(double azimuth, double elevation, double gain) {
        BeamPattern fixed = BEAM.withSteering(Steering.NONE).withSideLobes(25);
        Direction there = new Direction(rad(azimuth), rad(elevation));
        assertThat(fixed.gain(NORTH, there, there)).isCloseTo(gain, within(1e-9));
    }

    /**
     * Across the zenith: a beam at 80 deg of elevation, and a drone behind it at 80 deg, are 20 deg apart, half of the
     * width, though their azimuths differ by 180 deg.
     */
    @Test
    void nearTheZenithAzimuthsAreShort() {
        BeamPattern round = BeamPattern.of(rad(40), rad(40)).withSteering(Steering.NONE);
        Direction axis = new Direction(rad(30), rad(80));
        Direction behind = new Direction(rad(210), rad(80));
        assertThat(round.gain(axis, behind, behind)).isCloseTo(-3.0, within(1e-9));
        BeamPattern fan = round.withSteering(Steering.AZIMUTH).withScanLoss(0);
        assertThat(fan.gain(axis, behind, axis)).isCloseTo(-3.0, within(1e-9));
        Direction up = new Direction(0, 0.5 * Math.PI);
        for (int azimuth = 0; azimuth < 360; azimuth += 90) {
            Direction seen = new Direction(rad(azimuth), rad(70));
            assertThat(round.gain(up, seen, seen)).as("%d", azimuth).isCloseTo(-3.0, within(1e-9));
        }
    }

    /** A beam that stays has the pattern of a radio receiver's antenna with the same aim and the same widths. */
    @Test
    void radarsAndRadioReceiversShareThePattern() {
        BeamPattern beam = BeamPattern.of(rad(50), rad(25)).withSteering(Steering.NONE);
        AntennaPattern antenna = AntennaPattern.of(rad(50), rad(25));
        SplittableRandom random = new SplittableRandom(SEED);
        for (int i = 0; i < 1000; i++) {
            Direction axis = new Direction(random.nextDouble(-4, 4), random.nextDouble(-1.57, 1.57));
            Direction seen = axis.turned(random.nextDouble(-0.5, 0.5), random.nextDouble(-0.3, 0.3));
            assertThat(beam.gain(axis, seen, seen))
                    .as("seed %d, pair %d", SEED, i)
                    .isCloseTo(antenna.gain(axis.unit(), seen.unit()), within(1e-9));
        }
    }

    /** {@code cos(60 deg)^1.5}: -4.515 dB one way, 0.595 of the range. */
    @Test
    void anArrayLosesGainAsItLooksAside() {
        Direction aside = new Direction(rad(60), 0);
        assertThat(BEAM.gain(NORTH, aside, aside)).isCloseTo(-4.5154, within(1e-4));
        assertThat(BEAM.gain(NORTH, new Direction(0, rad(60)), new Direction(0, rad(60))))
                .isCloseTo(-4.5154, within(1e-4));
        assertThat(BEAM.withScanLoss(0).gain(NORTH, aside, aside)).isZero();
        assertThat(BEAM.withScanLoss(1).gain(NORTH, aside, aside)).isCloseTo(-3.0103, within(1e-4));
        double behind = BEAM.gain(NORTH, new Direction(Math.PI, 0), new Direction(Math.PI, 0));
        assertThat(behind).isCloseTo(-45.0, within(1e-9));
    }

    /** The angle from the axis is that between two directions, whatever their elevations. */
    @Test
    void aTiltedArrayLosesGainByTheAngleFromItsAxis() {
        SplittableRandom random = new SplittableRandom(SEED);
        for (int i = 0; i < 1000; i++) {
            Direction axis = new Direction(random.nextDouble(-4, 4), random.nextDouble(-1.2, 1.2));
            Direction aside = axis.turned(random.nextDouble(-0.5, 0.5), random.nextDouble(-0.3, 0.3));
            assertThat(BEAM.gain(axis, aside, aside))
                    .as("seed %d, pair %d", SEED, i)
                    .isCloseTo(15 * Math.log10(axis.unit().dot(aside.unit())), within(1e-9));
        }
    }

    /** Steered in azimuth alone, it is a fan: full gain at any azimuth, the pattern in elevation. */
    @Test
    void aFanIsSteeredInAzimuthOnly() {
        BeamPattern fan = BEAM.withSteering(Steering.AZIMUTH).withScanLoss(0);
        Direction there = new Direction(rad(70), rad(5));
        assertThat(fan.gain(NORTH, there, there)).isCloseTo(-3.0, within(1e-9));
        assertThat(fan.gain(NORTH, there, new Direction(rad(71.5), rad(5)))).isCloseTo(-6.0, within(1e-9));
    }

    private static Observation echo(RadarSettings radar, Position place) {
        return look(radar, open(), cube(place, place.times(-10 / place.length())), 0);
    }

    @Test
    void anEchoPassesTheBeamTwice() {
        Position aside = new Position(1000 * Math.sin(rad(60)), 1000 * Math.cos(rad(60)), 0);
        double difference =
                echo(RADAR.withBeam(BEAM), aside).value() - echo(RADAR, aside).value();
        assertThat(difference).isCloseTo(2 * 15 * Math.log10(0.5), within(1e-9));
        assertThat(echo(RADAR.withBeam(BEAM), aside).figures().get("beam_gain_db"))
                .isCloseTo(15 * Math.log10(0.5), within(1e-9));
        assertThat(echo(RADAR, aside).figures()).doesNotContainKey("beam_gain_db");
        BeamPattern fan = BEAM.withSteering(Steering.AZIMUTH).withScanLoss(0);
        Position above = new Direction(0, rad(10)).unit().times(1000);
        assertThat(echo(RADAR.withBeam(fan), above).value() - echo(RADAR, above).value())
                .isCloseTo(-24.0, within(1e-9));
    }

    /** A pencil beam at a drone 10 deg up leaves a reflection from the ground 30 dB weaker, which hardly interferes. */
    @Test
    void aNarrowBeamKeepsTheReflectionOut() {
        World flat = World.of(TriangleMesh.of(
                new float[] {-9000, -9000, -10, 9000, -9000, -10, 9000, 9000, -10, -9000, 9000, -10},
                new int[] {0, 1, 2, 0, 2, 3}));
        RadarSettings all = RADAR.withGroundReflection(new ReflectingGround(15, 0, 0));
        RadarSettings narrow = all.withBeam(BeamPattern.of(rad(3), rad(3)).withScanLoss(0));
        double[] wide = IntStream.range(0, 200)
                .mapToDouble(i -> reflection(all, flat, i))
                .toArray();
        double[] beam = IntStream.range(0, 200)
                .mapToDouble(i -> reflection(narrow, flat, i))
                .toArray();
        double deepest = IntStream.range(0, 200)
                .mapToDouble(i -> Math.abs(wide[i]))
                .max()
                .orElseThrow();
        double left = IntStream.range(0, 200)
                .mapToDouble(i -> Math.abs(beam[i]))
                .max()
                .orElseThrow();
        assertThat(deepest).isGreaterThan(5.0);
        // An amplitude of 10^(-30/20) at most, twice: 40 lg(1 + 0.0316).
        assertThat(left).isBetween(0.01, 0.55);
    }

    private static double reflection(RadarSettings radar, World world, int i) {
        Position place = new Position(0, 400 + 0.5 * i, 70);
        Drone drone = cube(place, place.times(-10 / place.length()));
        return look(radar, world, drone, 0).figures().get("ground_reflection_db");
    }

    /** 1 x 1 deg over 180 x 20 deg: 3600 beams, 72 s at 20 ms; the gain of 20 dBi alone would need 9 of them. */
    @Test
    void aScanTakesAsLongAsItsBeamsAreMany() {
        RadarSettings wide = RADAR.withFieldOfView(rad(180), rad(20)).withBudget(new Hardware(4, 20, 0.02, 10e6, 5, 6));
        RadarSettings pencil = wide.withBeam(BeamPattern.of(rad(1), rad(1)));
        assertThat(wide.advice()).isEmpty();
        assertThat(pencil.advice())
                .containsExactly(
                        "a beam of 1 x 1 deg needs 3,600 positions to cover 180 x 20 deg: at an integrationTime"
                                + " of 0.02 s each, a scan takes 72 s, not 1 s; lower the rate to 0.0138 Hz, or the"
                                + " integrationTime to 0.000277 s");
        assertThat(pencil.withRate(0.0138).advice()).isEmpty();
        assertThat(pencil.withBeam(BeamPattern.of(rad(1), rad(20)).withSteering(Steering.AZIMUTH))
                        .advice())
                .hasSize(1)
                .allMatch(text -> text.startsWith("a beam of 1 x 20 deg needs 180 positions to cover 180 x 20 deg"));
        RadarSettings staring =
                pencil.withBeam(BeamPattern.of(rad(180), rad(20)).withSteering(Steering.NONE));
        assertThat(staring.advice()).noneMatch(text -> text.contains("scan"));
        assertThat(staring.withRate(100).advice())
                .anyMatch(text -> text.startsWith("a beam of 180 x 20 deg needs 1 position to cover 180 x 20 deg"));
    }

    @Test
    void aFanMeasuresNoElevation() {
        RadarSettings fan = RADAR.withAim(new Aim.Direction(0, rad(4)))
                .withAccuracy(new Accuracy(0, 0, 0, true).withoutElevation());
        Sighting seen = echo(fan, new Direction(rad(20), rad(12)).unit().times(500))
                .sighting()
                .orElseThrow();
        assertThat(seen.hasElevation()).isFalse();
        assertThat(seen.direction().azimuth()).isCloseTo(rad(20), within(1e-9));
        assertThat(seen.direction().elevation()).isCloseTo(rad(4), within(1e-9));
        assertThat(seen.range().orElseThrow()).isCloseTo(500, within(1e-9));
        assertThat(echo(RADAR, new Position(0, 500, 50))
                        .sighting()
                        .orElseThrow()
                        .hasElevation())
                .isTrue();
    }

    /** A solid angle of 3 x 10 deg has 31.4 dBi at most. */
    @Test
    void aBeamLimitsTheGain() {
        assertThat(BEAM.largestGain()).isCloseTo(10 * Math.log10(41_253.0 / 30), within(1e-3));
        RadarSettings radar = RADAR.withFieldOfView(rad(3), rad(10)).withBeam(BEAM);
        assertThat(radar.advice()).isEmpty();
        assertThat(radar.withBudget(new Hardware(4, 33, 0.02, 10e6, 5, 6)).advice())
                .containsExactly(
                        "an antenna of 33 dBi cannot have a beam of 3 x 10 deg, whose gain is at most 31.3 dBi");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> BEAM.withSideLobes(-1))
                .withMessageContaining("sideLobes -1 dB must be 0 to 100");
    }
}
