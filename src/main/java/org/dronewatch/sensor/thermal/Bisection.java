package org.dronewatch.sensor.thermal;

import java.util.function.DoubleUnaryOperator;

/** Finds the zero of a decreasing function by bisection. */
final class Bisection {
    /** The number of halvings: enough to reach double precision. */
    private static final int HALVINGS = 64;

    private Bisection() {}

    /**
     * The root of a function that decreases from above zero to below it.
     *
     * @param low an argument at which the function is above zero
     * @param high an argument at which the function is below zero
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
