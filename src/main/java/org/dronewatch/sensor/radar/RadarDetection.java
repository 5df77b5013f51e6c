package org.dronewatch.sensor.radar;

import java.util.random.RandomGenerator;
import org.dronewatch.drone.RadarSignature.Fluctuation;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/** Decides from the signal-to-noise ratio whether an echo is detected. */
public sealed interface RadarDetection {
    /**
     * What an echo must reach in one look, dB.
     *
     * @param fluctuation of the target
     * @param random the look's random numbers
     */
    double threshold(Fluctuation fluctuation, RandomGenerator random);

    /**
     * The signal-to-noise ratio at which the probability of detection is 0.5, dB: for a fixed threshold, that
     * threshold.
     *
     * @param fluctuation of the target
     */
    double evenThreshold(Fluctuation fluctuation);

    /**
     * The probability that one look detects an echo, 0 to 1.
     *
     * @param signalToNoise dB
     * @param fluctuation of the target
     */
    double probability(double signalToNoise, Fluctuation fluctuation);

    /**
     * A fixed threshold, as in the thesis that this project grew from.
     *
     * @param signalToNoise signal-to-noise ratio, -50 to 100 dB
     */
    record FixedThreshold(@In(value = Quantity.LEVEL, from = -50, to = 100) double signalToNoise)
            implements RadarDetection {
        /** 15 dB. */
        @Defaults
        public static final FixedThreshold DEFAULT = new FixedThreshold(15.0);

        /** Checks the limit. */
        public FixedThreshold {
            Limits.check(FixedThreshold.class, signalToNoise);
        }

        @Override
        public double threshold(Fluctuation fluctuation, RandomGenerator random) {
            return signalToNoise;
        }

        @Override
        public double evenThreshold(Fluctuation fluctuation) {
            return signalToNoise;
        }

        @Override
        public double probability(double ratio, Fluctuation fluctuation) {
            return ratio >= signalToNoise ? 1.0 : 0.0;
        }
    }

    /**
     * Probabilistic: noise and the target's fluctuation make some looks succeed and others fail. A number between 0 and
     * 1 is drawn, and the ratio for which the probability of detection is that number is what this look's echo must
     * reach.
     *
     * @param falseAlarm probability that noise alone is taken for a target, 1e-12 to 0.01; to 0.001 with several pulses
     * @param pulses number of pulses per look that are integrated non-coherently, 1 to 1000; the signal-to-noise ratio
     *     is that of one of them
     */
    record Chance(
            @In(value = Quantity.NUMBER, from = 1e-12, to = 0.01) double falseAlarm,
            @In(value = Quantity.NUMBER, from = 1, to = 1000) int pulses)
            implements RadarDetection {
        /** Noise alone may be taken for a target, but not for a drone without an echo, dB. */
        private static final double FAINTEST = -100.0;

        /** Up to here the approximations for several pulses hold. */
        private static final double MAX_FALSE_ALARM_WITH_PULSES = 1e-3;

        private static final double EVEN_CHANCE = 0.5;

        /** Enough for a probability to a billionth. */
        private static final int HALVINGS = 30;

        /** One false alarm in a million, one pulse. */
        @Defaults
        public static final Chance DEFAULT = new Chance(1e-6, 1);

        /** Checks the limits. */
        public Chance {
            Limits.check(Chance.class, falseAlarm, pulses);
            if (pulses > 1 && falseAlarm > MAX_FALSE_ALARM_WITH_PULSES) {
                throw new IllegalArgumentException("falseAlarm " + falseAlarm + " must be at most "
                        + MAX_FALSE_ALARM_WITH_PULSES + " where several pulses are integrated, here " + pulses);
            }
        }

        @Override
        public double threshold(Fluctuation fluctuation, RandomGenerator random) {
            // 1 - u is above 0, so that the ratio is finite at that end, too; below 1 by as much as u can be small.
            double probability = Math.min(1.0 - 1e-9, 1.0 - random.nextDouble());
            return Math.max(FAINTEST, Detectability.required(probability, falseAlarm, fluctuation, pulses));
        }

        @Override
        public double evenThreshold(Fluctuation fluctuation) {
            return Math.max(FAINTEST, Detectability.required(EVEN_CHANCE, falseAlarm, fluctuation, pulses));
        }

        @Override
        public double probability(double ratio, Fluctuation fluctuation) {
            if (ratio < FAINTEST) {
                return 0.0;
            }
            if (pulses == 1) {
                return Detectability.probability(ratio, falseAlarm, fluctuation);
            }
            double no = 0.0;
            double yes = 1.0;
            for (int i = 0; i < HALVINGS; i++) {
                double middle = 0.5 * (no + yes);
                boolean enough = Detectability.required(middle, falseAlarm, fluctuation, pulses) <= ratio;
                no = enough ? middle : no;
                yes = enough ? yes : middle;
            }
            return 0.5 * (no + yes);
        }
    }
}
