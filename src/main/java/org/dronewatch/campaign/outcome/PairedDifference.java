package org.dronewatch.campaign.outcome;

import org.apache.commons.numbers.gamma.RegularizedBeta;
import org.dronewatch.statistics.Proportion;

/**
 * Two variants on the same cases, compared by an outcome that each case has or lacks. Only the cases in which the
 * variants differ are decisive.
 *
 * @param onlyA number of cases in which only the first variant has the outcome
 * @param onlyB number of cases in which only the second variant has the outcome
 * @param of number of all cases, at least {@code onlyA + onlyB}
 */
public record PairedDifference(int onlyA, int onlyB, int of) {
    /** Checks the limits. */
    public PairedDifference {
        if (onlyA < 0 || onlyB < 0 || (long) onlyA + onlyB > of) {
            throw new IllegalArgumentException(onlyA + " and " + onlyB + " discordant cases among " + of);
        }
    }

    /**
     * The proportion of cases in which the first variant has the outcome, less that of the second; NaN if there are no
     * cases.
     */
    public double difference() {
        return (double) (onlyA - onlyB) / of;
    }

    /**
     * The probability that, if both variants were equally good, the discordant cases, those in which the variants
     * differ, would be divided at least as unevenly as they are: McNemar's test in its exact form, two-sided (McNemar,
     * Psychometrika 12, 1947; each discordant case favours either variant with probability 1/2). It is 1 if there are
     * no discordant cases.
     */
    public double pValue() {
        int discordant = onlyA + onlyB;
        int fewer = Math.min(onlyA, onlyB);
        if (onlyA == onlyB) {
            return 1.0;
        }
        // P(X <= fewer) of the binomial distribution, by the incomplete beta function.
        return Math.min(1.0, 2.0 * RegularizedBeta.value(0.5, discordant - fewer, fewer + 1.0));
    }

    /**
     * A confidence interval for the difference of the two probabilities: the Wald interval, with half a case added to
     * each of the four cells of the table of both outcomes (Agresti and Min, Statistics in Medicine 24, 2005), which
     * has the stated confidence even with few discordant cases.
     *
     * @param confidence the confidence, such as 0.95, above 0 and below 1
     * @return the interval, within -1 to 1
     */
    public Proportion.Interval interval(double confidence) {
        double n = of + 2.0;
        double a = onlyA + 0.5;
        double b = onlyB + 0.5;
        double middle = (a - b) / n;
        double half = Proportion.normal(confidence) * Math.sqrt(a + b - (a - b) * (a - b) / n) / n;
        return new Proportion.Interval(Math.max(-1.0, middle - half), Math.min(1.0, middle + half));
    }
}
