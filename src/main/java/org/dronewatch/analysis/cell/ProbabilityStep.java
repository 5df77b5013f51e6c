package org.dronewatch.analysis.cell;

/**
 * The scale on which a field keeps probabilities, in a byte: 0 and 1 exactly, multiples of 1/250 between them, and five
 * values below 1/250 that are a factor of 4 apart, down to 1/256,000. In results, these five values count as 1/250.
 * They matter to sensors that look often: in a minute, ten looks a second detect nine of ten drones if each look has a
 * probability of 1/250, but only one in seven if it has 1/4,000.
 */
public final class ProbabilityStep {
    /** The step that represents exactly 1; step 0 represents exactly 0. */
    public static final int CERTAIN = 255;

    private static final int EVEN = 250;

    /** The number of steps between 0 and 1/250. */
    private static final int SMALL = CERTAIN - EVEN;

    private static final double FACTOR = 4.0;

    private ProbabilityStep() {}

    /**
     * The step to which a probability is rounded: the nearest one or, below 1/250, the nearest on a logarithmic scale.
     */
    public static int of(double probability) {
        if (probability <= 0.0 || probability >= 1.0) {
            return probability <= 0.0 ? 0 : CERTAIN;
        }
        if (probability >= 0.5 / EVEN) {
            return SMALL + Math.max(1, Math.min(EVEN - 1, (int) Math.rint(EVEN * probability)));
        }
        int step = SMALL;
        while (step > 1 && probability < least(step)) {
            step--;
        }
        return step;
    }

    /** The probability that results state for a step: the one that it represents, but at least 1/250 unless it is 0. */
    public static double stated(int step) {
        return probability(step == 0 ? 0 : Math.max(SMALL + 1, step));
    }

    /** The probability that a step represents. */
    public static double probability(int step) {
        if (step == 0 || step > SMALL) {
            return (double) Math.max(0, step - SMALL) / EVEN;
        }
        return 1.0 / EVEN / Math.pow(FACTOR, SMALL + 1.0 - step);
    }

    /** The least probability that is rounded to a step; 0 for the first step above 0, which has no lower limit. */
    public static double least(int step) {
        if (step <= 1 || step == CERTAIN) {
            return step == CERTAIN ? 1.0 : 0.0;
        }
        return step > SMALL ? (step - SMALL - 0.5) / EVEN : 0.5 / EVEN / Math.pow(FACTOR, SMALL + 1.0 - step);
    }

    /**
     * The lowest step with which a sensor covers a cell, given the probability that covering requires, 1/250 or more.
     */
    public static int toCover(double covered) {
        return SMALL + (int) Math.ceil(covered * EVEN - 1e-9);
    }
}
