package org.dronewatch.sensor.thermal;

import java.util.Arrays;
import org.dronewatch.sensor.Draws;
import org.dronewatch.sensor.Look;

/**
 * A program that finds spots in the images of one camera. The signal-to-noise ratio of a spot is taken to be the same
 * in the last frames as it is now: they are a fraction of a second apart.
 */
final class SpotDetector {
    private final PointTargets rule;
    private final double threshold;

    /** In the images of a camera that has such a rule. */
    SpotDetector(PointTargets rule, ThermalSettings camera) {
        this.rule = rule;
        this.threshold = rule.threshold(camera.pixels(), camera.rate());
    }

    /** What a pixel must exceed to be marked, in standard deviations of the noise. */
    double threshold() {
        return threshold;
    }

    /**
     * The probability that enough of the last frames mark a spot; 0 without a signal: what noise alone marks is a false
     * alarm.
     *
     * @param signalToNoise 0 or more
     */
    double probability(double signalToNoise) {
        return signalToNoise == 0.0 ? 0.0 : rule.probability(PointTargets.markProbability(signalToNoise, threshold));
    }

    /**
     * What that probability must reach in a frame. Each frame has a random number u for the drone, and marks it where
     * the probability of a mark is at least u. So M of the last N frames do where it is at least the M-th smallest of
     * their numbers.
     *
     * @param drone name of the drone
     * @return infinite before there have been enough frames
     */
    double drawnThreshold(Look look, String drone) {
        int count = (int) Math.min(rule.frames(), look.index() + 1);
        if (count < rule.hits()) {
            return Double.POSITIVE_INFINITY;
        }
        double[] drawn = new double[count];
        for (int back = 0; back < count; back++) {
            // Above 0: what does not stand out at all is not found by luck.
            drawn[back] = 1.0
                    - Draws.stream(look.seed(), look.sensor(), drone, look.index() - back, Look.DETECTION)
                            .nextDouble();
        }
        Arrays.sort(drawn);
        return rule.probability(drawn[rule.hits() - 1]);
    }
}
