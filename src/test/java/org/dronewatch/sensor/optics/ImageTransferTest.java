package org.dronewatch.sensor.optics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ImageTransferTest {
    private static final double GREEN = 0.55e-6;

    private static Lens lens(double aperture) {
        return new Lens(OptionalDouble.of(aperture), GREEN);
    }

    /**
     * Goodman's closed form (Introduction to Fourier Optics, section 6.3) at fractions x of the cutoff:
     * {@code 2/pi (acos x - x sqrt(1 - x^2))}, at one half 2/3 - sqrt(3)/(2 pi) = 0.39100; 0 from the cutoff on.
     */
    @ParameterizedTest
    @CsvSource({"0, 1", "0.25, 0.68504", "0.5, 0.39100", "0.75, 0.14429", "1, 0", "1.5, 0"})
    void diffractionTakesFineDetail(double ofCutoff, double left) {
        assertThat(lens(0.03).transfer(ofCutoff * 0.03 / GREEN)).isCloseTo(left, within(5.1e-6));
    }

    /** The transfer function of a round aperture is how much two copies of it overlap: brute force over a grid. */
    @Test
    void diffractionIsTheOverlapOfTwoApertures() {
        int steps = 1500;
        for (double shift : new double[] {0.1, 0.37, 0.8}) {
            long one = 0;
            long both = 0;
            for (int i = 0; i < steps; i++) {
                double x = (i + 0.5) / steps - 0.5;
                for (int j = 0; j < steps; j++) {
                    double y = (j + 0.5) / steps - 0.5;
                    boolean inside = x * x + y * y < 0.25;
                    one += inside ? 1 : 0;
                    both += inside && (x - shift) * (x - shift) + y * y < 0.25 ? 1 : 0;
                }
            }
            assertThat(lens(0.05).transfer(shift * 0.05 / GREEN)).isCloseTo((double) both / one, within(1e-3));
        }
    }

    @Test
    void withoutBlurTheStraightLineIsLeftExactly() {
        SplittableRandom random = new SplittableRandom(20261124);
        for (int i = 0; i < 1000; i++) {
            double seen = random.nextDouble();
            double needed = random.nextDouble();
            double expected = seen > needed ? 1.0 - needed / seen : 0.0;
            assertThat(ImageTransfer.through(Lens.perfect(GREEN), 0.0, 500.0).resolved(needed, seen, 1000.0))
                    .as("seed 20261124, number %d", i)
                    .isEqualTo(expected);
        }
    }

    /** The last step of a fine staircase at which the contrast left is still enough. */
    @Test
    void whatIsResolvedIsWhereContrastAndNeedMeet() {
        SplittableRandom random = new SplittableRandom(71);
        int steps = 20_000;
        for (int i = 0; i < 40; i++) {
            double needed = 0.05 * random.nextDouble() + 1e-4;
            double seen = needed + random.nextDouble();
            double focalLength = Math.pow(10.0, 3.0 + 2.0 * random.nextDouble());
            ImageTransfer transfer = ImageTransfer.through(
                    lens(0.01 + 0.1 * random.nextDouble()), Math.pow(10.0, -15.0 + 3.0 * random.nextDouble()), 1000.0);
            int last = 0;
            for (int step = 0; step < steps; step++) {
                double u = (double) step / steps;
                double left = seen * transfer.transfer(0.5 * focalLength * u);
                last = left >= needed / (1.0 - u) ? step : last;
            }
            assertThat(transfer.resolved(needed, seen, focalLength))
                    .as("seed 71, number %d", i)
                    .isCloseTo((double) last / steps, within(1.0 / steps));
        }
    }

    /** Weak blur costs little: no step where an aperture or turbulence is stated for the first time. */
    @Test
    void littleBlurCostsLittle() {
        double none = ImageTransfer.through(Lens.perfect(GREEN), 0.0, 700.0).resolved(0.02, 0.4, 50_000.0);

        assertThat(ImageTransfer.through(lens(1000.0), 1e-19, 700.0).resolved(0.02, 0.4, 50_000.0))
                .isLessThan(none)
                .isCloseTo(none, within(1e-3));
    }

    /**
     * 27 mm at 2.2 degrees over 1920 pixels: the cutoff of diffraction, a line pair in 1.02 pixels, lies beyond what
     * pixels can show, but the blur takes part of the contrast of the finest detail.
     */
    @Test
    void everyBlurTakesDetail() {
        double focalLength = 960.0 / Math.tan(Math.toRadians(1.1));
        double sharp = ImageTransfer.through(Lens.perfect(GREEN), 0.0, 723.0).resolved(0.02, 0.43, focalLength);
        double diffracted = ImageTransfer.through(lens(0.027), 0.0, 723.0).resolved(0.02, 0.43, focalLength);
        double weak = ImageTransfer.through(lens(0.027), 1e-14, 723.0).resolved(0.02, 0.43, focalLength);
        double strong = ImageTransfer.through(lens(0.027), 1e-13, 723.0).resolved(0.02, 0.43, focalLength);

        assertThat(sharp).isCloseTo(0.9535, within(1e-4));
        assertThat(diffracted).isBetween(0.85, sharp);
        assertThat(weak).isBetween(0.75, diffracted);
        assertThat(strong).isBetween(0.5, 0.65);
    }

    @Test
    void whatHasNoContrastIsNotResolved() {
        ImageTransfer transfer = ImageTransfer.through(lens(0.05), 1e-14, 500.0);

        assertThat(transfer.resolved(0.02, 0.02, 1000.0)).isZero();
        assertThat(transfer.resolved(0.02, 0.0, 1000.0)).isZero();
        assertThat(transfer.resolved(0.02, Double.NaN, 1000.0)).isZero();
        assertThat(transfer.resolved(1e-300, 1.0, 1e9)).isBetween(0.0, 1e-3);
    }

    /**
     * The Airy pattern of a round aperture, added up over a square pixel; the wavelength over the diameter in pixels.
     */
    @ParameterizedTest
    @ValueSource(doubles = {0.3, 0.6, 1.0, 2.0, 5.0})
    void aPixelReceivesItsPartOfTheAiryPattern(double spread) {
        int steps = 200;
        double sum = 0.0;
        for (int i = 0; i < steps; i++) {
            double x = (i + 0.5) / steps / 2.0;
            for (int j = 0; j < steps; j++) {
                double v = Math.PI * Math.hypot(x, (j + 0.5) / steps / 2.0) / spread;
                double amplitude = 2.0 * firstBessel(v) / v;
                sum += amplitude * amplitude / steps / steps;
            }
        }
        // The pattern's integral over the plane is 4 / pi times the square of wavelength over diameter.
        double expected = sum * Math.PI / 4.0 / (spread * spread);
        double focalLength = 1000.0;
        double aperture = GREEN / (spread / focalLength);

        assertThat(ImageTransfer.through(lens(aperture), 0.0, 100.0).ensquaredEnergy(focalLength))
                .isCloseTo(expected, within(0.002));
    }

    /** Bessel's J1 by its integral over half a turn. */
    private static double firstBessel(double x) {
        int steps = 60;
        double sum = 0.0;
        for (int i = 0; i < steps; i++) {
            double angle = (i + 0.5) * Math.PI / steps;
            sum += Math.cos(angle - x * Math.sin(angle));
        }
        return sum / steps;
    }

    @Test
    void theLessBlurTheMoreLightOnOnePixel() {
        double last = 1.0;
        for (double cn2 = 1e-19; cn2 < 1e-11; cn2 *= 3.0) {
            double now = ImageTransfer.through(Lens.perfect(GREEN), cn2, 700.0).ensquaredEnergy(50_000.0);
            assertThat(now).as("Cn2 %g", cn2).isBetween(0.0, last + 0.01);
            last = Math.min(last, now);
        }
        assertThat(last).isLessThan(0.01);
        assertThat(ImageTransfer.through(Lens.perfect(GREEN), 0.0, 700.0).ensquaredEnergy(50_000.0))
                .isEqualTo(1.0);
        assertThat(ImageTransfer.through(lens(10.0), 1e-22, 700.0).ensquaredEnergy(1000.0))
                .isCloseTo(1.0, within(0.01));
    }
}
