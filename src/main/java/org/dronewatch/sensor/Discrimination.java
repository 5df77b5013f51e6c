package org.dronewatch.sensor;

/**
 * The discrimination level required of a drone's image, with the number of line pairs across the target at which the
 * probability is 0.5 (N50), and the probability at other numbers. Johnson (1958) counted 1, 4 and 6.4 line pairs across
 * the smaller dimension of a target. In this model, line pairs are counted across the square root of the target's area,
 * and three quarters as many suffice (Kennedy, "Recognition criterion for two-dimensional minimum resolvable
 * temperature difference", SPIE 1488, 1991). At other numbers, the target transfer probability function gives the
 * probability (Howe, in "The Infrared and Electro-Optical Systems Handbook", vol. 4, 1993).
 */
public enum Discrimination {
    /** The presence of an object is noticed: 0.75 line pairs. */
    DETECTION(0.75),
    /** The target is recognised as a drone: 3 line pairs. */
    RECOGNITION(3.0),
    /** The type of drone is identified: 4.8 line pairs. */
    IDENTIFICATION(4.8);

    private final double linePairs;

    Discrimination(double linePairs) {
        this.linePairs = linePairs;
    }

    /** Line pairs across the square root of the target's area that give a probability of 0.5. */
    public double linePairs() {
        return linePairs;
    }

    /**
     * The probability that the task succeeds, 0 to 1.
     *
     * @param resolved line pairs that are resolved across the square root of the target's area, 0 or more
     */
    public double probability(double resolved) {
        return transfer(resolved / linePairs);
    }

    /**
     * The target transfer probability function, {@code P = x^E / (1 + x^E)} with {@code E = 2.7 + 0.7 x}, where x is
     * the ratio of resolved to required line pairs.
     */
    public static double transfer(double ratio) {
        if (ratio <= 0.0) {
            return 0.0;
        }
        // Written like this, the result never falls by a rounding error as the ratio rises; the bounds rely on that.
        return 1.0 / (1.0 + Math.pow(ratio, -2.7 - 0.7 * ratio));
    }
}
