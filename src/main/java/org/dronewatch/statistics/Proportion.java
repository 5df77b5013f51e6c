package org.dronewatch.statistics;

import org.apache.commons.numbers.gamma.InverseErfc;
import org.apache.commons.numbers.gamma.RegularizedBeta;

/**
 * The number of independent cases that had an outcome, and what it implies for the probability of that outcome.
 *
 * @param count cases with the outcome, 0 to {@code of}
 * @param of all cases, 0 or more
 */
public record Proportion(int count, int of) {
    /** Checks the limits. */
    public Proportion {
        if (of < 0 || count < 0 || count > of) {
            throw new IllegalArgumentException(count + " of " + of + " cases: must be 0 to " + of);
        }
    }

    /** The fraction of the cases with the outcome; NaN without cases. */
    public double share() {
        return (double) count / of;
    }

    /**
     * Wilson's score interval for the probability (Wilson, Journal of the American Statistical Association 22, 1927):
     * over many campaigns, about the fraction {@code confidence} of the intervals contain the true probability, even
     * where that probability is close to 0 or 1.
     *
     * @param confidence such as 0.95, above 0 and below 1
     * @return the interval; from 0 to 1 if there are no cases
     */
    public Interval wilson(double confidence) {
        if (of == 0) {
            return new Interval(0.0, 1.0);
        }
        double z = normal(confidence);
        double weight = of + z * z;
        double middle = (count + 0.5 * z * z) / weight;
        double half = z * Math.sqrt((double) count * (of - count) / of + 0.25 * z * z) / weight;
        // Rounding must not carry a bound past the end: 0 of n cases begins at 0 exactly.
        return new Interval(
                count == 0 ? 0.0 : Math.max(0.0, middle - half), count == of ? 1.0 : Math.min(1.0, middle + half));
    }

    /**
     * Whether a probability is in the exact interval (Clopper and Pearson, Biometrika 26, 1934): at this probability, a
     * count at least as high as this one, and a count at most as high, each have a probability of at least
     * {@code (1 - confidence) / 2}. Over many campaigns, at least the fraction {@code confidence} of these intervals
     * contain the true probability, even where Wilson's intervals contain it less often, for example if fewer than one
     * case with the outcome is expected.
     *
     * @param probability the probability, 0 to 1
     * @param confidence such as 0.95, above 0 and below 1
     */
    public boolean isPlausible(double probability, double confidence) {
        double least = 0.5 * (1.0 - confidence);
        // The tails of the binomial distribution as incomplete beta functions.
        double asMany = count == 0 ? 1.0 : RegularizedBeta.value(probability, count, of - count + 1.0);
        double asFew = count == of ? 1.0 : RegularizedBeta.complement(probability, count + 1.0, of - count);
        return asMany >= least && asFew >= least;
    }

    /**
     * The number of standard deviations on either side of the mean within which a normally distributed value lies with
     * the probability {@code confidence}, 0 to 1.
     */
    public static double normal(double confidence) {
        return Math.sqrt(2.0) * InverseErfc.value(1.0 - confidence);
    }

    /**
     * A closed interval.
     *
     * @param low its lower bound
     * @param high its upper bound
     */
    public record Interval(double low, double high) {
        /** Whether a value lies in this interval. */
        public boolean contains(double value) {
            return low <= value && value <= high;
        }
    }
}
