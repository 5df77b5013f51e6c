package org.dronewatch.sensor.radar;

import java.util.random.RandomGenerator;
import org.dronewatch.drone.RadarSignature;
import org.dronewatch.drone.RadarSignature.Fluctuation;
import org.dronewatch.sensor.Reading;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/** A detection function of a radar: decides from the signal-to-noise ratio whether an echo is detected. */
public sealed interface RadarDetection {
    /** The unit of signal-to-noise ratios. */
    String DECIBELS = "dB";

    /**
     * The decision on echoes of targets with a given fluctuation.
     *
     * @param fluctuation fluctuation of the target
     */
    Decision on(Fluctuation fluctuation);

    /**
     * The decision on echoes of targets whose cross-section is log-normally distributed from look to look.
     *
     * @param spread standard deviation of the cross-section in decibels, above 0 and at most 20 dB
     */
    Decision on(double spread);

    /** The decision on echoes of targets with a given radar signature. */
    default Decision on(RadarSignature signature) {
        double deviation = signature.deviation();
        return deviation > 0.0 ? on(deviation) : on(signature.fluctuation());
    }

    /** The number of pulses per look that are integrated non-coherently, 1 to 1000. */
    default int pulses() {
        return 1;
    }

    /**
     * The reading of noise that exceeds the threshold.
     *
     * @param excess excess of the noise power over the threshold, divided by the mean noise power: 0 or more,
     *     exponentially distributed with mean 1
     */
    Reading noise(double excess);

    /** A decision on the echoes of targets with one kind of fluctuation. */
    interface Decision {
        /**
         * The signal-to-noise ratio that an echo must reach in one look, dB.
         *
         * @param random the look's random numbers
         */
        double threshold(RandomGenerator random);

        /**
         * The signal-to-noise ratio at which the probability of detection is 0.5, dB: for a fixed threshold, that
         * threshold.
         */
        double evenThreshold();

        /**
         * The probability that one look detects an echo, 0 to 1.
         *
         * @param signalToNoise signal-to-noise ratio of a pulse, averaged over the fluctuation, dB
         */
        double probability(double signalToNoise);
    }

    /**
     * Detection without chance: an echo is detected if its signal-to-noise ratio reaches a fixed threshold. A
     * fluctuating target requires an average ratio that is higher by the fluctuation loss (L. V. Blake, Radar
     * Range-Performance Analysis, chapter 2): the difference between the ratios that a fluctuating and a steady target
     * require for a probability of detection of 0.9 and a probability of false alarm of 1e-6, with one pulse.
     *
     * @param signalToNoise signal-to-noise ratio that a steady target must reach, -50 to 100 dB
     */
    record FixedThreshold(@In(value = Quantity.LEVEL, from = -50, to = 100) double signalToNoise)
            implements RadarDetection {
        /** 15 dB. */
        @Defaults
        public static final FixedThreshold DEFAULT = new FixedThreshold(15.0);

        private static final double USUAL_PROBABILITY = 0.9;
        private static final double USUAL_FALSE_ALARM = 1e-6;

        /** Checks the limit. */
        public FixedThreshold {
            Limits.check(FixedThreshold.class, signalToNoise);
        }

        @Override
        public Decision on(Fluctuation fluctuation) {
            return from(fluctuation == Fluctuation.STEADY ? signalToNoise : signalToNoise + loss(fluctuation));
        }

        @Override
        public Decision on(double spread) {
            SquareLawDetector detector = new SquareLawDetector(USUAL_FALSE_ALARM, 1);
            double loss = new LogNormalEcho(detector, spread).required(USUAL_PROBABILITY)
                    - detector.required(USUAL_PROBABILITY, Fluctuation.STEADY);
            return from(signalToNoise + loss);
        }

        @Override
        public Reading noise(double excess) {
            double power = Math.pow(10.0, 0.1 * signalToNoise) + excess;
            return new Reading(Math.max(signalToNoise, 10.0 * Math.log10(power)), signalToNoise, DECIBELS);
        }

        private static Decision from(double least) {
            return new Decision() {
                @Override
                public double threshold(RandomGenerator random) {
                    return least;
                }

                @Override
                public double evenThreshold() {
                    return least;
                }

                @Override
                public double probability(double ratio) {
                    return ratio >= least ? 1.0 : 0.0;
                }
            };
        }

        private static double loss(Fluctuation fluctuation) {
            SquareLawDetector detector = new SquareLawDetector(USUAL_FALSE_ALARM, 1);
            return detector.required(USUAL_PROBABILITY, fluctuation)
                    - detector.required(USUAL_PROBABILITY, Fluctuation.STEADY);
        }
    }

    /**
     * Probabilistic detection: in each look, noise and the target's fluctuation determine whether the echo is detected.
     * A number between 0 and 1 is drawn, and the threshold of the look is the ratio for which the probability of
     * detection is that number.
     *
     * @param falseAlarm probability of a false alarm, 1e-12 to 0.01
     * @param pulses number of pulses per look that are integrated non-coherently, 1 to 1000; the signal-to-noise ratio
     *     is that of one of them, and each takes the whole {@code integrationTime} of the budget
     */
    record Chance(
            @In(value = Quantity.NUMBER, from = 1e-12, to = 0.01) double falseAlarm,
            @In(value = Quantity.NUMBER, from = 1, to = 1000) int pulses)
            implements RadarDetection {
        /**
         * Signal-to-noise ratio below which a drone counts as having no echo, dB: noise alone may be mistaken for a
         * target, but does not count as a detection of such a drone.
         */
        private static final double FAINTEST = -100.0;

        private static final double EVEN_CHANCE = 0.5;

        /** A probability of false alarm of one in a million, and one pulse. */
        @Defaults
        public static final Chance DEFAULT = new Chance(1e-6, 1);

        /** Checks the limits. */
        public Chance {
            Limits.check(Chance.class, falseAlarm, pulses);
        }

        @Override
        public Decision on(Fluctuation fluctuation) {
            SquareLawDetector detector = new SquareLawDetector(falseAlarm, pulses);
            double even = Math.max(FAINTEST, detector.required(EVEN_CHANCE, fluctuation));
            return new Decision() {
                @Override
                public double threshold(RandomGenerator random) {
                    // 1 - u is above 0, so that the ratio is finite at that end, too; the minimum keeps it below 1.
                    double probability = Math.min(1.0 - 1e-9, 1.0 - random.nextDouble());
                    return Math.max(FAINTEST, detector.required(probability, fluctuation));
                }

                @Override
                public double evenThreshold() {
                    return even;
                }

                @Override
                public double probability(double ratio) {
                    return ratio < FAINTEST ? 0.0 : detector.probability(ratio, fluctuation);
                }
            };
        }

        /** {@inheritDoc} The value is the mean over the pulses, dB relative to the mean noise of one pulse. */
        @Override
        public Reading noise(double excess) {
            return new SquareLawDetector(falseAlarm, pulses).noise(excess);
        }

        /** {@inheritDoc} In each look, noise and cross-section are drawn independently. */
        @Override
        public Decision on(double spread) {
            SquareLawDetector detector = new SquareLawDetector(falseAlarm, pulses);
            LogNormalEcho echo = new LogNormalEcho(detector, spread);
            Decision steady = on(Fluctuation.STEADY);
            double even = Math.max(FAINTEST, echo.required(EVEN_CHANCE));
            return new Decision() {
                @Override
                public double threshold(RandomGenerator random) {
                    double ofSteady = steady.threshold(random);
                    return Math.max(FAINTEST, ofSteady - echo.excess(random.nextGaussian()));
                }

                @Override
                public double evenThreshold() {
                    return even;
                }

                @Override
                public double probability(double ratio) {
                    return ratio < FAINTEST ? 0.0 : echo.probability(ratio);
                }
            };
        }
    }
}
