package org.dronewatch.sensor.radar;

import java.util.function.DoubleUnaryOperator;
import org.dronewatch.drone.RadarSignature.Fluctuation;

/**
 * How reliably an echo is distinguished from noise by a square-law detector: exact for a single pulse; for several
 * non-coherently integrated pulses by the approximations of Albersheim (IEEE Proceedings 69, 1981) for steady targets
 * and Shnidman (IEEE Transactions on Aerospace and Electronic Systems 38, 2002) for fluctuating ones. Signal-to-noise
 * ratios are those of a single pulse.
 */
public final class Detectability {
    /** Above this ratio a detection is certain for every threshold that is used here; smaller ones do not overflow. */
    private static final double CERTAIN = 700.0;

    private static final double LEAST_DB = -60.0;
    private static final double MAX_DB = 90.0;
    private static final int BISECTIONS = 80;

    /** Within these probabilities the approximations for several pulses hold. */
    private static final double LEAST_LIKELY = 0.1;

    private static final double MAX_PROBABILITY_STEADY = 0.9;
    private static final double MAX_PROBABILITY_FLUCTUATING = 0.99;

    private Detectability() {}

    /**
     * Probability that one look detects a target.
     *
     * @param signalToNoise dB
     * @param falseAlarm probability that noise alone is taken for a target, above 0 and below 1
     * @param fluctuation of the target; Swerling 3 as in Mahafza, Radar Systems Analysis, for one pulse
     */
    public static double probability(double signalToNoise, double falseAlarm, Fluctuation fluctuation) {
        double ratio = Math.pow(10.0, 0.1 * signalToNoise);
        double threshold = -Math.log(falseAlarm);
        return switch (fluctuation) {
            case STEADY -> marcum(ratio, threshold);
            case SWERLING_1 -> Math.pow(falseAlarm, 1.0 / (1.0 + ratio));
            case SWERLING_3 -> {
                double half = 1.0 + 0.5 * ratio;
                yield (1.0 + 0.5 * ratio * threshold / (half * half)) * Math.exp(-threshold / half);
            }
        };
    }

    /**
     * Signal-to-noise ratio that one look needs, dB; minus infinity for a probability that noise alone reaches.
     *
     * @param probability of detection, above 0 and below 1
     */
    public static double required(double probability, double falseAlarm, Fluctuation fluctuation) {
        if (probability <= falseAlarm) {
            return Double.NEGATIVE_INFINITY;
        }
        if (fluctuation == Fluctuation.SWERLING_1) {
            return 10.0 * Math.log10(Math.log(falseAlarm) / Math.log(probability) - 1.0);
        }
        return solve(snr -> probability(snr, falseAlarm, fluctuation), probability);
    }

    /**
     * Signal-to-noise ratio that each of several pulses needs, dB. Beyond the probabilities for which the
     * approximations hold (0.1 to 0.9 for steady targets, to 0.99 for others), the gain from integration is taken to be
     * that at the nearest limit.
     *
     * @param pulses how many are summed, 1 or more
     */
    public static double required(double probability, double falseAlarm, Fluctuation fluctuation, int pulses) {
        if (pulses == 1) {
            return required(probability, falseAlarm, fluctuation);
        }
        boolean steady = fluctuation == Fluctuation.STEADY;
        double most = steady ? MAX_PROBABILITY_STEADY : MAX_PROBABILITY_FLUCTUATING;
        double valid = Math.min(most, Math.max(LEAST_LIKELY, probability));
        double summed =
                steady ? albersheim(valid, falseAlarm, pulses) : shnidman(valid, falseAlarm, fluctuation, pulses);
        double single = required(valid, falseAlarm, fluctuation);
        return required(probability, falseAlarm, fluctuation) - (single - summed);
    }

    /**
     * Albersheim's equation: ratio for a steady target, dB. Within 0.2 dB for probabilities of detection from 0.1 to
     * 0.9, of false alarm from 1e-7 to 1e-3, up to 8096 pulses.
     */
    public static double albersheim(double probability, double falseAlarm, int pulses) {
        double a = Math.log(0.62 / falseAlarm);
        double b = Math.log(probability / (1.0 - probability));
        return -5.0 * Math.log10(pulses)
                + (6.2 + 4.54 / Math.sqrt(pulses + 0.44)) * Math.log10(a + 0.12 * a * b + 1.7 * b);
    }

    /**
     * Shnidman's equation: ratio for a target of any fluctuation, dB. Within 0.5 dB for probabilities of detection from
     * 0.1 to 0.99, of false alarm from 1e-9 to 1e-3, up to 100 pulses.
     */
    public static double shnidman(double probability, double falseAlarm, Fluctuation fluctuation, int pulses) {
        double degrees =
                switch (fluctuation) {
                    case STEADY -> Double.POSITIVE_INFINITY;
                    case SWERLING_1 -> 1.0;
                    case SWERLING_3 -> 2.0;
                };
        double p = probability;
        double alpha = pulses < 40 ? 0.0 : 0.25;
        double eta = Math.sqrt(-0.8 * Math.log(4.0 * falseAlarm * (1.0 - falseAlarm)))
                + Math.signum(p - 0.5) * Math.sqrt(-0.8 * Math.log(4.0 * p * (1.0 - p)));
        double x = eta * (eta + 2.0 * Math.sqrt(0.5 * pulses + (alpha - 0.25)));
        double c = (((17.7006 * p - 18.4496) * p + 14.5339) * p - 3.525) / degrees;
        if (p > 0.872) {
            c += (Math.exp(27.31 * p - 25.14)
                            + (p - 0.8) * (0.7 * Math.log(1e-5 / falseAlarm) + (2.0 * pulses - 20.0) / 80.0))
                    / degrees;
        }
        return c + 10.0 * Math.log10(x / pulses);
    }

    /**
     * Marcum's Q function of order one, {@code Q1(sqrt(2 S), sqrt(2 T))}: the chance that signal and noise together
     * exceed a threshold. As the noncentral chi-square distribution: a Poisson mixture, mean S, of the chances that a
     * Poisson variable of mean T stays at or below each count; all terms are positive.
     */
    private static double marcum(double ratio, double threshold) {
        if (ratio > CERTAIN) {
            return 1.0;
        }
        double weight = Math.exp(-ratio);
        double term = Math.exp(-threshold);
        double below = term;
        double sum = weight * below;
        double weights = weight;
        for (int k = 1; weights < 1.0 - 1e-16 && k < 10 * CERTAIN; k++) {
            weight *= ratio / k;
            term *= threshold / k;
            below += term;
            sum += weight * below;
            weights += weight;
            // From here on each weight is smaller than the one before: none can change the sum any more.
            if (k > ratio && sum + 2.0 * weight <= sum) {
                break;
            }
        }
        return Math.min(1.0, sum);
    }

    /** Where a growing function of a level in dB has a value. */
    private static double solve(DoubleUnaryOperator growing, double value) {
        double low = LEAST_DB;
        double high = MAX_DB;
        for (int i = 0; i < BISECTIONS; i++) {
            double middle = 0.5 * (low + high);
            if (growing.applyAsDouble(middle) < value) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return 0.5 * (low + high);
    }
}
