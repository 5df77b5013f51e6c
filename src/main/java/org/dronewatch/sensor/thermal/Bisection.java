package org.dronewatch.sensor.thermal;

import java.util.function.DoubleUnaryOperator;

/** Where a falling function crosses zero. */
final class Bisection {
    /** Enough halvings to reach double precision. */
    private static final int HALVINGS = 64;

    private Bisection() {}

    /**
     * The root of a function that falls from above zero to below it.
     *
     * @param low where it is above zero
     * @param high where it is below zero
     */
    static double root(double low, double high, DoubleUnaryOperator falling) {
        double from = low;
        double to = high;
        for (int i = 0; i < HALVINGS; i++) {
            double middle = 0.5 * (from + to);
            if (falling.applyAsDouble(middle) > 0.0) {
                from = middle;
            } else {
                to = middle;
            }
        }
        return 0.5 * (from + to);
    }
}
