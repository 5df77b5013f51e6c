package org.dronewatch.sensor.radar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;
import static org.dronewatch.sensor.Walls.assess;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.look;
import static org.dronewatch.sensor.Walls.open;
import static org.dronewatch.sensor.Walls.wall;

import java.util.List;
import java.util.SplittableRandom;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.radar.BeamPattern.Steering;
import org.dronewatch.sensor.radar.LinkBudget.DataSheet;
import org.dronewatch.sensor.radar.LinkBudget.Hardware;
import org.dronewatch.sensor.radar.Rain.Polarisation;
import org.dronewatch.sensor.radar.SurfaceReflectivity.ConstantGamma;
import org.dronewatch.sensor.radar.SurfaceReflectivity.ConstantSigma0;
import org.dronewatch.sensor.radar.SurfaceReflectivity.LandCover;
import org.dronewatch.sensor.radar.SurfaceReflectivity.LandCover.Cover;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Echoes of the ground and of rain beside those of drones. */
class RadarClutterTest {
    private static final double LIGHT = 299_792_458.0;
    private static final double WIDTH = Math.toRadians(2.5);
    private static final double DEPTH = LIGHT / 20e6;
    private static final Hardware BUDGET = new Hardware(4, 33, 0.02, 10e6, 5, 6);

    /** All of the sphere below it is in its beam at full gain. */
    private static final BeamPattern BEAM =
            BeamPattern.of(WIDTH, Math.toRadians(10)).withSideLobes(0).withScanLoss(0);

    private static final RadarSettings PLAIN = RadarSettings.at(new Position(0, 0, 0), BUDGET)
            .withFieldOfView(2 * Math.PI, Math.PI)
            .withBeam(BEAM);
    private static final World LEVEL = World.of(level(-10));

    private static TriangleMesh level(double height) {
        float z = (float) height;
        return TriangleMesh.of(
                new float[] {-20_000, -20_000, z, 20_000, -20_000, z, 20_000, 20_000, z, -20_000, 20_000, z},
                new int[] {0, 1, 2, 0, 2, 3});
    }

    private static RadarSettings over(SurfaceReflectivity ground, double improvement) {
        return PLAIN.withClutter(Clutter.of(ground, improvement));
    }

    private static Drone coming(double north, double up) {
        Position place = new Position(0, north, up);
        return cube(place, place.times(-10 / place.length()));
    }

    /** The radar cross-section of the clutter, dBsm, from its ratio to the noise. */
    private static double crossSection(RadarSettings radar, World world, Drone drone) {
        double ratio = look(radar, world, drone, 0).figures().get("clutter_to_noise_db");
        double range = drone.origin().distance(radar.position());
        return ratio - BUDGET.signalToNoise(radar.frequency(), 1.0, range);
    }

    /** The area of a cell, {@code R theta c / (2 B)}: at 1 km, 2.5 degrees, 10 MHz and -30 dB -1.84 dBsm. */
    @ParameterizedTest
    @CsvSource({"1000, -30, 0, -1.84", "1000, -30, 40, -41.84", "10000, -30, 0, 8.16", "100, -20, 0, -1.84"})
    void aCellScattersByItsArea(double range, double sigma0, double improvement, double expected) {
        RadarSettings radar = over(new ConstantSigma0(sigma0), improvement);
        assertThat(crossSection(radar, LEVEL, coming(range, 0))).isCloseTo(expected, within(0.005));
    }

    /**
     * Constant gamma: on level ground h below the radar {@code gamma (h / R) R theta c / (2 B)}, the same at all
     * ranges.
     */
    @ParameterizedTest
    @CsvSource({"200", "1000", "9000"})
    void constantGammaGoesWithTheGrazingAngle(double range) {
        double area = 10.0 * WIDTH * DEPTH;
        assertThat(crossSection(over(new ConstantGamma(-13), 0), LEVEL, coming(range, 0)))
                .isCloseTo(-13.0 + 10 * Math.log10(area), within(0.03));
    }

    /** A slope of 20 degrees towards the radar shows the sine of its real grazing angle, not that of level ground. */
    @Test
    void aSlopeShowsItsRealGrazingAngle() {
        double tilt = Math.toRadians(20);
        float rise = (float) (20_000 * Math.tan(tilt));
        World hill = World.of(TriangleMesh.of(
                new float[] {
                    -20_000,
                    -20_000,
                    -10 - rise,
                    20_000,
                    -20_000,
                    -10 - rise,
                    20_000,
                    20_000,
                    -10 + rise,
                    -20_000,
                    20_000,
                    -10 + rise
                },
                new int[] {0, 1, 2, 0, 2, 3}));
        // The plane lies h below the radar, measured at a right angle to it.
        double h = 10 * Math.cos(tilt);
        Position above = new Position(0, 1000 * Math.cos(tilt), 1000 * Math.sin(tilt));
        Drone drone = cube(above, above.times(-0.01));
        double area = h / 1000 * 1000 * WIDTH * DEPTH * Math.cos(tilt);
        assertThat(crossSection(over(new ConstantGamma(-13), 0), hill, drone))
                .isCloseTo(-13.0 + 10 * Math.log10(area), within(0.1));
    }

    /** Gamma at 10 GHz of Nathanson and Long, as MathWorks quotes them; it grows with the root of the frequency. */
    @ParameterizedTest
    @CsvSource({"FLATLAND, -20", "FARMLAND, -15", "WOODS, -15", "WOODED_HILLS, -10", "METROPOLITAN, 0", "MOUNTAINS, 0"})
    void landCoverHasItsGamma(Cover cover, double gamma) {
        LandCover land = new LandCover(cover);
        assertThat(10 * Math.log10(land.crossSection(10e9, 1, 9))).isCloseTo(gamma, within(1e-12));
        assertThat(10 * Math.log10(land.crossSection(24e9, 1, 9)))
                .isCloseTo(gamma + 5 * Math.log10(2.4), within(1e-12));
        assertThat(crossSection(over(land, 30), LEVEL, coming(1000, 0)))
                .isCloseTo(crossSection(over(new ConstantGamma(gamma), 30), LEVEL, coming(1000, 0)), within(1e-9));
    }

    /** What counts is the signal over the sum of noise and clutter, in figures and in the value alike. */
    @ParameterizedTest
    @CsvSource({"500, 40", "2000, 40", "2000, 0", "6000, 20", "2000, 150"})
    void theValueIsSignalOverNoiseAndClutter(double range, double improvement) {
        RadarSettings radar = over(new LandCover(Cover.FARMLAND), improvement);
        Drone drone = coming(range, 0);
        Observation seen = look(radar, LEVEL, drone, 0);
        double signal = BUDGET.signalToNoise(10e9, 0.01, range);
        double clutter = seen.figures().get("clutter_to_noise_db");
        double sum = 1.0 + Math.pow(10, clutter / 10);
        assertThat(seen.value()).isCloseTo(signal - 10 * Math.log10(sum), within(1e-9));
        assertThat(seen.figures().get("signal_to_clutter_db")).isCloseTo(signal - clutter, within(1e-9));
        assertThat(look(PLAIN, LEVEL, drone, 0).value()).isCloseTo(signal, within(1e-9));
        assertThat(look(PLAIN, LEVEL, drone, 0).figures()).doesNotContainKey("clutter_to_noise_db");
    }

    /**
     * Of a radar that is limited by clutter more power is of no use: its miss is too weak, with the margin that is
     * missing.
     */
    @Test
    void aMissInClutterIsTooWeakByItsMargin() {
        RadarSettings radar = over(new LandCover(Cover.METROPOLITAN), 10);
        Drone drone = coming(800, 0);
        assertThat(assess(PLAIN, LEVEL, drone).cause()).isEqualTo(Cause.DETECTED);
        Assessment missed = assess(radar, LEVEL, drone);
        assertThat(missed.cause()).isEqualTo(Cause.TOO_WEAK);
        assertThat(missed.margin()).isCloseTo(look(radar, LEVEL, drone, 0).value() - 15.0, within(1e-12));
        // 0.01 m2 against 10 m x theta x c / 2B and gamma 0 dB, 10 dB suppressed.
        double toClutter = 10 * Math.log10(0.01 / (10 * WIDTH * DEPTH)) + 10;
        assertThat(missed.margin()).isCloseTo(toClutter - 15.0, within(0.2));
        RadarSettings strong = radar.withBudget(new Hardware(4000, 33, 0.02, 10e6, 5, 6));
        assertThat(assess(strong, LEVEL, drone).margin()).isBetween(missed.margin(), missed.margin() + 0.2);
    }

    /** Behind a wall the ground has no echo, and a drone above its shadow is seen as without clutter. */
    @Test
    void whatLiesInTheShadowHasNoEcho() {
        World walled = World.of(World.merge(List.of(level(-10), wall(500, -10, -2))));
        RadarSettings radar = over(new LandCover(Cover.METROPOLITAN), 0);
        Drone drone = coming(1000, 20);
        Observation seen = look(radar, walled, drone, 0);
        assertThat(seen.figures().get("clutter_to_noise_db")).isEqualTo(Double.NEGATIVE_INFINITY);
        assertThat(seen.figures().get("signal_to_clutter_db")).isEqualTo(Double.POSITIVE_INFINITY);
        assertThat(seen.value()).isEqualTo(look(PLAIN, walled, drone, 0).value());
        assertThat(look(radar, LEVEL, drone, 0).value()).isLessThan(seen.value() - 10);
    }

    /** A wall in the cell scatters with its whole face: gamma times its height times the width of the beam. */
    @Test
    void aFaceOfAHouseOutshinesTheGround() {
        World walled = World.of(World.merge(List.of(level(-10), wall(1000, -10, 0))));
        double ground = 10.0 / 1000 * 7.5 * 1000 * WIDTH;
        double face = 10.0 * 1000 * WIDTH;
        // Bearings beside the middle see the wall a little farther away.
        assertThat(crossSection(over(new ConstantGamma(-10), 0), walled, coming(1000, 5)))
                .isCloseTo(-10.0 + 10 * Math.log10(face + ground), within(0.1));
    }

    /**
     * In the middle of an edge: at two of five bearings the cell lies in the shadow, the one in the middle included or
     * not.
     */
    @Test
    void aCellPartlyInShadowCountsInPart() {
        TriangleMesh half = TriangleMesh.of(
                new float[] {-400, 500, -10, -1, 500, -10, -1, 500, 10, -400, 500, 10}, new int[] {0, 1, 2, 0, 2, 3});
        World walled = World.of(World.merge(List.of(level(-10), half)));
        RadarSettings radar = over(new ConstantSigma0(-30), 0);
        Drone drone = coming(1000, 30);
        double whole = crossSection(radar, LEVEL, drone);
        assertThat(crossSection(radar, walled, drone)).isCloseTo(whole + 10 * Math.log10(0.6), within(1e-6));
    }

    /** A beam that looks at a high drone sees the ground through its side lobes; a fan beam on the horizon does not. */
    @Test
    void theGroundIsSeenThroughThePatternOfTheBeam() {
        BeamPattern pencil = BeamPattern.of(WIDTH, Math.toRadians(4)).withScanLoss(0);
        RadarSettings radar =
                over(new LandCover(Cover.FARMLAND), 0).withBeam(pencil).withRanges(1, 5000);
        double level = look(radar, LEVEL, coming(1000, 0), 0).figures().get("clutter_to_noise_db");
        double below = Math.asin(10.0 / 1000);
        for (double up : new double[] {2, 3, 5}) {
            double tilt = Math.toRadians(up);
            Drone drone = cube(new Position(0, 1000 * Math.cos(tilt), 1000 * Math.sin(tilt)), new Position(0, -10, 0));
            double less = 2 * Math.min(30, 12 * Math.pow((tilt + below) / Math.toRadians(4), 2));
            double onAxis = 2 * 12 * Math.pow(below / Math.toRadians(4), 2);
            assertThat(look(radar, LEVEL, drone, 0).figures().get("clutter_to_noise_db") - level)
                    .isCloseTo(onAxis - less, within(0.05));
        }
        RadarSettings fan = radar.withBeam(pencil.withSteering(Steering.AZIMUTH));
        Drone high = cube(new Position(0, 1000, 100), new Position(0, -10, 0));
        Observation aside = look(fan, LEVEL, high, 0);
        assertThat(aside.figures().get("clutter_to_noise_db")).isCloseTo(level, within(0.1));
    }

    /** Ground outside the field of view has no echo: a radar that is tilted upwards loses it. */
    @Test
    void tiltedUpwardsItSeesNoGround() {
        RadarSettings up = over(new LandCover(Cover.METROPOLITAN), 0)
                .withFieldOfView(2 * Math.PI, Math.toRadians(20))
                .withAim(new Aim.Direction(0, Math.toRadians(11)));
        assertThat(look(up, LEVEL, coming(1000, 60), 0).figures().get("clutter_to_noise_db"))
                .isEqualTo(Double.NEGATIVE_INFINITY);
        RadarSettings level = up.withAim(new Aim.Direction(0, 0));
        assertThat(look(level, LEVEL, coming(1000, 60), 0).figures().get("clutter_to_noise_db"))
                .isFinite();
    }

    /** Rain fills {@code pi R^2 theta phi c / (2 B) / (8 ln 2)}; its echo is attenuated as the drone's is. */
    @ParameterizedTest
    @CsvSource({"1000, 5", "3000, 25"})
    void rainFillsTheCell(double range, double rate) {
        World wet = open().withRain(rate);
        RadarSettings radar =
                PLAIN.withClutter(Clutter.of(new ConstantSigma0(-100), 150).withRainImprovement(12));
        Drone drone = coming(range, 0);
        double volume = Math.PI * range * range * WIDTH * Math.toRadians(10) * DEPTH / (8 * Math.log(2));
        double echo = volume * 5.7e-14 * Math.pow(rate, 1.6) / Math.pow(LIGHT / 10e9, 4);
        double loss = 2 * range * Rain.attenuation(10e9, rate, 0, Polarisation.HORIZONTAL);
        Observation seen = look(radar, wet, drone, 0);
        assertThat(seen.figures().get("clutter_to_noise_db"))
                .isCloseTo(BUDGET.signalToNoise(10e9, echo, range) - loss - 12, within(0.02));
        assertThat(seen.figures().get("signal_to_clutter_db"))
                .isCloseTo(10 * Math.log10(0.01 / echo) + 12, within(0.02));
        assertThat(look(radar, open(), drone, 0).figures().get("clutter_to_noise_db"))
                .isEqualTo(Double.NEGATIVE_INFINITY);
    }

    /** A drone that the radar does not look at has no echo, and no clutter beside it. */
    @Test
    void withoutALookThereIsNoClutter() {
        RadarSettings radar = over(new LandCover(Cover.METROPOLITAN), 0);
        Observation far = look(radar, LEVEL, coming(11_000, 0), 0);
        assertThat(far.value()).isEqualTo(Double.NEGATIVE_INFINITY);
        assertThat(far.figures())
                .containsEntry("clutter_to_noise_db", Double.NEGATIVE_INFINITY)
                .containsEntry("signal_to_clutter_db", Double.NEGATIVE_INFINITY);
        // Nearer than half a range cell, the cell begins at the radar.
        assertThat(look(radar.withRanges(0, 100), LEVEL, coming(3, 0), 0).value())
                .isFinite();
    }

    @Test
    void aLookAndAnAssessmentAgreeToTheLastBit() {
        long seed = 11;
        SplittableRandom random = new SplittableRandom(seed);
        World world =
                World.of(World.merge(List.of(level(-10), wall(300, -10, 5)))).withRain(4);
        RadarSettings radar = over(new LandCover(Cover.FARMLAND), 30)
                .withNotch(DopplerFilter.HighPass.of(2))
                .withDetection(RadarDetection.Chance.DEFAULT);
        int detected = 0;
        for (int i = 0; i < 200; i++) {
            Position place =
                    new Position(random.nextDouble(-500, 500), random.nextDouble(10, 3000), random.nextDouble(0, 200));
            Drone drone = cube(place, place.times(-random.nextDouble(0, 5) / place.length()));
            Observation look = look(radar, world, drone, i);
            Assessment one = assess(radar, world, drone);
            assertThat(one.quantity()).as("seed %d", seed).isEqualTo(look.value());
            assertThat(one.probability()).isEqualTo(look.probability());
            detected += one.cause() == Cause.DETECTED ? 1 : 0;
        }
        assertThat(detected).isBetween(20, 180);
    }

    @Test
    void settingsThatContradictEachOtherAreRefused() {
        Clutter farmland = Clutter.of(new LandCover(Cover.FARMLAND), 40);
        RadarSettings bare = RadarSettings.at(new Position(0, 0, 0), BUDGET);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> bare.withClutter(farmland))
                .withMessageContaining("clutter needs a beam");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> PLAIN.withClutter(farmland.withBandwidth(5e6)))
                .withMessageContaining("are mutually exclusive");
        RadarSettings sheet = PLAIN.withBudget(DataSheet.of(1000, 0.01));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> sheet.withClutter(farmland))
                .withMessageContaining("clutter needs a bandwidth");
        RadarSettings stated = sheet.withClutter(farmland.withBandwidth(10e6));
        assertThat(look(stated, LEVEL, coming(900, 0), 0).figures().get("signal_to_clutter_db"))
                .as("whatever the budget")
                .isCloseTo(
                        look(PLAIN.withClutter(farmland), LEVEL, coming(900, 0), 0)
                                .figures()
                                .get("signal_to_clutter_db"),
                        within(1e-9));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> farmland.withImprovement(-1))
                .withMessageContaining("improvement -1 dB must be 0 to 150");
    }
}
