package org.dronewatch.sound.surface;

/**
 * The Faddeeva function {@code w(z) = exp(-z^2) erfc(-i z)}, by the rational series of J. A. C. Weideman (Computation
 * of the complex error function, SIAM Journal on Numerical Analysis 31, 1497, 1994). Its error is below 1e-12 of
 * {@code |w|} in the upper half plane.
 */
final class Faddeeva {
    private static final double ROOT_PI = Math.sqrt(Math.PI);

    /** The number of terms: with 32 of them the error is about 1e-12, with 40 it is that of rounding. */
    private static final int TERMS = 40;

    /** Weideman's best scale of the mapping from the real axis to the unit circle. */
    private static final double SCALE = Math.sqrt(TERMS / Math.sqrt(2.0));

    private static final double[] COEFFICIENTS = coefficients();

    private Faddeeva() {}

    /**
     * The value at a point.
     *
     * @param z anywhere in the upper half plane; in the lower one, where {@code -Re z^2} is below 700
     */
    static Complex w(Complex z) {
        if (z.im() < 0.0) {
            // w(z) = 2 exp(-z^2) - w(-z)
            return z.times(z).times(-1.0).exp().times(2.0).minus(upper(z.times(-1.0)));
        }
        return upper(z);
    }

    /** The error function of a real number: {@code 1 - exp(-x^2) w(i x)} for x of 0 or more. */
    static double erf(double x) {
        double size = Math.abs(x);
        return Math.copySign(
                1.0 - Math.exp(-size * size) * upper(new Complex(0.0, size)).re(), x);
    }

    private static Complex upper(Complex z) {
        Complex denominator = new Complex(SCALE + z.im(), -z.re());
        Complex mapped = new Complex(SCALE - z.im(), z.re()).over(denominator);
        double re = 0.0;
        double im = 0.0;
        for (int n = TERMS - 1; n >= 0; n--) {
            double next = re * mapped.re() - im * mapped.im() + COEFFICIENTS[n];
            im = re * mapped.im() + im * mapped.re();
            re = next;
        }
        return new Complex(2.0 * re, 2.0 * im)
                .over(denominator)
                .plus(1.0 / ROOT_PI)
                .over(denominator);
    }

    /** Fourier coefficients of {@code exp(-t^2) (L^2 + t^2)} over the angle of {@code t = L tan(angle / 2)}. */
    private static double[] coefficients() {
        int half = 2 * TERMS;
        double[] coefficients = new double[TERMS];
        for (int k = 1 - half; k < half; k++) {
            double angle = k * Math.PI / half;
            double t = SCALE * Math.tan(0.5 * angle);
            double value = Math.exp(-t * t) * (SCALE * SCALE + t * t);
            for (int n = 0; n < TERMS; n++) {
                coefficients[n] += value * Math.cos((n + 1) * angle) / (2.0 * half);
            }
        }
        return coefficients;
    }
}
