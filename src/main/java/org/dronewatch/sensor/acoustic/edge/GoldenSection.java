package org.dronewatch.sensor.acoustic.edge;

import java.util.function.DoubleUnaryOperator;

/** The golden-section search for a minimum (J. Kiefer, Proceedings of the AMS 4, 502, 1953). */
final class GoldenSection {
    private static final double GOLDEN = 0.5 * (Math.sqrt(5.0) - 1.0);

    private GoldenSection() {}

    /**
     * Evaluates a function at points that approach a minimum of it. If two values are equal, the search continues at
     * the one nearer to the middle.
     *
     * @param function the function, which itself keeps its best point
     * @param middle middle of the interval that is searched
     * @param half half the length of the interval
     * @param steps number of times by which the interval is shortened
     */
    static void search(DoubleUnaryOperator function, double middle, double half, int steps) {
        double low = middle - half;
        double high = middle + half;
        double left = high - GOLDEN * (high - low);
        double right = low + GOLDEN * (high - low);
        double ofLeft = function.applyAsDouble(left);
        double ofRight = function.applyAsDouble(right);
        for (int i = 0; i < steps; i++) {
            boolean toTheLeft = ofLeft == ofRight ? middle < 0.5 * (left + right) : ofLeft < ofRight;
            if (toTheLeft) {
                high = right;
                right = left;
                ofRight = ofLeft;
                left = high - GOLDEN * (high - low);
                ofLeft = function.applyAsDouble(left);
            } else {
                low = left;
                left = right;
                ofLeft = ofRight;
                right = low + GOLDEN * (high - low);
                ofRight = function.applyAsDouble(right);
            }
        }
    }
}
