package org.dronewatch.sensor.acoustic.level;

import java.util.Arrays;
import java.util.Optional;
import java.util.random.RandomGenerator;
import org.dronewatch.sensor.Signal;

/** The signal that a microphone receives from a drone in the level model, before any random decision. */
final class LevelAssessment {
    /** The number of times that a look is repeated if its result depends on its rays. */
    private static final int TRACES = 32;

    private static final double EVEN_CHANCE = 0.5;

    private static final String UNIT = "dB";

    private LevelAssessment() {}

    /** One look of the level model. */
    interface Look {
        /** Traces until the first ray that is loud enough. */
        LevelReading listen(RandomGenerator rays);
    }

    /** A better estimate of the probability, from the same random numbers as all further looks. */
    interface Refinement {
        /** Estimates the probability that a look detects the drone. */
        LookProbability.Estimate estimate(RandomGenerator rays);
    }

    /**
     * The signal in the level model. It is certain if the straight ray, which is traced first, is loud enough, or if
     * even that ray would be too quiet; otherwise, it is estimated from several looks. The first of these is the look
     * of a run with the same random numbers. The quantity of an estimate is the median of the best levels (the upper of
     * the two in the middle); if needed, it is another of these levels, so that it reaches the threshold if, and only
     * if, the probability is at least one half.
     *
     * @param others the looks after the first; if the ray budget ended a ray of the first, the further looks are like
     *     the first instead
     * @param refinement gives the probability if some of these looks detect the drone and some do not, unless the ray
     *     budget ended a ray of the first look; empty if the fraction of looks that detect it is accurate enough
     * @param isSideOnly whether the refinement is enough without these looks, unless the ray budget ended a ray of the
     *     first look; the quantity is then any value on the same side of the threshold as the median
     */
    static Signal signal(
            double straightLevel,
            double threshold,
            RandomGenerator rays,
            Look look,
            Look others,
            Optional<Refinement> refinement,
            boolean isSideOnly) {
        if (straightLevel < threshold) {
            return Signal.certain(straightLevel, UNIT, threshold);
        }
        LevelReading first = look.listen(rays);
        if (first.detected() && first.traced() == 1) {
            return Signal.certain(first.bestLevel(), UNIT, threshold);
        }
        if (isSideOnly && refinement.isPresent() && first.cutByBudget() == 0) {
            return signal(refinement.get().estimate(rays), first.bestLevel(), threshold);
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
        boolean isRefined = hits > 0 && hits < TRACES && first.cutByBudget() == 0;
        LookProbability.Estimate estimate = refinement
                .filter(any -> isRefined)
                .map(its -> its.estimate(rays))
                .orElse(new LookProbability.Estimate((double) hits / TRACES, error(hits)));
        // The median of the levels is used, unless the better estimate is on the other side of one half.
        int misses = TRACES - hits;
        int middle = estimate.value() >= EVEN_CHANCE ? Math.max(TRACES / 2, misses) : Math.min(TRACES / 2, misses - 1);
        return new Signal(estimate.value(), levels[middle], UNIT, threshold, 0.0, estimate.error());
    }

    /** A signal whose quantity is the level of a look if that is on the same side of the threshold. */
    private static Signal signal(LookProbability.Estimate estimate, double level, double threshold) {
        boolean isDetected = estimate.value() >= EVEN_CHANCE;
        double quantity =
                isDetected ? Math.max(level, threshold) : level < threshold ? level : Double.NEGATIVE_INFINITY;
        return new Signal(estimate.value(), quantity, UNIT, threshold, 0.0, estimate.error());
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
