package org.dronewatch.sound.surface;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FaddeevaTest {

    /** Values of the test of SciPy's {@code wofz}, computed there with WolframAlpha; all but those beyond 1e280. */
    @ParameterizedTest
    @CsvSource({
        "624.2, -0.26123, -3.78270245518980507e-7, 0.000903861276433172057",
        "-0.4, 3, 0.176490622700481685, -0.0214655053946845762",
        "0.6, 2, 0.241025071577269215, 0.0608757966342808975",
        "-1, 1, 0.304744205256912592, -0.208218938202831627",
        "-1, -9, 7.31713106897237810e34, 8.32187349971440278e34",
        "-1, 9, 0.0615698507236323686, -0.00676005783716575013",
        "-0.0000000234545, 1.1234, 0.396079300769987492, -5.59315225911664492e-9",
        "-3, 5.1, 0.0821719922673944794, -0.0470129108764360990",
        "-53, 30.1, 0.00457246000350281641, -0.00804900791411691822",
        "0, 0.12345, 0.874634285960805267, 0",
        "11, 1, 0.00468190164965444174, 0.0510735563901306198",
        "-22, -2, -0.00231931751876206209, -0.0254600547397315560",
        "1e5, 1e5, 2.82094791780930513e-6, 2.82094791766825774e-6",
        "1e14, 1e14, 2.82094791773878143e-15, 2.82094791773878143e-15"
    })
    void agreesWithPublishedValues(double x, double y, double re, double im) {
        Complex w = Faddeeva.w(new Complex(x, y));
        double tolerance = 1e-10 * Math.hypot(re, im);
        assertThat(w.re()).isCloseTo(re, within(tolerance));
        assertThat(w.im()).isCloseTo(im, within(tolerance));
    }

    /** On the imaginary axis and through the point zero: the integral that defines w, by Simpson's rule. */
    @Test
    void isTheIntegralThatDefinesIt() {
        SplittableRandom random = new SplittableRandom(41);
        for (int i = 0; i < 200; i++) {
            double x = random.nextDouble(-6.0, 6.0);
            double y = random.nextDouble(0.3, 6.0);
            // w(z) = 1/sqrt(pi) of the integral of exp(-t^2/4 - y t + i x t) over t from 0 on
            int steps = 20_000;
            double end = 14.0;
            double h = end / steps;
            double re = 0.0;
            double im = 0.0;
            for (int n = 0; n <= steps; n++) {
                double t = n * h;
                double weight = n == 0 || n == steps ? 1.0 : n % 2 == 1 ? 4.0 : 2.0;
                double size = weight * Math.exp(-0.25 * t * t - y * t);
                re += size * Math.cos(x * t);
                im += size * Math.sin(x * t);
            }
            double factor = h / 3.0 / Math.sqrt(Math.PI);
            Complex w = Faddeeva.w(new Complex(x, y));
            assertThat(w.re()).as("seed 41, %f + %f i", x, y).isCloseTo(factor * re, within(1e-11));
            assertThat(w.im()).as("seed 41, %f + %f i", x, y).isCloseTo(factor * im, within(1e-11));
        }
    }

    /** Abramowitz and Stegun, table 7.1. */
    @ParameterizedTest
    @CsvSource({
        "0, 0",
        "0.1, 0.1124629160",
        "0.5, 0.5204998778",
        "1, 0.8427007929",
        "2, 0.9953222650",
        "-1, -0.8427007929"
    })
    void givesTheErrorFunction(double x, double erf) {
        assertThat(Faddeeva.erf(x)).isCloseTo(erf, within(6e-11));
    }
}
