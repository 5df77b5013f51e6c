package org.dronewatch.sensor;

/**
 * Whether chance decides anew in each look at a drone, or once per encounter with it. This determines the rate of
 * detection that follows from a probability.
 */
public enum Chance {
    /**
     * Chance decides in each look independently, as echoes and noise fluctuate. This also applies to a sensor that
     * compares an exact value with a threshold: its probability is 0 or 1.
     */
    PER_LOOK {
        @Override
        public double hazard(double probability, double rate, double draw) {
            return -rate * Math.log1p(-probability);
        }
    },
    /**
     * Chance decides once per {@link Encounter}: the probability is the fraction of observers who can find the drone at
     * all, and an observer who can find it needs time to do so.
     */
    PER_ENCOUNTER {
        @Override
        public double hazard(double probability, double rate, double draw) {
            return probability >= draw ? probability / Encounter.SEARCH_TIME : 0.0;
        }
    };

    /**
     * The rate of the first detection, given that there has been none yet, 1/s. The probability of a detection within
     * some time is {@code 1 - exp(-integral of the hazard)}; where chance decides once per encounter, that is the
     * probability for one observer, and its mean over all draws is the probability for an observer drawn at random.
     *
     * @param probability probability of the sensor's {@link Signal}, 0 to 1
     * @param rate looks per second, Hz
     * @param draw the observer's number in this encounter, above 0 and at most 1, uniformly distributed; it has no
     *     effect where chance decides in each look
     * @return 0 or more; infinite where chance decides in each look and the probability is 1
     */
    public abstract double hazard(double probability, double rate, double draw);
}
