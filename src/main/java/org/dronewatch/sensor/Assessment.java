package org.dronewatch.sensor;

import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.world.Obstacle;

/**
 * The deterministic part of a look: the probability that a sensor detects a drone in a given state of flight and, if
 * the drone is missed, the reason. The random part is drawn with that probability.
 *
 * @param signal the signal that the sensor receives from the drone
 * @param explanation why the signal is insufficient; {@link Explanation#DETECTED} when it is sufficient
 */
public record Assessment(Signal signal, Explanation explanation) {
    /**
     * Checks that the signal and the explanation agree.
     *
     * @throws IllegalArgumentException when a detected drone has the cause of a miss, or a missed drone the cause
     *     {@link Cause#DETECTED}; {@link Cause#UNKNOWN} agrees with either
     */
    public Assessment {
        if (explanation.cause() != Cause.UNKNOWN && signal.isDetected() != (explanation.cause() == Cause.DETECTED)) {
            throw new IllegalArgumentException("quantity " + signal.quantity() + " with threshold " + signal.threshold()
                    + " does not agree with cause " + explanation.cause());
        }
    }

    /**
     * The probability that one look detects the drone or, for a sensor of {@link Chance#PER_ENCOUNTER}, that its
     * observer can detect it, 0 to 1.
     */
    public double probability() {
        return signal.probability();
    }

    /**
     * The rate of the first detection, given that there has been none yet, 1/s; see {@link Chance#hazard}.
     *
     * @param settings settings of the sensor that was assessed
     * @param draw number drawn for the observer, above 0 and at most 1; it has no effect for a sensor of
     *     {@link Chance#PER_LOOK}. To predict the detections of an observer drawn at random, average the probability of
     *     a detection over many draws, such as 1/32, 3/32, ... 31/32
     */
    public double hazard(SensorSettings<?> settings, double draw) {
        return settings.chance().hazard(probability(), settings.rate(), draw);
    }

    /** The measured quantity, in {@link #unit}. */
    public double quantity() {
        return signal.quantity();
    }

    /** Unit of the quantity, the threshold, the margin and the standard error; empty for a ratio. */
    public String unit() {
        return signal.unit();
    }

    /**
     * The threshold of the quantity for a detection; for a probabilistic sensor, the value at which the detection
     * probability is 0.5.
     */
    public double threshold() {
        return signal.threshold();
    }

    /**
     * Quantity minus threshold: negative where the signal is insufficient, minus infinity where nothing reaches the
     * sensor and the unit is dB.
     */
    public double margin() {
        return signal.quantity() - signal.threshold();
    }

    /** The margin in dB; see {@link Signal#marginDb}. */
    public double marginDb() {
        return signal.marginDb();
    }

    /** Standard error of the quantity, in its unit; 0 where it is exact. */
    public double standardError() {
        return signal.standardError();
    }

    /** Standard error of the probability; 0 where it is exact. */
    public double probabilityError() {
        return signal.probabilityError();
    }

    /** Whether the quantity or the probability is an estimate. */
    public boolean isEstimated() {
        return standardError() > 0.0 || probabilityError() > 0.0;
    }

    /** The reason why the drone is not detected; {@link Cause#DETECTED} if it is detected. */
    public Cause cause() {
        return explanation.cause();
    }

    /** The obstacle that hides the drone; empty unless the cause is {@link Cause#isHidden() that it is hidden}. */
    public Optional<Obstacle> obstacle() {
        return explanation.obstacle();
    }

    /**
     * The limit that the drone violates: a range, m, a radial speed, m/s, or a carrier frequency, Hz; empty for causes
     * without such a limit, and where the limit is unknown.
     */
    public OptionalDouble limit() {
        return explanation.limit();
    }
}
