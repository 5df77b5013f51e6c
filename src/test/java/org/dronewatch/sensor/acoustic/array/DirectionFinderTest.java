package org.dronewatch.sensor.acoustic.array;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.concurrent.ThreadLocalRandom;
import java.util.function.DoubleUnaryOperator;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Direction;
import org.dronewatch.sensor.acoustic.array.ArraySettings.Shape;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** How accurately arrays find directions. */
class DirectionFinderTest {
    private static final double SOUND = 343.2;
    private static final int SENSORS = 8;
    private static final int SNAPSHOTS = 100;
    private static final double FREQUENCY = 1000.0;

    /** Eight microphones along the x axis, half a wavelength apart. */
    private static final ArraySettings LINE =
            new ArraySettings(SENSORS, (SENSORS - 1) * 0.5 * SOUND / FREQUENCY, Shape.LINE, 0.0, Math.toRadians(90.0));

    private static final Position EAST = new Position(1, 0, 0);

    private static double[] flat(double ratio) {
        double[] ratios = new double[8];
        Arrays.fill(ratios, ratio);
        return ratios;
    }

    /**
     * A uniform line of eight at half a wavelength, 0 dB, 100 snapshots, broadside: 0.199 degrees by the deterministic
     * bound, 0.211 by the stochastic one (P. Stoica and A. Nehorai, 1989 and 1990; the factor between them is 1 + 1 /
     * (N S)).
     */
    @Test
    void boundsOfALine() {
        DirectionFinder finder = new DirectionFinder(LINE, SOUND, 1.0);
        double inverse = finder.information(FREQUENCY, SNAPSHOTS, 1.0) * finder.spread(EAST);
        double stochastic = 1.0 / Math.sqrt(inverse);
        double deterministic = 1.0 / Math.sqrt(inverse * (1.0 + 1.0 / SENSORS));

        assertThat(Math.toDegrees(stochastic)).isCloseTo(0.211, within(0.0005));
        assertThat(Math.toDegrees(deterministic)).isCloseTo(0.199, within(0.0005));
        assertThat(LINE.spacing()).isCloseTo(0.5 * SOUND / FREQUENCY, within(1e-12));
        assertThat(LINE.gain()).isCloseTo(9.03, within(0.005));
        assertThat(Math.toDegrees(LINE.beamwidth(SOUND / FREQUENCY))).isCloseTo(12.69, within(0.01));
    }

    /**
     * An independent estimator, the peak of the beamformer's power (for one source maximum likelihood), scatters as
     * stated.
     */
    @Test
    void aBeamformerReachesTheBound() {
        long seed = ThreadLocalRandom.current().nextLong();
        SplittableRandom random = new SplittableRandom(seed);
        int trials = 400;
        double squares = 0.0;
        for (int trial = 0; trial < trials; trial++) {
            double[][] real = new double[SNAPSHOTS][SENSORS];
            double[][] imaginary = new double[SNAPSHOTS][SENSORS];
            double scale = Math.sqrt(0.5);
            for (int t = 0; t < SNAPSHOTS; t++) {
                double re = scale * random.nextGaussian();
                double im = scale * random.nextGaussian();
                for (int n = 0; n < SENSORS; n++) {
                    real[t][n] = re + scale * random.nextGaussian();
                    imaginary[t][n] = im + scale * random.nextGaussian();
                }
            }
            double estimate = peak(sine -> power(real, imaginary, sine));
            squares += Math.asin(estimate) * Math.asin(estimate);
        }
        double spread = Math.sqrt(squares / trials);
        DirectionFinder finder = new DirectionFinder(LINE, SOUND, 1.0);
        double bound = 1.0 / Math.sqrt(finder.information(FREQUENCY, SNAPSHOTS, 1.0) * finder.spread(EAST));
        assertThat(spread / bound).as("seed %d", seed).isBetween(0.85, 1.2);
    }

    private static double power(double[][] real, double[][] imaginary, double sine) {
        double sum = 0.0;
        for (int t = 0; t < real.length; t++) {
            double re = 0.0;
            double im = 0.0;
            for (int n = 0; n < SENSORS; n++) {
                double phase = -Math.PI * n * sine;
                re += real[t][n] * Math.cos(phase) - imaginary[t][n] * Math.sin(phase);
                im += real[t][n] * Math.sin(phase) + imaginary[t][n] * Math.cos(phase);
            }
            sum += re * re + im * im;
        }
        return sum;
    }

    /** The greatest value within the main lobe, by golden section. */
    private static double peak(DoubleUnaryOperator power) {
        double low = -0.1;
        double high = 0.1;
        double golden = 0.5 * (Math.sqrt(5.0) - 1.0);
        for (int i = 0; i < 40; i++) {
            double left = high - golden * (high - low);
            double right = low + golden * (high - low);
            if (power.applyAsDouble(left) > power.applyAsDouble(right)) {
                high = right;
            } else {
                low = left;
            }
        }
        return 0.5 * (low + high);
    }

    /** The spread of a ring is N R^2 / 2 in its plane and none across it; that of a sphere N R^2 / 3 all round. */
    @Test
    void spreadOfRingAndSphere() {
        ArraySettings sphere = ArraySettings.of(64, 3.4);
        DirectionFinder ofSphere = new DirectionFinder(sphere, SOUND, 0.5);
        DirectionFinder ofRing = new DirectionFinder(sphere.withShape(Shape.RING), SOUND, 0.5);
        double square = 64 * 1.7 * 1.7;
        for (double angle = 0.0; angle < 6.28; angle += 0.3) {
            Position level = new Position(Math.cos(angle), Math.sin(angle), 0);
            assertThat(ofRing.spread(level)).isCloseTo(square / 2, within(1e-9));
            assertThat(ofSphere.spread(level)).isCloseTo(square / 3, within(0.02 * square));
        }
        Position up = new Position(0, 0, 1);
        assertThat(ofRing.spread(up)).isZero();
        assertThat(ofSphere.spread(up)).isCloseTo(square / 3, within(0.02 * square));
        assertThat(sphere.withShape(Shape.RING).spacing()).isCloseTo(3.4 * Math.sin(Math.PI / 64), within(1e-12));
    }

    /** Half the wavelength of 1 kHz is 17.2 cm: bands above are left out for microphones that far apart. */
    @Test
    void ambiguousBandsAreLeftOut() {
        DirectionFinder finder = new DirectionFinder(LINE, SOUND, 0.1);
        double[] low = flat(10.0);
        Arrays.fill(low, 5, 8, Double.NEGATIVE_INFINITY);
        double[] high = flat(10.0);
        Arrays.fill(high, 0, 5, Double.NEGATIVE_INFINITY);

        assertThat(finder.information(flat(10.0))).isEqualTo(finder.information(low));
        assertThat(finder.information(high)).isZero();
        assertThat(finder.information(flat(Double.NEGATIVE_INFINITY))).isZero();
    }

    /**
     * What is measured scatters by the stated errors about the truth, for a sphere and for a ring, near the zenith as
     * well.
     */
    @ParameterizedTest
    @EnumSource(value = Shape.class, names = "LINE", mode = EnumSource.Mode.EXCLUDE)
    void measurementsScatterByTheStatedErrors(Shape shape) {
        long seed = ThreadLocalRandom.current().nextLong();
        SplittableRandom random = new SplittableRandom(seed);
        DirectionFinder finder = new DirectionFinder(ArraySettings.of(32, 0.8).withShape(shape), SOUND, 0.1);
        Position here = new Position(10, 20, 2);
        for (Position drone :
                new Position[] {new Position(110, 20, 60), new Position(0, 320, 80), new Position(12, 22, 90)}) {
            Direction truth = Direction.of(drone.minus(here));
            double bearings = 0.0;
            double elevations = 0.0;
            int count = 2000;
            for (int i = 0; i < count; i++) {
                DirectionFinder.Found found =
                        finder.find(here, drone, flat(-3.0), random).orElseThrow();
                double bearing =
                        Math.IEEEremainder(found.sighting().direction().azimuth() - truth.azimuth(), 2 * Math.PI);
                double elevation = found.sighting().direction().elevation() - truth.elevation();
                bearings += Math.pow(bearing / found.bearingError(), 2);
                elevations += Math.pow(elevation / found.elevationError().orElseThrow(), 2);
                assertThat(found.sighting().range()).isEmpty();
                assertThat(found.sighting().from()).isEqualTo(here);
            }
            assertThat(Math.sqrt(bearings / count)).as("seed %d", seed).isBetween(0.9, 1.1);
            // Next to the zenith elevations are cut off.
            double least = truth.elevation() > Math.toRadians(85.0) ? 0.4 : 0.9;
            assertThat(Math.sqrt(elevations / count)).as("seed %d", seed).isBetween(least, 1.1);
        }
    }

    /** In loud sound the error is that of the array itself, in faint sound that of the bound. */
    @Test
    void theArraysOwnErrorIsAddedInSquares() {
        ArraySettings exact = ArraySettings.of(32, 0.8).withAccuracy(0.0);
        Direction level = new Direction(1.0, 0.0);
        double bound = new DirectionFinder(exact, SOUND, 0.1).bearingError(level, flat(-10.0));
        DirectionFinder finder = new DirectionFinder(exact.withAccuracy(0.01), SOUND, 0.1);

        assertThat(finder.bearingError(level, flat(-10.0))).isCloseTo(Math.hypot(bound, 0.01), within(1e-12));
        assertThat(finder.bearingError(level, flat(90.0))).isCloseTo(0.01, within(1e-6));
        assertThat(Math.toDegrees(ArraySettings.of(32, 0.8).accuracy())).isCloseTo(1.0, within(1e-12));
    }

    /** Straight overhead the bearing is unknown, and the direction is found all the same. */
    @Test
    void overheadTheDirectionIsFound() {
        DirectionFinder finder = new DirectionFinder(ArraySettings.of(32, 0.8), SOUND, 0.1);
        SplittableRandom random = new SplittableRandom(5);
        Position zenith = new Position(0.01, 0, 100);
        for (int i = 0; i < 100; i++) {
            DirectionFinder.Found found = finder.find(new Position(0, 0, 0), zenith, flat(0.0), random)
                    .orElseThrow();
            double off = found.sighting().direction().unit().angle(zenith);
            assertThat(off).isLessThan(6.0 * found.elevationError().orElseThrow());
        }
    }

    @Test
    void whatIsNotMeasured() {
        SplittableRandom random = new SplittableRandom(1);
        Position here = new Position(0, 0, 0);
        Position low = new Position(100, 0, 0.1);
        DirectionFinder ring = new DirectionFinder(ArraySettings.of(8, 0.5).withShape(Shape.RING), SOUND, 0.1);

        assertThat(ring.find(here, low, flat(0.0), random).orElseThrow().elevationError())
                .isEmpty();
        assertThat(ring.find(here, low, flat(0.0), random)
                        .orElseThrow()
                        .sighting()
                        .direction()
                        .elevation())
                .isZero();
        assertThat(ring.find(here, low, flat(Double.NEGATIVE_INFINITY), random)).isEmpty();
        assertThat(ring.find(here, here, flat(0.0), random)).isEmpty();
        assertThat(new DirectionFinder(LINE, SOUND, 0.1).find(here, low, flat(0.0), random))
                .isEmpty();
    }

    @Test
    void limits() {
        assertThatThrownBy(() -> ArraySettings.of(1, 1)).hasMessageContaining("microphones 1 must be 2 to 4096");
        assertThatThrownBy(() -> ArraySettings.of(3, 1)).hasMessage("microphones 3 must be at least 4 for a sphere");
        assertThatThrownBy(() -> ArraySettings.of(8, 0)).hasMessageContaining("aperture");
    }
}
