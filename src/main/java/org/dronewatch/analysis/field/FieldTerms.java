package org.dronewatch.analysis.field;

import java.util.Arrays;
import java.util.Optional;
import java.util.stream.DoubleStream;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * The terms on which a field counts a drone as detected.
 *
 * @param pointing how sensors on positioners point
 * @param within the time within which a sensor has to detect a drone that stays in its cell, above 0 and at most 86,400
 *     s; empty for a single look
 */
public record FieldTerms(
        Turning pointing, @In(value = Quantity.DURATION, above = 0, to = 86_400) Optional<Double> within) {
    /** How sensors on positioners point. */
    public enum Turning {
        /** They have turned to the drone, and zoomed in. */
        CUED,
        /** They search, or are at rest: their probability of detection is the mean over one period of the search. */
        SEARCH
    }

    /** A single look of sensors that have turned to the drone. */
    public static final FieldTerms ONE_LOOK = new FieldTerms(Turning.CUED, Optional.empty());

    /** A tolerance with which the number of looks in 0.3 s at 10 Hz is three, whatever the product is rounded to. */
    private static final double ROUNDING = 1e-9;

    /** Checks the limits. */
    public FieldTerms {
        Limits.check(FieldTerms.class, pointing, within);
    }

    /** These terms with a time within which the drone has to be detected, s. */
    public FieldTerms withWithin(double seconds) {
        return new FieldTerms(pointing, Optional.of(seconds));
    }

    /** These terms with another choice of how sensors point. */
    public FieldTerms withPointing(Turning other) {
        return new FieldTerms(other, within);
    }

    /**
     * The probability that a sensor detects a drone that stays where it is, if its looks have certain probabilities. In
     * one look, it is their mean p; in the n whole looks within a time {@code 1 - (1 - p)^n}. Where chance decides once
     * per encounter, it is that of an observer drawn at random who searches for as long as these looks take, n
     * intervals between two of them: {@code 1 - exp(-mean hazard * time)}, averaged over all draws, for a constant
     * probability {@code p (1 - exp(-p t / 3.4 s))}; see {@link Chance#hazard}.
     *
     * @param looks probabilities of looks that are evenly spaced in time, 0 to 1
     * @param share fraction of the time that they stand for; at other times the probability is 0
     * @return 0 and 1 only where they are exact
     */
    double probability(double[] looks, double share, SensorSettings<?> sensor) {
        double mean = looks.length == 0 ? 0.0 : share * DoubleStream.of(looks).sum() / looks.length;
        if (within.isEmpty() || mean <= 0.0) {
            return mean;
        }
        double number = Math.floor(within.get() * sensor.rate() + ROUNDING);
        if (number == 0.0) {
            return 0.0;
        }
        double detected;
        if (sensor.chance() == Chance.PER_ENCOUNTER) {
            detected = ofObservers(looks, share, number / sensor.rate(), sensor);
        } else {
            detected = mean >= 1.0 ? 1.0 : Math.min(Math.nextDown(1.0), 1.0 - StrictMath.pow(1.0 - mean, number));
        }
        return Math.max(Double.MIN_VALUE, detected);
    }

    /** The same for looks that all have one probability. */
    double probability(double look, SensorSettings<?> sensor) {
        return within.isEmpty() ? look : probability(new double[] {look}, 1.0, sensor);
    }

    /** The mean over observers: between two neighbouring probabilities, all draws give the same hazard. */
    private static double ofObservers(double[] looks, double share, double time, SensorSettings<?> sensor) {
        double[] sorted = looks.clone();
        Arrays.sort(sorted);
        double detected = 0.0;
        double hazard = 0.0;
        // Begins with the observers who need the highest probability: those who need less can use the other looks, too.
        for (int i = sorted.length - 1; i >= 0; i--) {
            double below = i == 0 ? 0.0 : sorted[i - 1];
            hazard += share * sensor.chance().hazard(sorted[i], sensor.rate(), sorted[i]) / sorted.length;
            detected -= (sorted[i] - below) * StrictMath.expm1(-hazard * time);
        }
        return detected;
    }

    /** The probability of a look at and above which all probabilities below 1 count as equal. */
    double high(SensorSettings<?> sensor) {
        boolean isAnyAlike = within.isEmpty() || sensor.chance() == Chance.PER_LOOK;
        return isAnyAlike ? (CellCode.STEPS - 1.0) / CellCode.STEPS : 1.0;
    }
}
