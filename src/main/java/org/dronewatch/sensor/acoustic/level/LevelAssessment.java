package org.dronewatch.sensor.acoustic.level;

import java.util.Arrays;
import java.util.random.RandomGenerator;
import org.dronewatch.sensor.Signal;

/** The signal that a microphone receives from a drone in the level model, before any random decision. */
final class LevelAssessment {
    /** How many times a look is repeated where it depends on its rays. */
    private static final int TRACES = 32;

    private static final String UNIT = "dB";

    private LevelAssessment() {}

    /** One look of the level model. */
    interface Look {
        /** Traces until the first ray that is loud enough. */
        LevelReading listen(RandomGenerator rays);
    }

    /**
     * The signal in the level model. It is certain where the straight ray, which is traced first, is loud enough, and
     * where even that ray would be too quiet; otherwise it is estimated from several looks. The first of these is the
     * look of a run with the same random numbers. The quantity of an estimate is the median of the best levels, the
     * upper of the two in the middle, so that it reaches the threshold when half of the looks do.
     *
     * @param others the looks after the first, unless the ray budget ended a ray of the first: then they
     *     are like the first
     */
    static Signal signal(double straightLevel, double threshold, RandomGenerator rays, Look look, Look others) {
        if (straightLevel < threshold) {
            return Signal.certain(straightLevel, UNIT, threshold);
        }
        LevelReading first = look.listen(rays);
        if (first.detected() && first.traced() == 1) {
            return Signal.certain(first.bestLevel(), UNIT, threshold);
        }
        double[] levels = new double[TRACES];
        levels[0] = first.bestLevel();
        int hits = first.detected() ? 1 : 0;
        Look repeated = first.cutByBudget() == 0 ? others : look;
        for (int i = 1; i < TRACES; i++) {
            LevelReading next = repeated.listen(rays);
            levels[i] = next.bestLevel();
            hits += next.detected() ? 1 : 0;
        }
        Arrays.sort(levels);
        double probability = (double) hits / TRACES;
        return new Signal(probability, levels[TRACES / 2], UNIT, threshold, 0.0, error(hits));
    }

    /**
     * Standard error of a fraction of looks: the standard deviation of the beta distribution of the probability, with a
     * uniform prior, so that it is above 0 even if none or all of the looks detect.
     */
    private static double error(int hits) {
        double no = TRACES - hits + 1.0;
        double all = TRACES + 2.0;
        return Math.sqrt((hits + 1.0) * no / (all * all * (all + 1.0)));
    }
}
