package org.dronewatch.placement.solver;

import java.util.Arrays;
import org.dronewatch.placement.solver.Gains.Form;

/** The gain of a choice, and what remains of it after the worst loss. Not thread-safe: one per search. */
final class Valuation {
    private final Gains gains;
    private final int width;

    /** By row: for forms that take the best, the k + 1 best gains in descending order; otherwise the sum first. */
    private final double[] top;

    /** By row: whose gains these are; -1 for the floor. */
    private final int[] owner;

    private final double[] lost;

    /** By group: the sum of its rows. */
    private final double[] sums;

    Valuation(Gains gains) {
        this.gains = gains;
        width = gains.fold + 1;
        top = new double[gains.rowCount() * width];
        owner = new int[top.length];
        lost = new double[gains.candidates() * gains.groups];
        sums = new double[gains.groups];
    }

    /** The gain of a choice. */
    double value(int[] chosen) {
        fill(chosen);
        if (gains.form == Form.LEAST_SUM) {
            return leastGroup();
        }
        double sum = 0.0;
        double least = Double.POSITIVE_INFINITY;
        for (int row = 0; row < gains.rowCount(); row++) {
            double value = inRow(row);
            sum += value;
            least = Math.min(least, value);
        }
        boolean isSum = gains.form == Form.BEST_SUM || gains.form == Form.SATURATED_SUM;
        return isSum ? sum : gains.rowCount() == 0 ? 0.0 : least;
    }

    private double leastGroup() {
        Arrays.fill(sums, 0.0);
        for (int row = 0; row < gains.rowCount(); row++) {
            sums[gains.group[row]] += inRow(row);
        }
        return Arrays.stream(sums).min().orElse(0.0);
    }

    /** The sum of each group for a choice. */
    double[] ofGroups(int[] chosen) {
        fill(chosen);
        leastGroup();
        return sums.clone();
    }

    /** The gain after the worst loss; that of the choice itself if it is empty. */
    double worstLoss(int[] chosen) {
        double value = value(chosen);
        if (chosen.length == 0) {
            return value;
        }
        return switch (gains.form) {
            case BEST_SUM, LEAST_SUM -> leastWithoutOne(chosen);
            case BEST_LEAST -> leastSecond();
            case SUM_LEAST -> leastWithoutGreatest(chosen);
            case SATURATED_SUM -> leastSaturated(chosen);
        };
    }

    /**
     * A measure of progress where the value itself does not change yet: the better a row is already served, the
     * less it counts.
     */
    double progress() {
        double sum = 0.0;
        for (int row = 0; row < gains.rowCount(); row++) {
            double mean = 0.0;
            for (int rank = 0; rank < width; rank++) {
                mean += top[row * width + rank] / width;
            }
            sum += Math.sqrt(mean);
        }
        return sum;
    }

    private void fill(int[] chosen) {
        boolean takesBest = takesBest();
        for (int row = 0; row < gains.rowCount(); row++) {
            Arrays.fill(top, row * width, (row + 1) * width, takesBest ? gains.floor[row] : 0.0);
        }
        Arrays.fill(owner, -1);
        for (int candidate : chosen) {
            int[] rows = gains.rows[candidate];
            double[] values = gains.gains[candidate];
            for (int at = 0; at < rows.length; at++) {
                if (takesBest) {
                    insert(rows[at] * width, values[at], candidate);
                } else {
                    top[rows[at] * width] += values[at];
                }
            }
        }
    }

    private boolean takesBest() {
        return gains.form != Form.SUM_LEAST && gains.form != Form.SATURATED_SUM;
    }

    private void insert(int start, double value, int candidate) {
        int at = start + width - 1;
        if (value <= top[at]) {
            return;
        }
        while (at > start && top[at - 1] < value) {
            top[at] = top[at - 1];
            owner[at] = owner[at - 1];
            at--;
        }
        top[at] = value;
        owner[at] = candidate;
    }

    private double inRow(int row) {
        return switch (gains.form) {
            case BEST_SUM, LEAST_SUM, BEST_LEAST -> top[row * width + gains.fold - 1];
            case SUM_LEAST -> top[row * width];
            case SATURATED_SUM -> -gains.weight[row] * Math.expm1(-top[row * width]);
        };
    }

    /** Where a candidate is one of the k best of a row, the next best moves up when it is lost. */
    private double leastWithoutOne(int[] chosen) {
        leastGroup();
        Arrays.fill(lost, 0.0);
        for (int row = 0; row < gains.rowCount(); row++) {
            int start = row * width;
            double difference = top[start + gains.fold - 1] - top[start + gains.fold];
            for (int rank = 0; rank < gains.fold; rank++) {
                if (owner[start + rank] >= 0) {
                    lost[owner[start + rank] * gains.groups + gains.group[row]] += difference;
                }
            }
        }
        double least = Double.POSITIVE_INFINITY;
        for (int candidate : chosen) {
            for (int group = 0; group < gains.groups; group++) {
                least = Math.min(least, sums[group] - lost[candidate * gains.groups + group]);
            }
        }
        return least;
    }

    private double leastSecond() {
        double least = Double.POSITIVE_INFINITY;
        for (int row = 0; row < gains.rowCount(); row++) {
            least = Math.min(least, top[row * width + gains.fold]);
        }
        return gains.rowCount() == 0 ? 0.0 : least;
    }

    private double leastWithoutGreatest(int[] chosen) {
        double[] greatest = new double[gains.rowCount()];
        for (int candidate : chosen) {
            for (int at = 0; at < gains.rows[candidate].length; at++) {
                int row = gains.rows[candidate][at];
                greatest[row] = Math.max(greatest[row], gains.gains[candidate][at]);
            }
        }
        double least = Double.POSITIVE_INFINITY;
        for (int row = 0; row < greatest.length; row++) {
            least = Math.min(least, top[row * width] - greatest[row]);
        }
        return greatest.length == 0 ? 0.0 : least;
    }

    private double leastSaturated(int[] chosen) {
        double value = 0.0;
        for (int row = 0; row < gains.rowCount(); row++) {
            value += inRow(row);
        }
        double worst = 0.0;
        for (int candidate : chosen) {
            double share = 0.0;
            for (int at = 0; at < gains.rows[candidate].length; at++) {
                int row = gains.rows[candidate][at];
                double without = top[row * width] - gains.gains[candidate][at];
                share += gains.weight[row] * (Math.exp(-without) - Math.exp(-top[row * width]));
            }
            worst = Math.max(worst, share);
        }
        return value - worst;
    }
}
