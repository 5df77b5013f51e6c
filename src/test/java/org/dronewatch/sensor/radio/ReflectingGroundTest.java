package org.dronewatch.sensor.radio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** The interference over ground that conducts, against Fresnel's coefficients in their textbook form. */
class ReflectingGroundTest {
    private static final double LIGHT = 299_792_458.0;

    /** A complex number. */
    private record Complex(double re, double im) {
        static Complex polar(double size, double phase) {
            return new Complex(size * Math.cos(phase), size * Math.sin(phase));
        }

        Complex plus(Complex other) {
            return new Complex(re + other.re, im + other.im);
        }

        Complex times(double factor) {
            return new Complex(factor * re, factor * im);
        }

        Complex times(Complex other) {
            return polar(size() * other.size(), phase() + other.phase());
        }

        Complex over(Complex other) {
            return polar(size() / other.size(), phase() - other.phase());
        }

        /** The root with a positive real part. */
        Complex root() {
            return polar(Math.sqrt(size()), 0.5 * phase());
        }

        double size() {
            return Math.hypot(re, im);
        }

        double phase() {
            return Math.atan2(im, re);
        }
    }

    /**
     * The field with Fresnel's coefficients for a time factor of {@code exp(j w t)} and the angle of incidence i from
     * the normal: {@code (cos i - sqrt(e - sin^2 i)) / (cos i + sqrt(e - sin^2 i))} and, for vertical polarisation,
     * {@code (e cos i - sqrt(e - sin^2 i)) / (e cos i + sqrt(e - sin^2 i))}.
     */
    private static double field(
            Complex e, double incidence, boolean isVertical, double strength, double longer, double wavelength) {
        double sine = Math.sin(incidence);
        Complex root = e.plus(new Complex(-sine * sine, 0)).root();
        Complex first = isVertical ? e.times(Math.cos(incidence)) : new Complex(Math.cos(incidence), 0);
        Complex gamma = first.plus(root.times(-1)).over(first.plus(root));
        Complex wave = gamma.times(Complex.polar(strength, -2 * Math.PI * longer / wavelength));
        return 20 * Math.log10(wave.plus(new Complex(1, 0)).size());
    }

    @Test
    void conductingGroundReflectsAsFresnelSays() {
        SplittableRandom random = new SplittableRandom(7);
        for (int i = 0; i < 2000; i++) {
            double frequency = Math.pow(10, random.nextDouble(7.5, 10));
            double wavelength = LIGHT / frequency;
            double permittivity = random.nextDouble(1, 80);
            double conductivity = Math.pow(10, random.nextDouble(-4, 1));
            double roughness = random.nextDouble(0.5) * wavelength;
            double uneven = random.nextDouble(0.5) * wavelength;
            double grazing = random.nextDouble(0.01, Math.PI / 2);
            double direct = random.nextDouble(10, 1000);
            double longer = random.nextDouble(10);
            double share = random.nextDouble();
            boolean isVertical = random.nextBoolean();
            double path = Math.sin(grazing) * Math.PI / wavelength;
            double strength = share
                    * direct
                    / (direct + longer)
                    * Math.exp(-8 * path * path * (roughness * roughness + uneven * uneven));
            Complex e = new Complex(permittivity, -60 * conductivity * wavelength);
            double expected = field(e, Math.PI / 2 - grazing, isVertical, strength, longer, wavelength);

            assertThat(new ReflectingGround(permittivity, conductivity, roughness)
                            .factor(direct, longer, grazing, uneven, frequency, isVertical, share))
                    .as("ground %d", i)
                    .isCloseTo(expected, within(1e-6));
        }
    }

    @Test
    void theShapeOfTheEarthIsASetting() {
        ReflectingGround flat = new ReflectingGround(30, 0.01, 0.1);
        assertThat(flat.withRoundEarth(true)).isEqualTo(new ReflectingGround(30, 0.01, 0.1, true));
        assertThat(flat.withRoundEarth(true).withRoundEarth(false)).isEqualTo(flat);
    }
}
