package org.dronewatch.sensor.thermal;

import java.util.Arrays;
import org.dronewatch.sensor.Draws;
import org.dronewatch.sensor.Look;

/**
 * A program that finds spots in the images of one camera. The signal-to-noise ratio of a spot is taken to be the same
 * in the last frames, and in those since the last look, as it is now: they are a fraction of a second apart. Frames are
 * counted from the start of the run, at the program's own rate, so that the same frames have the same noise however
 * often a run looks at what the program has found.
 */
final class SpotDetector {
    /** A frame that is due at the time of a look, apart from rounding, has been taken. */
    private static final double ROUNDING = 1e-6;

    private final PointTargets rule;
    private final double threshold;
    private final double looksPerSecond;

    /** A detector of spots in the images of a camera, by the given rule. */
    SpotDetector(PointTargets rule, ThermalSettings camera) {
        this.rule = rule;
        this.threshold = rule.threshold(camera.pixels());
        this.looksPerSecond = camera.rate();
    }

    /** The signal above which a pixel is marked, in standard deviations of the noise. */
    double threshold() {
        return threshold;
    }

    /**
     * The probability that enough of the last frames mark a spot; 0 without a signal, since a spot marked by noise
     * alone is a false alarm.
     *
     * @param signalToNoise 0 or more
     */
    double probability(double signalToNoise) {
        return signalToNoise == 0.0 ? 0.0 : rule.probability(mark(signalToNoise));
    }

    /**
     * The probability that the program confirms a spot in at least one of the frames since the previous look.
     *
     * @param signalToNoise 0 or more
     */
    double probabilityOfALook(double signalToNoise) {
        int windows = (int) Math.max(1, Math.round(rule.frameRate() / looksPerSecond));
        return signalToNoise == 0.0
                ? 0.0
                : SpotConfirmation.inOneOf(windows, rule.hits(), rule.frames(), mark(signalToNoise));
    }

    private double mark(double signalToNoise) {
        return PointTargets.markProbability(signalToNoise, threshold);
    }

    /**
     * The threshold that the probability of a mark in one frame must reach for a look to detect the drone. Each frame
     * has a random number u for the drone, and marks it if the probability of a mark is at least u. So M of the last N
     * frames mark it if that probability is at least the M-th smallest of their numbers; and a look detects the drone
     * if this holds in any frame since the previous look.
     *
     * @param drone name of the drone
     * @return the threshold; infinite before there have been enough frames
     */
    double drawnThreshold(Look look, String drone) {
        long newest = newest(look.index());
        long first = look.index() == 0 ? newest : Math.min(newest, newest(look.index() - 1) + 1);
        long oldest = Math.max(0, first - rule.frames() + 1);
        double[] drawn = new double[(int) (newest - oldest) + 1];
        for (int i = 0; i < drawn.length; i++) {
            // Above 0: a drone that does not stand out at all is not found by luck.
            drawn[i] = 1.0
                    - Draws.stream(look.seed(), look.sensor(), drone, oldest + i, Look.DETECTION)
                            .nextDouble();
        }
        double least = Double.POSITIVE_INFINITY;
        for (int last = (int) (first - oldest); last < drawn.length; last++) {
            double[] window = Arrays.copyOfRange(drawn, Math.max(0, last - rule.frames() + 1), last + 1);
            if (window.length >= rule.hits()) {
                Arrays.sort(window);
                least = Math.min(least, window[rule.hits() - 1]);
            }
        }
        return least == Double.POSITIVE_INFINITY ? least : rule.probability(least);
    }

    /** The number of the newest frame at the time of a look, from 0. */
    private long newest(long look) {
        return (long) Math.floor(look * rule.frameRate() / looksPerSecond + ROUNDING);
    }
}
