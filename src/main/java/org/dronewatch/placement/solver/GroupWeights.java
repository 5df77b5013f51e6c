package org.dronewatch.placement.solver;

import java.util.Arrays;
import java.util.function.BooleanSupplier;

/**
 * Weights with which the sums of the groups are added up, so that the greatest weighted sum exceeds the sum of the
 * least group by as little as possible: a group that is served well counts less in the next round. These are
 * multiplicative weights, for the game between a choice and a group: Y. Freund and R. E. Schapire, Adaptive game
 * playing using multiplicative weights, Games and Economic Behavior 29 (1999). Not thread-safe.
 */
final class GroupWeights {
    private static final int ROUNDS = 24;

    private final Gains gains;
    private final Incumbent incumbent;
    private final BooleanSupplier isStopped;
    private final Valuation valuation;
    private double[] best;
    private double lowest = Double.POSITIVE_INFINITY;

    GroupWeights(Gains gains, Incumbent incumbent, BooleanSupplier isStopped) {
        this.gains = gains;
        this.incumbent = incumbent;
        this.isStopped = isStopped;
        this.valuation = new Valuation(gains);
        this.best = even();
    }

    private double[] even() {
        double[] weights = new double[gains.groups];
        Arrays.fill(weights, 1.0 / weights.length);
        return weights;
    }

    /** The weights, which add up to 1. Offers the choices to which they lead. */
    double[] found() {
        for (int group = 0; group < gains.groups && gains.groups > 1 && !isStopped.getAsBoolean(); group++) {
            double[] alone = new double[gains.groups];
            alone[group] = 1.0;
            tried(alone);
        }
        double step = Math.sqrt(8.0 * Math.log(gains.groups) / ROUNDS);
        double[] weights = even();
        for (int round = 0; round < ROUNDS && gains.groups > 1 && !isStopped.getAsBoolean(); round++) {
            double[] sums = tried(weights);
            double greatest = Arrays.stream(sums).max().orElse(0.0);
            double total = 0.0;
            for (int group = 0; group < sums.length; group++) {
                weights[group] *= greatest > 0.0 ? Math.exp(-step * sums[group] / greatest) : 1.0;
                total += weights[group];
            }
            for (int group = 0; group < sums.length; group++) {
                weights[group] /= total;
            }
        }
        return best;
    }

    /** The sums of the groups for the choice to which weights lead. */
    private double[] tried(double[] weights) {
        Gains summed = gains.weighted(weights);
        double[] sums = new double[gains.groups];
        double most = Double.NEGATIVE_INFINITY;
        for (boolean byCost : new boolean[] {false, true}) {
            int[] chosen = chosen(summed, byCost);
            incumbent.offer(chosen);
            double[] there = valuation.ofGroups(chosen);
            double value = weighted(weights, there);
            if (value > most) {
                most = value;
                sums = there;
            }
        }
        if (most < lowest) {
            lowest = most;
            best = weights.clone();
        }
        return sums;
    }

    private int[] chosen(Gains summed, boolean byCost) {
        Rules rules = incumbent.rules();
        int[] greedy = new LazyGreedy(summed, rules, byCost).extended(rules.fixed);
        return gains.fold == 1 && incumbent.isLegal(greedy)
                ? new Interchange(summed, rules, isStopped).swapped(greedy)
                : greedy;
    }

    private static double weighted(double[] weights, double[] sums) {
        double sum = 0.0;
        for (int group = 0; group < sums.length; group++) {
            sum += weights[group] * sums[group];
        }
        return sum;
    }
}
