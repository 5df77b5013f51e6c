package org.dronewatch.sensor.radio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Two waves over flat ground, over a slope, and where there is no reflection. */
class TwoRaysTest {
    private static final int RANGES = 4001;

    /** Ground that rises to the north. */
    private static World ground(double rise) {
        float high = (float) (9000 * rise);
        return World.of(TriangleMesh.of(
                new float[] {-9000, -9000, -high, 9000, -9000, -high, 9000, 9000, high, -9000, 9000, high},
                new int[] {0, 1, 2, 0, 2, 3}));
    }

    private static double[] factors(double frequency, double low, double high, double roughness) {
        return factors(frequency, low, high, new ReflectingGround(15, 0, roughness));
    }

    private static double[] factors(double frequency, double low, double high, ReflectingGround surface) {
        TwoRays rays = new TwoRays(ground(0), surface);
        return IntStream.range(0, RANGES)
                .mapToDouble(i -> {
                    double range = 1000 + 2000.0 * i / (RANGES - 1);
                    return rays.factor(
                            new Position(0, 0, low), new Position(0, range, high), frequency, false, way -> true);
                })
                .sorted()
                .toArray();
    }

    /**
     * Ranges evenly from 1 to 3 km, relative permittivity 15. The figures are quantiles of the closed form
     * {@link #overFlatGround}: 11.55, 4.53 and -20.25 dB.
     */
    @Test
    void aRadarOverFlatGround() {
        double[] all = factors(10.3e9, 10, 30, 0.05);
        double[] closed = closedForm(range -> overFlatGround(10.3e9, 10, 30, range, 0.05));
        assertThat(all).containsExactly(closed, within(1e-4));
        assertThat(2 * all[RANGES - 1]).isCloseTo(11.5, within(0.3));
        assertThat(2 * all[RANGES / 2]).isCloseTo(4.5, within(0.3));
        assertThat(2 * all[RANGES / 10]).isCloseTo(-20.0, within(0.3));
    }

    /**
     * The field over a plane by the method of images (Kerr, Propagation of Short Radio Waves, sections 2.1 and 5.2),
     * from the exact lengths of both paths, with Fresnel's coefficient for horizontal polarisation and permittivity 15,
     * {@code (sin a - w) / (sin a + w)}, {@code w = sqrt(15 - cos^2 a)}, and Ament's factor of roughness,
     * {@code exp(-8 (pi s sin a / lambda)^2)}, dB.
     */
    private static double overFlatGround(double frequency, double low, double high, double range, double roughness) {
        double direct = Math.hypot(range, high - low);
        double reflected = Math.hypot(range, high + low);
        double sine = (high + low) / reflected;
        return interference(frequency, direct, reflected, sine, roughness, 1.0);
    }

    private static double interference(
            double frequency, double direct, double reflected, double sine, double roughness, double divergence) {
        double lambda = 299_792_458.0 / frequency;
        double w = Math.sqrt(15 - (1 - sine * sine));
        double strength = divergence
                * direct
                / reflected
                * Math.exp(-8 * Math.pow(Math.PI * roughness * sine / lambda, 2))
                * (sine - w)
                / (sine + w);
        double phase = 2 * Math.PI * (reflected - direct) / lambda;
        return 20 * Math.log10(Math.hypot(1 + strength * Math.cos(phase), strength * Math.sin(phase)));
    }

    private static double[] closedForm(DoubleUnaryOperator atRange) {
        return IntStream.range(0, RANGES)
                .mapToDouble(i -> atRange.applyAsDouble(1000 + 2000.0 * i / (RANGES - 1)))
                .sorted()
                .toArray();
    }

    /**
     * The same with 4/3 of the earth's radius and divergence, against {@link #overASphere}: 11.513, 4.20 and -20.02 dB.
     * The program's path lengths are expanded in height over radius, which moves the lobes by less than a step of half
     * a metre.
     */
    @Test
    void aRadarOverARoundEarth() {
        double[] all = factors(10.3e9, 10, 30, new ReflectingGround(15, 0, 0.05, true));
        double[] closed = closedForm(range -> overASphere(10.3e9, 10, 30, range, 0.05));
        assertThat(all[RANGES - 1]).isCloseTo(closed[RANGES - 1], within(0.001));
        assertThat(all[RANGES / 2]).isCloseTo(closed[RANGES / 2], within(0.02));
        assertThat(all[RANGES / 10]).isCloseTo(closed[RANGES / 10], within(0.05));
        assertThat(2 * closed[RANGES / 2]).isCloseTo(4.2, within(0.05));
    }

    /**
     * The field over a sphere of 4/3 of the earth's radius, in the plane of the path: the point of reflection is where
     * both legs, straight lines by the law of cosines, have the same elevation above the tangent, found by halving.
     * Divergence by Kerr, section 2.2.
     */
    private static double overASphere(double frequency, double low, double high, double range, double roughness) {
        double radius = RoundEarth.RADIUS;
        double arc = range / radius;
        double nearest = 0;
        double farthest = arc;
        for (int i = 0; i < 60; i++) {
            double middle = 0.5 * (nearest + farthest);
            boolean isSteeper = sine(low, middle) > sine(high, arc - middle);
            nearest = isSteeper ? middle : nearest;
            farthest = isSteeper ? farthest : middle;
        }
        double first = leg(low, nearest);
        double second = leg(high, arc - nearest);
        double sine = sine(low, nearest);
        double direct = Math.sqrt(
                Math.pow(high - low, 2) + 4 * (radius + low) * (radius + high) * Math.pow(Math.sin(0.5 * arc), 2));
        double divergence = 1 / Math.sqrt(1 + 2 * first * second / (radius * (first + second) * sine));
        return interference(frequency, direct, first + second, sine, roughness, divergence);
    }

    /** From a height to the surface at an angle about the earth's centre, m. */
    private static double leg(double height, double angle) {
        double half = Math.sin(0.5 * angle);
        return Math.sqrt(height * height + 4 * RoundEarth.RADIUS * (RoundEarth.RADIUS + height) * half * half);
    }

    private static double sine(double height, double angle) {
        double half = Math.sin(0.5 * angle);
        return (height - 2 * (RoundEarth.RADIUS + height) * half * half) / leg(height, angle);
    }

    /** Beyond the horizon of both, 23.3 km, there is no reflection; the difference in length vanishes towards it. */
    @Test
    void beyondTheHorizonNothingIsReflected() {
        World sea = World.of(TriangleMesh.of(
                new float[] {-9, -9, 0, 9, -9, 0, 9, 40_000, 0, -9, 40_000, 0}, new int[] {0, 1, 2, 0, 2, 3}));
        TwoRays rays = new TwoRays(sea, new ReflectingGround(80, 5, 0, true));
        double horizon = Math.sqrt(2 * RoundEarth.RADIUS * 4) + Math.sqrt(2 * RoundEarth.RADIUS * 16);
        Position from = new Position(0, 0, 4);
        assertThat(rays.factor(from, new Position(0, horizon + 100, 16), 1e10, false, way -> true))
                .isZero();
        assertThat(rays.factor(from, new Position(0, horizon - 1500, 16), 1e10, false, way -> true))
                .isNotZero();
    }

    /** By the same closed form, smooth and one way: 5.96 and -10.78 dB. */
    @Test
    void aReceiverOverFlatGround() {
        double[] all = factors(2.4e9, 10, 50, 0);
        double[] closed = closedForm(range -> overFlatGround(2.4e9, 10, 50, range, 0));
        assertThat(all).containsExactly(closed, within(1e-4));
        assertThat(all[RANGES - 1]).isCloseTo(6.0, within(0.3));
        assertThat(all[RANGES / 10]).isCloseTo(-10.6, within(0.3));
    }

    /** Fresnel's coefficients: both polarisations alike at right angles, vertical ones vanish at Brewster's angle. */
    @Test
    void fresnelsCoefficientsHaveTheirLimits() {
        ReflectingGround smooth = new ReflectingGround(15, 0, 0);
        double upright = (Math.sqrt(15) - 1) / (Math.sqrt(15) + 1);
        double wavelength = 0.3;
        double frequency = 299_792_458.0 / wavelength;
        // Half a wavelength more turns the sign of the reflected wave.
        assertThat(smooth.factor(1e9, 0.15, Math.PI / 2, 0, frequency, false, 1))
                .isCloseTo(20 * Math.log10(1 + upright), within(1e-6));
        assertThat(smooth.factor(1e9, 0, Math.PI / 2, 0, frequency, true, 1))
                .isCloseTo(20 * Math.log10(1 + upright), within(1e-6));
        double brewster = Math.atan(1 / Math.sqrt(15));
        assertThat(smooth.factor(1e9, 0.1, brewster, 0, frequency, true, 1)).isCloseTo(0, within(1e-9));
        assertThat(smooth.factor(1e9, 0.15, 1e-6, 0, frequency, false, 1)).isCloseTo(6.0206, within(1e-4));
    }

    /** At {@code pi h sin(psi) / lambda} of one eighth's root the reflected field falls by the factor e. */
    @Test
    void aRoughSurfaceScatters() {
        double wavelength = 299_792_458.0 / 10e9;
        double grazing = 0.05;
        double height = wavelength / (Math.PI * Math.sin(grazing) * Math.sqrt(8));
        ReflectingGround smooth = new ReflectingGround(15, 0, 0);
        double coherent = Math.pow(10, smooth.factor(1e9, wavelength / 2, grazing, 0, 10e9, false, 1) / 20) - 1;
        double expected = 20 * Math.log10(1 + coherent / Math.E);
        assertThat(smooth.factor(1e9, wavelength / 2, grazing, height, 10e9, false, 1))
                .isCloseTo(expected, within(1e-6));
        assertThat(smooth.withRoughness(height).factor(1e9, wavelength / 2, grazing, 0, 10e9, false, 1))
                .isCloseTo(expected, within(1e-6));
    }

    /** Over a slope it is as over level ground with everything turned. */
    @ParameterizedTest
    @CsvSource({"0.02", "-0.03", "0.1"})
    void aSlopeIsLevelGroundTurned(double rise) {
        double angle = Math.atan(rise);
        TwoRays level = new TwoRays(ground(0), new ReflectingGround(15, 0, 0));
        TwoRays sloping = new TwoRays(ground(rise), new ReflectingGround(15, 0, 0));
        for (double range = 300; range < 2000; range += 37) {
            Position from = new Position(0, 0, 10);
            Position to = new Position(0, range, 40);
            double flat = level.factor(from, to, 1e9, false, way -> true);
            double turned = sloping.factor(turn(from, angle), turn(to, angle), 1e9, false, way -> true);
            assertThat(turned).as("range %f", range).isCloseTo(flat, within(0.05));
        }
    }

    private static Position turn(Position p, double angle) {
        return new Position(
                p.x(),
                p.y() * Math.cos(angle) - p.z() * Math.sin(angle),
                p.y() * Math.sin(angle) + p.z() * Math.cos(angle));
    }

    @Test
    void withoutAReflectionItIsFreeSpace() {
        Position from = new Position(0, 0, 10);
        Position to = new Position(0, 500, 30);
        TwoRays rays = new TwoRays(ground(0), ReflectingGround.DEFAULT);
        assertThat(rays.factor(from, to, 1e9, false, way -> true)).isNotZero();
        assertThat(rays.factor(from, to, 1e9, false, way -> way.z() > 0)).isZero();
        assertThat(rays.factor(from, new Position(0, 20_000, 30), 1e9, false, way -> true))
                .isZero();
        assertThat(rays.factor(from, new Position(0, 0, 50), 1e9, false, way -> true))
                .isZero();
    }

    private static World walled(float north, float top) {
        TriangleMesh wall = TriangleMesh.of(
                new float[] {-9000, north, 0, 9000, north, 0, 9000, north, top, -9000, north, top},
                new int[] {0, 1, 2, 0, 2, 3});
        return World.of(World.merge(List.of(ground(0).mesh(), wall)));
    }

    /** A wall of 12 m, where the leg from an antenna at 10 m is 2.1 m above the ground, leaves J(v) of it. */
    @Test
    void aWallInALegTakesWhatAnEdgeTakes() {
        Position from = new Position(0, 0, 10);
        Position to = new Position(0, 500, 30);
        // The reflection is 125 m away; the legs meet 0.1 m above it.
        double length = Math.hypot(125, 9.9);
        double over = (100 * 9.9 + 125 * 2) / length;
        double near = (100 * 125 - 2 * 9.9) / length;
        double v = over * Math.sqrt(2 * length / (0.299792458 * near * (length - near)));
        double left = Math.pow(10, -KnifeEdge.loss(v) / 20);
        double direct = from.distance(to);
        double longer = Math.hypot(500, 40) - direct;
        ReflectingGround surface = new ReflectingGround(15, 0.001, 0.05);
        double expected = surface.factor(direct, longer, Math.atan(40.0 / 500), 0, 1e9, false, left);
        assertThat(new TwoRays(walled(100, 12), surface).factor(from, to, 1e9, false, way -> true))
                .isCloseTo(expected, within(0.01));
        assertThat(expected).isBetween(-1.0, -0.1);
    }

    /**
     * A receiver at 20 m, a wall of 6 m 300 m away, a drone that rises 1 km away: the wall comes into the first leg
     * about 26.9 m. Within two millimetres the field must change by less than 0.3 dB of what it is in free
     * space; where the reflection was switched off, it jumped by 5.4 dB.
     */
    @ParameterizedTest
    @CsvSource({"2.4e9, false", "2.4e9, true", "5.8e9, false", "10e9, false"})
    void nothingJumpsWhereAnEdgeRisesIntoALeg(double frequency, boolean isVertical) {
        Position receiver = new Position(0, 0, 20);
        TwoRays rays = new TwoRays(walled(300, 6), new ReflectingGround(15, 0.001, 0.02));
        TwoRays open = new TwoRays(ground(0), new ReflectingGround(15, 0.001, 0.02));
        double before = Double.NaN;
        for (double height = 20; height < 40; height += 0.002) {
            Position drone = new Position(0, 1000, height);
            double decibels = rays.factor(receiver, drone, frequency, isVertical, way -> true);
            double field = Math.pow(10, decibels / 20);
            if (!Double.isNaN(before)) {
                assertThat(field).as("at %f m", height).isCloseTo(before, within(0.035));
            }
            before = field;
        }
        // Far below its legs the wall takes nothing, far above them nearly all.
        Position low = new Position(0, 1000, 15);
        assertThat(rays.factor(receiver, low, 10e9, isVertical, way -> true))
                .isCloseTo(open.factor(receiver, low, 10e9, isVertical, way -> true), within(1e-9));
        assertThat(before).isCloseTo(1, within(0.25));
    }

    /** Behind a wall that hides all of the drone, no reflection makes up for it. */
    @Test
    void inTheShadowNothingIsReflected() {
        TwoRays rays = new TwoRays(walled(500, 60), new ReflectingGround(15, 0.001, 0.02));
        assertThat(rays.factor(new Position(0, 0, 20), new Position(0, 1000, 10), 2.4e9, false, way -> true))
                .isCloseTo(0, within(0.3));
    }

    @Test
    void settingsHaveLimits() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new ReflectingGround(0.5, 0, 0))
                .withMessageContaining("permittivity 0.5 must be 1 to 100");
    }
}
