package org.dronewatch.sensor.optics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TurbulenceTest {
    private static final double GREEN = 0.55e-6;

    /**
     * A full HD camera of 2.2 degrees that looks at something 723 m away, by hand (Fried 1966; Goodman, Statistical
     * Optics, section 8.5): k = 2 pi / 0.55 um = 1.1424e7 / m, 0.159 k^2 = 2.075e13, times 1e-14 and 723 m: 150.0,
     * whose power -0.6 is r0 = 49.5 mm; 0.98 x 0.55 um / 49.5 mm = 10.89 urad, and a pixel is 2.2 deg / 1920 = 20.00
     * urad: 0.54 of it. Ten times the turbulence: 10^0.6 = 3.98 times the blur.
     */
    @ParameterizedTest
    @CsvSource({"1e-14, 0.0495, 0.54", "1e-13, 0.01243, 2.2"})
    void aLongLensIsBlurredByPixels(double structure, double coherence, double pixels) {
        Turbulence air = Turbulence.of(structure, GREEN, 723.0);
        double pixel = Math.toRadians(2.2) / 1920.0;

        assertThat(air.coherenceDiameter()).isCloseTo(coherence, within(0.005 * coherence));
        assertThat(air.blur() / pixel).isCloseTo(pixels, within(0.02 * pixels));
    }

    /** The 0.159 of constant turbulence is 0.423 times the mean of (s/L)^(5/3), summed here step by step. */
    @Test
    void aSphericalWaveWeightsTurbulenceNearTheCamera() {
        int steps = 100_000;
        double mean = 0.0;
        for (int i = 0; i < steps; i++) {
            mean += Math.pow((i + 0.5) / steps, 5.0 / 3.0) / steps;
        }
        double range = 1500.0;
        double structure = 3e-14;
        double k = 2.0 * Math.PI / GREEN;
        double integral = Math.pow(0.423 * k * k * structure * range * mean, -0.6);

        assertThat(0.423 * mean).isCloseTo(0.159, within(0.0005));
        assertThat(Turbulence.of(structure, GREEN, range).coherenceDiameter())
                .isCloseTo(integral, within(1e-8 * integral));
    }

    /**
     * The 0.423 and the 3.44 from Kolmogorov's spectrum: the phase structure function is
     * {@code 2.914 k^2 Cn2 L r^(5/3)}, and r0 is where it is {@code 2 (24/5 gamma(6/5))^(5/6)} = 6.884, half of which
     * is the 3.44 of the transfer function.
     */
    @Test
    void theConstantsFollowFromKolmogorov() {
        double gammaOfSixFifths = 0.9181687423997607;
        double atCoherence = 2.0 * Math.pow(24.0 / 5.0 * gammaOfSixFifths, 5.0 / 6.0);

        assertThat(2.914 / atCoherence).isCloseTo(0.423, within(0.0005));
        assertThat(-Math.log(new Turbulence(0.05, GREEN).transfer(0.05 / GREEN)))
                .isCloseTo(0.5 * atCoherence, within(0.005));
    }

    /**
     * The image of a point is the Hankel transform of the transfer function; half its peak lies at 0.488 wavelength /
     * r0.
     */
    @Test
    void aBlurredPointIsAsWideAsTheBlurStates() {
        Turbulence air = new Turbulence(0.02, GREEN);
        double peak = brightness(air, 0.0);

        assertThat(brightness(air, 0.5 * air.blur())).isCloseTo(0.5 * peak, within(0.004 * peak));
        assertThat(brightness(air, 0.45 * air.blur())).isGreaterThan(0.53 * peak);
    }

    private static double brightness(Turbulence air, double angle) {
        double end = 3.0 * air.coherenceDiameter() / air.wavelength();
        int steps = 20_000;
        double sum = 0.0;
        for (int i = 0; i < steps; i++) {
            double frequency = (i + 0.5) * end / steps;
            sum += air.transfer(frequency) * bessel(2.0 * Math.PI * frequency * angle) * frequency;
        }
        return sum;
    }

    /** Bessel's J0 by its integral over half a turn. */
    private static double bessel(double x) {
        int steps = 200;
        double sum = 0.0;
        for (int i = 0; i < steps; i++) {
            sum += Math.cos(x * Math.sin((i + 0.5) * Math.PI / steps));
        }
        return sum / steps;
    }

    /** Blur grows with the 3/5 power of Cn2 and distance, and falls with the fifth root of the wavelength. */
    @Test
    void blurFollowsItsPowers() {
        double blur = Turbulence.of(1e-14, GREEN, 1000.0).blur();

        assertThat(Turbulence.of(4e-14, GREEN, 1000.0).blur() / blur).isCloseTo(Math.pow(4.0, 0.6), within(1e-12));
        assertThat(Turbulence.of(1e-14, GREEN, 3000.0).blur() / blur).isCloseTo(Math.pow(3.0, 0.6), within(1e-12));
        assertThat(Turbulence.of(1e-14, 8.0 * GREEN, 1000.0).blur() / blur)
                .isCloseTo(Math.pow(8.0, -0.2), within(1e-12));
    }

    @Test
    void stillAirAndNoDistanceBlurNothing() {
        for (Turbulence none : new Turbulence[] {
            Turbulence.of(0.0, GREEN, 1000.0), Turbulence.of(1e-13, GREEN, 0.0), Turbulence.of(0.0, GREEN, 0.0)
        }) {
            assertThat(none.coherenceDiameter()).isInfinite();
            assertThat(none.blur()).isZero();
            assertThat(none.transfer(1e6)).isEqualTo(1.0);
        }
    }
}
