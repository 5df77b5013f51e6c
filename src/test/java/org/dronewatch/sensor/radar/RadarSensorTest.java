package org.dronewatch.sensor.radar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.RadarSignature;
import org.dronewatch.drone.RadarSignature.Fluctuation;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.radar.LinkBudget.Hardware;
import org.dronewatch.sensor.radar.Rain.Polarisation;
import org.dronewatch.sensor.radio.ReflectingGround;
import org.dronewatch.sensor.radio.TwoRays;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What a radar looks for, what hides from it, and how often it detects. */
class RadarSensorTest {
    private static final long SEED = 5;
    private static final Hardware BUDGET = new Hardware(4, 33, 0.02, 10e6, 0, 0);
    private static final RadarSettings RADAR =
            RadarSettings.at(new Position(0, 0, 0), BUDGET).withWave(16.5e9, Polarisation.HORIZONTAL);
    private static final World OPEN = World.of(wall(-1e6));
    private static final DroneSettings DRONE =
            DroneSettings.of(ModelSettings.of("box"), Hover.at(new Position(0, 0, 0)));

    /** An upright wall of 20 m to both sides, at some way to the north, up to the height 0. */
    private static TriangleMesh wall(double north) {
        float y = (float) north;
        return TriangleMesh.of(
                new float[] {-20, y, -20, 20, y, -20, 20, y, 0, -20, y, 0}, new int[] {0, 1, 2, 0, 2, 3});
    }

    /** A cube of half a metre to each side of its origin. */
    private static KDTree cube() {
        float[] corners = new float[24];
        for (int i = 0; i < 8; i++) {
            for (int axis = 0; axis < 3; axis++) {
                corners[3 * i + axis] = (i >> axis & 1) == 0 ? -0.5F : 0.5F;
            }
        }
        return KDTree.of(TriangleMesh.of(corners, new int[] {0, 1, 2, 1, 2, 3, 4, 5, 6, 5, 6, 7, 0, 1, 5, 2, 3, 7}));
    }

    private static Drone drone(Position place, Position velocity, double heading, RadarSignature signature) {
        return new Drone("drone", DRONE.withRadar(signature), cube()).at(new FlightState(place, velocity, heading));
    }

    private static Drone coming(Position place) {
        return drone(place, place.times(-10 / place.length()), 0, RadarSignature.DEFAULT);
    }

    private static Observation look(RadarSettings radar, World world, Drone drone) {
        return radar.create()
                .observe(world, List.of(drone), Look.of(SEED, "radar", 0, 0))
                .get(0);
    }

    @Test
    void inTheOpenItIsTheRadarEquation() {
        Observation echo = look(RADAR, OPEN, coming(new Position(0, 8000, 0)));
        assertThat(echo.value()).isCloseTo(BUDGET.signalToNoise(16.5e9, 0.01, 8000), within(1e-9));
        assertThat(echo.threshold()).isEqualTo(15.0);
        assertThat(echo.isDetected()).isTrue();
        assertThat(echo.range()).isEqualTo(8000);
        assertThat(look(RADAR, OPEN, coming(new Position(0, 8100, 0))).isDetected())
                .isFalse();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "0     | 1000 | 0    | true",
                "500   | 865  | 0    | true",
                "510   | 860  | 0    | false",
                "-510  | 860  | 0    | false",
                "0     | 1000 | 170  | true",
                "0     | 1000 | 180  | false",
                "0     | 1000 | -180 | false",
                "0     | -1000 | 0   | false",
                "0     | 19   | 0    | false",
                "0     | 21   | 0    | true",
                "0     | 10001 | 0   | false",
            })
    void itLooksWithinItsAnglesAndRanges(double x, double y, double z, boolean seen) {
        RadarSettings sector = RADAR.withFieldOfView(Math.toRadians(60.2), Math.toRadians(20));
        assertThat(look(sector, OPEN, coming(new Position(x, y, z))).value() > Double.NEGATIVE_INFINITY)
                .isEqualTo(seen);
    }

    @Test
    void itIsAimedNoHigherThanItsMountTilts() {
        double limit = Math.toRadians(40);
        RadarSettings tilted = RADAR.withMaxTilt(limit).withAim(new Aim.Direction(1, limit));
        assertThat(tilted.withAim(new Aim.Direction(1, -limit)).maxTilt()).isEqualTo(limit);
        assertThat(tilted.withAim(new Aim.Target(new Position(0, 100, 100 * Math.tan(limit))))
                        .aim())
                .isInstanceOf(Aim.Target.class);
        for (Aim steep : List.of(new Aim.Direction(0, limit + 1e-6), new Aim.Target(new Position(0, 100, -84)))) {
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> tilted.withAim(steep))
                    .withMessageMatching(
                            "aim: elevation -?4\\d.* deg must be -40 deg to 40 deg, the limits of its mount.*");
        }
        assertThatIllegalArgumentException().isThrownBy(() -> tilted.withMaxTilt(Math.toRadians(39)));
    }

    @Test
    void allRoundIsWithoutAGapBehind() {
        for (double azimuth : new double[] {0, Math.PI, -Math.PI, Math.nextUp(Math.PI), 3}) {
            RadarSettings turned = RADAR.withAim(new Aim.Direction(azimuth, 0));
            assertThat(look(turned, OPEN, coming(new Position(0, -1000, 0))).value())
                    .isFinite();
            assertThat(look(turned, OPEN, coming(new Position(1e-12, 1000, 0))).value())
                    .isFinite();
        }
    }

    @Test
    void aTiltedFieldLooksUp() {
        RadarSettings up = RADAR.withAim(new Aim.Direction(0, Math.toRadians(40)));
        assertThat(look(up, OPEN, coming(new Position(0, 1000, 0))).value()).isEqualTo(Double.NEGATIVE_INFINITY);
        assertThat(look(up, OPEN, coming(new Position(0, 1000, 800))).value()).isFinite();
    }

    @ParameterizedTest
    @CsvSource({"0, 0, false", "0, -0.9, false", "0, -1.1, true", "0, 1.1, true", "30, 0, false", "0, -210, false"})
    void itLooksForWhatComesOrGoes(double east, double north, boolean seen) {
        Drone drone = drone(new Position(0, 1000, 0), new Position(east, north, 0), 0, RadarSignature.DEFAULT);
        Observation echo = look(RADAR, OPEN, drone);
        assertThat(echo.value() > Double.NEGATIVE_INFINITY).isEqualTo(seen);
        assertThat(echo.figures()).containsEntry("radial_speed_m_per_s", north);
    }

    @Test
    void anEchoThatLeavesItsRangeCellIsLost() {
        RadarSettings slow = RADAR.withBudget(new Hardware(4, 33, 0.5, 20e6, 0, 0));
        assertThat(slow.budget().migrationSpeed()).isCloseTo(15, within(0.02));
        assertThat(look(slow, OPEN, coming(new Position(0, 1000, 0))).value()).isFinite();
        Drone fast = drone(new Position(0, 1000, 0), new Position(0, -20, 0), 0, RadarSignature.DEFAULT);
        assertThat(look(slow, OPEN, fast).value()).isEqualTo(Double.NEGATIVE_INFINITY);
    }

    /** A wall half-way up to the drone hides its four lower points of nine at first, all of them in the end. */
    @Test
    void whatIsHalfHiddenCountsForThePartThatShows() {
        World walled = World.of(wall(500));
        Observation free = look(RADAR, walled, coming(new Position(0, 1000, 5)));
        Observation half = look(RADAR, walled, coming(new Position(0, 1000, 0.01)));
        Observation none = look(RADAR, walled, coming(new Position(0, 1000, -5)));

        assertThat(free.figures()).containsEntry("visible_share", 1.0);
        assertThat(half.figures()).containsEntry("visible_share", 5.0 / 9.0);
        assertThat(half.value()
                        - look(RADAR, OPEN, coming(new Position(0, 1000, 0.01))).value())
                .isCloseTo(10 * Math.log10(5.0 / 9.0), within(1e-9));
        assertThat(none.value()).isEqualTo(Double.NEGATIVE_INFINITY);
    }

    @Test
    void rainTakesItsShareOnBothWays() {
        Drone drone = coming(new Position(0, 3000, 0));
        double dry = look(RADAR, OPEN, drone).value();
        double wet = look(RADAR, OPEN.withRain(25), drone).value();
        double loss = Rain.attenuation(16.5e9, 25, 0, Polarisation.HORIZONTAL);
        assertThat(dry - wet).isCloseTo(2 * 3000 * loss, within(1e-9)).isGreaterThan(11.8);
    }

    /** Nose towards the radar, its tail, and half-way between two aspects. */
    @ParameterizedTest
    @CsvSource({"180, 0", "0, -3", "90, 6", "270, 2", "135, 3"})
    void theCrossSectionDependsOnTheSideThatShows(double heading, double gain) {
        // Clockwise from the nose: front, right, back, left. With heading 90 the drone flies east, its right is south.
        RadarSignature sides = RadarSignature.DEFAULT.withAspects(List.of(0.0, 6.0, -3.0, 2.0));
        Position place = new Position(0, 1000, 0);
        Position velocity = new Position(0, -10, 0);
        double alike = look(RADAR, OPEN, drone(place, velocity, 0, RadarSignature.DEFAULT))
                .value();
        double side = look(RADAR, OPEN, drone(place, velocity, Math.toRadians(heading), sides))
                .value();
        assertThat(side - alike).isCloseTo(gain, within(1e-9));
    }

    /** Over many looks the share of detections is the probability of the drone's signal-to-noise ratio. */
    @ParameterizedTest
    @CsvSource({"STEADY, 11", "STEADY, 13", "SWERLING_1, 15", "SWERLING_3, 15", "SWERLING_1, 3"})
    void byChanceItDetectsAsOftenAsTheProbabilitySays(Fluctuation fluctuation, double ratio) {
        RadarSettings radar = RADAR.withDetection(RadarDetection.Chance.DEFAULT);
        double range = BUDGET.range(16.5e9, 0.01, ratio);
        RadarSettings far = radar.withRanges(1, 1e6);
        Drone drone = drone(
                new Position(0, range, 0),
                new Position(0, -10, 0),
                0,
                RadarSignature.DEFAULT.withFluctuation(fluctuation));
        RadarSensor sensor = far.create();
        int looks = 20_000;
        int detected = 0;
        for (int i = 0; i < looks; i++) {
            Look look = Look.of(SEED, "radar", i, i);
            detected += sensor.observe(OPEN, List.of(drone), look).get(0).isDetected() ? 1 : 0;
        }
        double expected = Detectability.probability(ratio, 1e-6, fluctuation);
        double chance = 4 * Math.sqrt(expected * (1 - expected) / looks) + 1e-9;
        assertThat((double) detected / looks).as("seed %d", SEED).isCloseTo(expected, within(chance));
    }

    /** Over flat ground 10 m below, the echo is that of the direct wave with the interference of both, twice. */
    @Test
    void theGroundsReflectionInterferesBothWays() {
        World flat = World.of(TriangleMesh.of(
                new float[] {-9000, -9000, -10, 9000, -9000, -10, 9000, 9000, -10, -9000, 9000, -10},
                new int[] {0, 1, 2, 0, 2, 3}));
        ReflectingGround ground = new ReflectingGround(15, 0, 0.05);
        RadarSettings reflected = RADAR.withGroundReflection(ground);
        TwoRays rays = new TwoRays(flat, ground);
        for (double north = 1000; north < 1100; north += 10) {
            Drone drone = coming(new Position(0, north, 20));
            Observation echo = look(reflected, flat, drone);
            double twice = 2 * rays.factor(new Position(0, 0, 0), drone.origin(), 16.5e9, false, way -> true);
            assertThat(echo.value() - look(RADAR, flat, drone).value())
                    .isCloseTo(twice, within(1e-9))
                    .isNotZero();
            assertThat(echo.figures()).containsEntry("ground_reflection_db", twice);
        }
        RadarSettings upwards = reflected.withAim(new Aim.Direction(0, Math.toRadians(10.5)));
        Drone drone = coming(new Position(0, 1000, 20));
        assertThat(look(upwards, flat, drone).figures()).containsEntry("ground_reflection_db", 0.0);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> reflected.withWave(16.5e9, Polarisation.CIRCULAR))
                .withMessageContaining("groundReflection needs the polarisation horizontal or vertical");
    }

    /**
     * 33 dBi over 180 x 20 and 180 x 10 degrees: 174 and 87 beams. At one scan a second 5.75 ms are left for each of
     * 174.
     */
    @Test
    void aScanNeedsTimeForItsBeams() {
        RadarSettings wide = RADAR.withFieldOfView(Math.PI, Math.toRadians(20));
        assertThat(ScanTime.beams(Math.PI, Math.toRadians(20), 33)).isEqualTo(174);
        assertThat(ScanTime.beams(Math.PI, Math.toRadians(10), 33)).isEqualTo(87);
        assertThat(wide.advice())
                .containsExactly(
                        "an antenna of 33 dBi needs at least 174 beams to cover 180 x 20 deg: at an integrationTime"
                                + " of 0.02 s each, a scan takes 3.48 s, not 1 s; lower the rate to 0.287 Hz, or the"
                                + " integrationTime to 0.00574 s");
        assertThat(wide.withRate(0.287).advice()).isEmpty();
        Hardware quick = new Hardware(4, 33, 0.00574, 10e6, 0, 0);
        assertThat(wide.withBudget(quick).advice()).isEmpty();
        // Of 8 km, 5.86 and 7.0 would be left.
        double full = BUDGET.range(16.5e9, 0.01, 15);
        assertThat(8000 * quick.range(16.5e9, 0.01, 15) / full).isCloseTo(5860, within(10.0));
        assertThat(8000 * new Hardware(4, 33, 1.0 / 87, 10e6, 0, 0).range(16.5e9, 0.01, 15) / full)
                .isCloseTo(7000, within(50.0));
        assertThat(wide.withBudget(BUDGET.withReceiveGain(10)).advice()).isEmpty();
        assertThat(wide.withBudget(new LinkBudget.DataSheet(900, 1, 0.9, 1e-6, Fluctuation.STEADY))
                        .withDetection(RadarDetection.Chance.DEFAULT)
                        .advice())
                .isEmpty();
    }

    @Test
    void settingsHaveLimits() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> RADAR.withRanges(500, 400))
                .withMessageContaining("minRange 500.0 m must be below maxRange 400.0 m");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> RADAR.withSpeeds(5, 5))
                .withMessageContaining("minSpeed");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> RADAR.withFieldOfView(7, 1))
                .withMessageContaining("azimuthWidth 401.0705 deg (7 rad) must be 0.01 to 360 deg");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> RADAR.withAim(new Aim.Target(new Position(0, 0, 0))))
                .withMessageContaining("lookAt");
    }
}
