package org.dronewatch.campaign.sensitivity;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;

/**
 * Sobol indices from the results of a {@link SaltelliDesign}, where a are the results with all first values, b those
 * with all second values, and c those in which factor i alone has its second value. The first-order index is mean((b -
 * m) (c - a)) / V (Saltelli et al., Computer Physics Communications 181, 2010, table 2, estimator b) and the total
 * index mean((a - c)^2) / (2 V) (Jansen, Computer Physics Communications 117, 1999), where m and V are the mean and the
 * variance of all a and b. Both are exactly 0 for a factor without influence. Subtracting m does not change what the
 * first-order index estimates, since the expectation of c - a is 0, but it keeps a large mean from making the estimate
 * noisy.
 */
public final class SobolEstimate {
    private static final double CONFIDENCE = 0.95;
    private static final int RESAMPLES = 1000;

    private final int factors;
    private final double[][] groups;

    /**
     * Prepares the estimate.
     *
     * @param groups the results of each group, in the order of the design; incomplete groups may be left out
     */
    public SobolEstimate(List<double[]> groups) {
        this.groups = groups.stream().map(double[]::clone).toArray(double[][]::new);
        this.factors = groups.isEmpty() ? 0 : groups.get(0).length - SaltelliDesign.BOTH;
    }

    /**
     * The indices of all factors in their order.
     *
     * @param seed seed of the bootstrap
     * @return the indices; empty if the result does not vary, or if there are fewer than two groups
     */
    public List<SobolIndex> indices(long seed) {
        int[] all = new int[groups.length];
        Arrays.setAll(all, i -> i);
        double[] estimate = new double[2 * factors];
        if (groups.length < 2 || !estimate(all, estimate)) {
            return List.of();
        }
        double[][] resampled = resampled(new SplittableRandom(seed));
        List<SobolIndex> indices = new ArrayList<>();
        for (int i = 0; i < factors; i++) {
            double[] first = resampled[i];
            double[] total = resampled[factors + i];
            indices.add(new SobolIndex(
                    estimate[i], low(first), high(first), estimate[factors + i], low(total), high(total)));
        }
        return indices;
    }

    /** The first-order indices and then the total ones of chosen groups; false if their results do not vary. */
    private boolean estimate(int[] chosen, double[] into) {
        double sum = 0.0;
        for (int group : chosen) {
            sum += groups[group][0] + groups[group][1];
        }
        double mean = sum / (2.0 * chosen.length);
        double squares = 0.0;
        Arrays.fill(into, 0.0);
        for (int group : chosen) {
            double[] result = groups[group];
            squares += square(result[0] - mean) + square(result[1] - mean);
            for (int i = 0; i < factors; i++) {
                into[i] += (result[1] - mean) * (result[SaltelliDesign.BOTH + i] - result[0]);
                into[factors + i] += square(result[0] - result[SaltelliDesign.BOTH + i]);
            }
        }
        // Both means have chosen.length terms, and the variance is that of twice as many results.
        for (int i = 0; i < factors; i++) {
            into[i] = 2.0 * into[i] / squares;
            into[factors + i] /= squares;
        }
        return squares > 0.0;
    }

    /** The sorted estimates of resampled groups, by index. */
    private double[][] resampled(SplittableRandom random) {
        double[][] estimates = new double[2 * factors][RESAMPLES];
        int[] chosen = new int[groups.length];
        double[] one = new double[2 * factors];
        for (int sample = 0; sample < RESAMPLES; sample++) {
            do {
                Arrays.setAll(chosen, i -> random.nextInt(groups.length));
            } while (!estimate(chosen, one));
            for (int i = 0; i < one.length; i++) {
                estimates[i][sample] = one[i];
            }
        }
        for (double[] values : estimates) {
            Arrays.sort(values);
        }
        return estimates;
    }

    private static double low(double[] sorted) {
        return sorted[(int) Math.round((1.0 - CONFIDENCE) / 2.0 * sorted.length)];
    }

    private static double high(double[] sorted) {
        return sorted[sorted.length - 1 - (int) Math.round((1.0 - CONFIDENCE) / 2.0 * sorted.length)];
    }

    private static double square(double value) {
        return value * value;
    }
}
