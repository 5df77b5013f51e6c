package org.dronewatch.sensor;

/** The tail of the normal distribution: how often noise and errors exceed a limit. */
public final class NormalTail {
    /** The continued fraction of the tail converges quickly from here on; below, the series of its complement does. */
    private static final double FAR = 3.0;

    /** Number of levels of the fraction, and of terms of the series: enough for a relative error of 1e-14. */
    private static final int LEVELS = 120;

    private static final double ROOT_TWO_PI = Math.sqrt(2.0 * Math.PI);

    private NormalTail() {}

    /**
     * The probability Q(t) that a standard normal variable exceeds t, with a relative error of 1e-12: Laplace's
     * continued fraction {@code density / (t + 1/(t + 2/(t + 3/...)))} for large t, and
     * {@code 1/2 - density (t + t^3/3 + t^5/15 + ...)} for small t (Abramowitz and Stegun, 26.2.14 and 26.2.11), where
     * {@code density} is the standard normal density at t.
     */
    public static double above(double t) {
        if (t < -FAR) {
            return 1.0 - above(-t);
        }
        double density = Math.exp(-0.5 * t * t) / ROOT_TWO_PI;
        return t > FAR ? density / fraction(t) : 0.5 - density * series(t);
    }

    private static double fraction(double t) {
        double fraction = t;
        for (int level = LEVELS; level >= 1; level--) {
            fraction = t + level / fraction;
        }
        return fraction;
    }

    private static double series(double t) {
        double term = t;
        double sum = t;
        for (int n = 1; n <= LEVELS; n++) {
            term *= t * t / (2 * n + 1);
            sum += term;
        }
        return sum;
    }
}
