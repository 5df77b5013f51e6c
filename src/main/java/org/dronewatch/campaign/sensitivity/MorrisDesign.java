package org.dronewatch.campaign.sensitivity;

import java.util.Arrays;
import java.util.Comparator;
import java.util.stream.IntStream;

/**
 * Morris's design (Morris, Technometrics 33, 1991): in each group the factors change one by one, in a random order,
 * from their first value to their second. The values are the midpoints of four equally probable intervals of the
 * distribution, and the second differs from the first by half of the total probability.
 *
 * @param factors number of factors, 1 or more
 * @param base number of groups, 2 or more
 * @param values random numbers that determine the first values
 * @param order random numbers that determine the order: the factor with the smallest number changes first
 */
public record MorrisDesign(int factors, int base, Uniform01 values, Uniform01 order) implements FactorDesign {
    /** The change of a factor, as a fraction of the total probability of its distribution. */
    static final double STEP = 0.5;

    private static final int LEVELS = 4;

    /** Checks the limits. */
    public MorrisDesign {
        if (factors < 1 || base < 2) {
            throw new IllegalArgumentException(factors + " factors, base " + base
                    + ": there must be at least one factor, and a base of 2 or more");
        }
    }

    @Override
    public int groupSize() {
        return factors + 1;
    }

    /** The factors of a group in the order in which they change. */
    int[] sequence(int group) {
        double[] keys = new double[factors];
        Arrays.setAll(keys, factor -> order.draw(group, factor, false));
        return IntStream.range(0, factors)
                .boxed()
                .sorted(Comparator.comparingDouble(factor -> keys[factor]))
                .mapToInt(Integer::intValue)
                .toArray();
    }

    @Override
    public boolean isSecond(int evaluation, int factor) {
        int group = group(evaluation);
        double key = order.draw(group, factor, false);
        int before = 0;
        for (int other = 0; other < factors; other++) {
            double its = order.draw(group, other, false);
            before += its < key || its == key && other < factor ? 1 : 0;
        }
        return before < evaluation % groupSize();
    }

    @Override
    public double quantile(int evaluation, int factor) {
        double first = first(group(evaluation), factor);
        return isSecond(evaluation, factor) ? first + step(group(evaluation), factor) : first;
    }

    private double first(int group, int factor) {
        return (Math.floor(LEVELS * values.draw(group, factor, false)) + 0.5) / LEVELS;
    }

    /** The change of a factor in a group, {@link #STEP} or its negative. */
    double step(int group, int factor) {
        return first(group, factor) < STEP ? STEP : -STEP;
    }
}
