package org.dronewatch.sensor.radar;

import java.util.Arrays;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.dronewatch.drone.RadarSignature.Fluctuation;

/**
 * The probability with which an echo is distinguished from noise if the target's cross-section is log-normally
 * distributed from look to look: {@code 10 lg(x) = spread z - (ln 10 / 20) spread^2} with a standard normal z, so that
 * the mean of x is one (3GPP TR 38.901, section 7.9.2.1). The probability of detection is that of a steady target,
 * averaged over z. For use by one thread.
 *
 * <p>That mean is a sum at equal steps of z, which converges exponentially for so smooth a curve (L. N. Trefethen, J.
 * A. C. Weideman, SIAM Review 56, 2014). In units of the ratio, the steps are below the width of a steady target's
 * curve, about 1 dB.
 */
final class LogNormalEcho {
    private static final double WIDEST_STEP = 0.25;

    /** The greatest step of the cross-section, dB. */
    private static final double STEP = 1.0;

    /** Beyond this many standard deviations lies less than 1e-12 of the looks. */
    private static final double REACH = 7.25;

    private static final double TOLERANCE_DB = 1e-10;

    /** The ratios found so far: all cases of a campaign need the same few. */
    private static final Map<Sought, Double> FOUND = new ConcurrentHashMap<>();

    private static final int MOST_FOUND = 1000;

    private final SquareLawDetector detector;
    private final double spread;
    private final double[] excess;
    private final double[] weight;

    /** The quantities on which a required ratio depends. */
    private record Sought(double falseAlarm, int pulses, double spread, double probability) {}

    /**
     * @param detector the detector that adds up the pulses
     * @param spread standard deviation of the cross-section in decibels, above 0 and at most 20 dB
     */
    LogNormalEcho(SquareLawDetector detector, double spread) {
        this.detector = detector;
        this.spread = spread;
        double step = Math.min(WIDEST_STEP, STEP / spread);
        int half = (int) Math.ceil(REACH / step);
        excess = new double[2 * half + 1];
        weight = new double[excess.length];
        for (int i = 0; i < excess.length; i++) {
            double z = (i - half) * step;
            excess[i] = excess(z);
            weight[i] = Math.exp(-0.5 * z * z);
        }
        double all = Arrays.stream(weight).sum();
        for (int i = 0; i < weight.length; i++) {
            weight[i] /= all;
        }
    }

    /**
     * The excess of the cross-section of a look over the mean, dB.
     *
     * @param z a standard normal variable: mean 0, standard deviation 1
     */
    double excess(double z) {
        return spread * z - Math.log(10.0) / 20.0 * spread * spread;
    }

    /**
     * Probability that a look detects a target.
     *
     * @param signalToNoise signal-to-noise ratio of one pulse, the mean over the distribution, dB
     */
    double probability(double signalToNoise) {
        double sum = 0.0;
        for (int i = 0; i < weight.length; i++) {
            sum += weight[i] * detector.probability(signalToNoise + excess[i], Fluctuation.STEADY);
        }
        return Math.min(1.0, sum);
    }

    /**
     * Signal-to-noise ratio that each pulse needs on average, dB, by bisection.
     *
     * @param probability probability of detection, above that of a false alarm and below 1
     */
    double required(double probability) {
        Sought sought = new Sought(detector.falseAlarm(), detector.pulses(), spread, probability);
        Double known = FOUND.get(sought);
        if (known != null) {
            return known;
        }
        double found = bisected(probability);
        if (FOUND.size() < MOST_FOUND) {
            FOUND.put(sought, found);
        }
        return found;
    }

    private double bisected(double probability) {
        double low = detector.required(probability, Fluctuation.STEADY) - excess(REACH);
        double high = detector.required(probability, Fluctuation.STEADY) - excess(-REACH);
        while (high - low > TOLERANCE_DB) {
            double middle = 0.5 * (low + high);
            boolean isEnough = probability(middle) >= probability;
            high = isEnough ? middle : high;
            low = isEnough ? low : middle;
        }
        return 0.5 * (low + high);
    }
}
