package org.dronewatch.sensor.radar;

import java.util.Arrays;
import org.dronewatch.drone.RadarSignature.Fluctuation;
import org.dronewatch.sensor.Reading;

/**
 * A square-law detector that adds up a number of pulses, and the probability with which it distinguishes an echo from
 * noise: exact sums for steady targets and Swerling's four cases. Signal-to-noise ratios are those of one pulse.
 * Immutable.
 *
 * <p>For noise alone, the sum of N pulses, in units of the mean noise of one, exceeds a threshold T with the
 * probability {@code Q(N, T)}, the probability that a Poisson variable of mean T is below N. With an echo of the
 * signal-to-noise ratio S, it does so with the probability {@code sum over k of w(k) Q(N + k, T)}. For a steady target,
 * w is the Poisson distribution of mean {@code N S} (the noncentral chi-square distribution; Marcum's Q function for N
 * = 1); for a cross-section with the gamma distribution of shape K, w is the negative binomial distribution with that
 * mean, where K = 1, N, 2, 2 N in Swerling's cases 1 to 4 (D. A. Shnidman, "Radar detection probabilities and their
 * calculation", IEEE Transactions on Aerospace and Electronic Systems 31, 1995). All terms are positive. From some k
 * on, Q is one, and the remaining terms add up to the rest of the weights.
 */
final class SquareLawDetector {
    /** The largest number of pulses. */
    static final int MAX_PULSES = 1000;

    private static final double NEGLIGIBLE = 1e-18;

    /**
     * The logarithms of factorials: enough for twice the largest number of pulses and for all terms at a probability of
     * false alarm of 1e-12.
     */
    private static final double[] LOG_FACTORIAL = logFactorials(4096);

    private static final double NEAREST_TO_ONE = 1.0 - 1e-16;
    private static final double TOLERANCE_DB = 1e-11;
    private static final int MOST_STEPS = 100;

    private final int pulses;
    private final double falseAlarm;

    /** {@code Q(pulses + k, T)} for k from 0, as far as it is below one. */
    private final double[] exceeding;

    /**
     * @param falseAlarm probability that noise alone exceeds the threshold, 1e-12 to 0.01
     * @param pulses number of pulses that are added up, 1 to {@link #MAX_PULSES}
     */
    SquareLawDetector(double falseAlarm, int pulses) {
        this.falseAlarm = falseAlarm;
        this.pulses = pulses;
        double threshold = threshold(falseAlarm, pulses);
        double[] found = new double[16];
        double term = lastTerm(threshold, pulses);
        double sum = falseAlarm;
        int count = 0;
        for (int k = 0; k < threshold || term > NEGLIGIBLE; k++) {
            if (count == found.length) {
                found = Arrays.copyOf(found, 2 * count);
            }
            found[count++] = Math.min(1.0, sum);
            term *= threshold / (pulses + k);
            sum += term;
        }
        exceeding = Arrays.copyOf(found, count);
    }

    /** Probability that noise alone exceeds the threshold. */
    double falseAlarm() {
        return falseAlarm;
    }

    /** The number of pulses that are integrated. */
    int pulses() {
        return pulses;
    }

    /**
     * Probability that the sum exceeds the threshold.
     *
     * @param signalToNoise signal-to-noise ratio of one pulse, the mean over the fluctuation, dB; minus infinity for
     *     noise alone
     */
    double probability(double signalToNoise, Fluctuation fluctuation) {
        double mean = pulses * Math.pow(10.0, 0.1 * signalToNoise);
        if (!(mean > 0.0)) {
            return falseAlarm;
        }
        int shape = shape(fluctuation);
        if (shape == 1 && pulses == 1) {
            return Math.pow(falseAlarm, 1.0 / (1.0 + mean));
        }
        return shape == 0
                ? mixture(mean, Double.POSITIVE_INFINITY, mean, -mean, Math.log(mean), 0)
                : mixture(
                        mean,
                        shape,
                        mean / (shape + mean),
                        -shape * Math.log1p(mean / shape),
                        -Math.log1p(shape / mean),
                        shape);
    }

    /**
     * The reading of noise alone that exceeds the threshold: the mean over the pulses in units of the mean noise of
     * one, dB. Beyond the threshold, its distribution is exponential, with the rate of decay at the threshold: exactly
     * for one pulse, nearly so for several.
     *
     * @param excess 0 or more, exponentially distributed with mean 1
     */
    Reading noise(double excess) {
        double threshold = threshold(falseAlarm, pulses);
        double decay = pulses == 1 ? 1.0 : lastTerm(threshold, pulses) / falseAlarm;
        double least = 10.0 * Math.log10(threshold / pulses);
        double value = 10.0 * Math.log10((threshold + excess / decay) / pulses);
        return new Reading(Math.max(least, value), least, RadarDetection.DECIBELS);
    }

    /** The shape K of the gamma distribution of the cross-section, for the sum of all pulses; 0 for a steady target. */
    private int shape(Fluctuation fluctuation) {
        return switch (fluctuation) {
            case STEADY -> 0;
            case SWERLING_1 -> 1;
            case SWERLING_2 -> pulses;
            case SWERLING_3 -> 2;
            case SWERLING_4 -> 2 * pulses;
        };
    }

    /**
     * The sum over the weights, from the largest one up and down, so that none of them underflows.
     *
     * @param factor mean of the Poisson distribution, or one minus the success probability of the negative binomial
     *     distribution
     * @param logFirst logarithm of the first weight
     * @param logFactor logarithm of the factor
     */
    private double mixture(double mean, double shape, double factor, double logFirst, double logFactor, int k) {
        boolean steady = k == 0;
        double most = steady ? mean : mean * (shape - 1.0) / shape;
        int start = (int) Math.min(exceeding.length - 1.0, Math.floor(most));
        double ways = steady ? 0.0 : LOG_FACTORIAL[k + start - 1] - LOG_FACTORIAL[k - 1];
        double largest = Math.exp(logFirst + start * logFactor + ways - LOG_FACTORIAL[start]);
        if (largest == 0.0) {
            // All of the weight lies where Q is one.
            return 1.0;
        }
        double weights = 0.0;
        double sum = 0.0;
        double weight = largest;
        int i = start;
        while (i < exceeding.length && weight > NEGLIGIBLE * largest) {
            weights += weight;
            sum += weight * exceeding[i];
            weight *= factor * (steady ? 1.0 : shape + i) / (i + 1);
            i++;
        }
        boolean isCut = i == exceeding.length;
        weight = largest;
        for (i = start; i > 0 && weight > NEGLIGIBLE * largest; i--) {
            weight *= i / (factor * (steady ? 1.0 : shape + i - 1));
            weights += weight;
            sum += weight * exceeding[i - 1];
        }
        return Math.min(1.0, isCut ? sum + Math.max(0.0, 1.0 - weights) : sum / weights);
    }

    /**
     * Signal-to-noise ratio that each pulse needs, dB; minus infinity for a probability that noise alone reaches.
     *
     * @param probability probability of detection, above 0 and below 1
     */
    double required(double probability, Fluctuation fluctuation) {
        if (probability <= falseAlarm) {
            return Double.NEGATIVE_INFINITY;
        }
        if (pulses == 1 && shape(fluctuation) == 1) {
            return 10.0 * Math.log10(Math.log(falseAlarm) / Math.log(probability) - 1.0);
        }
        double goal = logOdds(probability);
        double low = 0.0;
        double below = logOdds(probability(low, fluctuation)) - goal;
        double high = low;
        double above = below;
        for (double step = 4.0; below > 0.0; step *= 2.0) {
            high = low;
            above = below;
            low -= step;
            below = logOdds(probability(low, fluctuation)) - goal;
        }
        for (double step = 4.0; above < 0.0; step *= 2.0) {
            low = high;
            below = above;
            high += step;
            above = logOdds(probability(high, fluctuation)) - goal;
        }
        return root(low, below, high, above, goal, fluctuation);
    }

    /**
     * The ratio between two others at which the log-odds reach the goal, dB, by Ridders' method (IEEE Transactions on
     * Circuits and Systems 26, 1979).
     */
    private double root(double from, double atFrom, double to, double atTo, double goal, Fluctuation fluctuation) {
        double low = from;
        double below = atFrom;
        double high = to;
        double above = atTo;
        double found = below == 0.0 ? low : high;
        for (int i = 0; i < MOST_STEPS && below < 0.0 && above > 0.0; i++) {
            double middle = 0.5 * (low + high);
            double atMiddle = logOdds(probability(middle, fluctuation)) - goal;
            double next = middle - (middle - low) * atMiddle / Math.sqrt(atMiddle * atMiddle - below * above);
            boolean settled = Math.abs(next - found) < TOLERANCE_DB;
            found = next;
            double atFound = logOdds(probability(found, fluctuation)) - goal;
            if (settled || atFound == 0.0 || high - low < TOLERANCE_DB) {
                break;
            }
            boolean isOrdered = middle < found;
            double first = isOrdered ? middle : found;
            double atFirst = isOrdered ? atMiddle : atFound;
            double second = isOrdered ? found : middle;
            double atSecond = isOrdered ? atFound : atMiddle;
            if (atFirst >= 0.0) {
                high = first;
                above = atFirst;
            } else if (atSecond >= 0.0) {
                low = first;
                below = atFirst;
                high = second;
                above = atSecond;
            } else {
                low = second;
                below = atSecond;
            }
        }
        return found;
    }

    /**
     * The log-odds of a probability, which are nearly linear in the ratio in dB, and steep where the probability itself
     * is flat.
     */
    private static double logOdds(double probability) {
        double p = Math.min(NEAREST_TO_ONE, probability);
        return Math.log(p / (1.0 - p));
    }

    /**
     * The threshold T at which {@code Q(pulses, T)} is the probability of a false alarm, by Newton's method on the
     * logarithm of Q, which is concave, so that the second and all later steps come from above.
     */
    private static double threshold(double falseAlarm, int pulses) {
        if (pulses == 1) {
            return -Math.log(falseAlarm);
        }
        double goal = Math.log(falseAlarm);
        double t = pulses;
        for (int i = 0; i < MOST_STEPS; i++) {
            double last = lastTerm(t, pulses);
            double term = last;
            double tail = 0.0;
            for (int k = pulses - 1; k >= 0 && term > NEGLIGIBLE * last; k--) {
                tail += term;
                term *= k / t;
            }
            double step = (Math.log(tail) - goal) * tail / last;
            t += step;
            if (Math.abs(step) < 1e-13 * t) {
                break;
            }
        }
        return t;
    }

    /** The probability that a Poisson variable of mean T equals the number of pulses minus one. */
    private static double lastTerm(double threshold, int pulses) {
        return Math.exp((pulses - 1) * Math.log(threshold) - threshold - LOG_FACTORIAL[pulses - 1]);
    }

    private static double[] logFactorials(int count) {
        double[] logs = new double[count];
        for (int i = 1; i < count; i++) {
            logs[i] = logs[i - 1] + Math.log(i);
        }
        return logs;
    }
}
