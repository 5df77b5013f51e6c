package org.dronewatch.sensor;

/**
 * The discrimination level required of a drone's image, with the line pairs across it that give a probability of 0.5
 * (N50, Johnson 1958), and the probability for more or fewer: the target transfer probability function (Howe, in "The
 * Infrared and Electro-Optical Systems Handbook", vol. 4, 1993).
 */
public enum Discrimination {
    /** Something is there: 1 line pair. */
    DETECTION(1.0),
    /** It is a drone: 4 line pairs. */
    RECOGNITION(4.0),
    /** Which drone: 6.4 line pairs. */
    IDENTIFICATION(6.4);

    private final double linePairs;

    Discrimination(double linePairs) {
        this.linePairs = linePairs;
    }

    /** Line pairs across the target that give a probability of 0.5. */
    public double linePairs() {
        return linePairs;
    }

    /**
     * The probability that it succeeds, 0 to 1.
     *
     * @param resolved line pairs that are resolved across the target, 0 or more
     */
    public double probability(double resolved) {
        return transfer(resolved / linePairs);
    }

    /** {@code P = x^E / (1 + x^E)} with {@code E = 2.7 + 0.7 x}, where x is resolved over required line pairs. */
    public static double transfer(double ratio) {
        if (ratio <= 0.0) {
            return 0.0;
        }
        double odds = Math.pow(ratio, 2.7 + 0.7 * ratio);
        return odds == Double.POSITIVE_INFINITY ? 1.0 : odds / (1.0 + odds);
    }
}
