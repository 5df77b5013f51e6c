package org.dronewatch.analysis.cell;

import java.util.Optional;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.ProbabilityResolution;
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
        /** Sensors on positioners have turned to the drone, and zoomed in. */
        CUED,
        /**
         * Sensors on positioners search, or are at rest: their probability of detection is a mean over one search
         * period, in which the look, or the time within which they have to detect the drone, may begin at any moment.
         */
        SEARCH
    }

    /** A single look of sensors that have turned to the drone. */
    public static final FieldTerms ONE_LOOK = new FieldTerms(Turning.CUED, Optional.empty());

    /**
     * A tolerance for the rounding of numbers: with it, the number of looks in 0.3 s at 10 Hz is three, whatever the
     * product is rounded to.
     */
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
     * The number of whole looks that a sensor takes within the time of these terms, 0 or more; 1 if the terms state no
     * time.
     */
    public long looks(SensorSettings<?> sensor) {
        return within.map(seconds -> (long) Math.floor(seconds * sensor.rate() + ROUNDING))
                .orElse(1L);
    }

    /**
     * The probability that a sensor detects a drone that stays where it is, if all its looks have the same probability
     * p of detecting it: in one look, p; in the n whole looks within a time, {@code 1 - (1 - p)^n}. Where chance
     * decides once per encounter, the probability is that of an observer drawn at random who searches for as long as
     * the looks take, that is, for the time t of n intervals between looks: {@code p (1 - exp(-p t / 3.4 s))}; see
     * {@link Chance#hazard}. For a sensor that searches, whose looks differ, see {@code LookWindow}.
     *
     * @param look probability that a single look detects the drone, 0 to 1
     * @return the probability, 0 to 1; 0 or 1 only where this is exact
     */
    public double probability(double look, SensorSettings<?> sensor) {
        if (within.isEmpty() || look <= 0.0) {
            return look;
        }
        long number = looks(sensor);
        if (number == 0) {
            return 0.0;
        }
        double detected;
        if (sensor.chance() == Chance.PER_ENCOUNTER) {
            double hazard = sensor.chance().hazard(look, sensor.rate(), look);
            detected = -look * StrictMath.expm1(-hazard * number / sensor.rate());
        } else {
            detected = look >= 1.0 ? 1.0 : Math.min(Math.nextDown(1.0), 1.0 - StrictMath.pow(1.0 - look, number));
        }
        return Math.max(Double.MIN_VALUE, detected);
    }

    /** How finely a field resolves the probability that a look of a sensor detects the drone. */
    public ProbabilityResolution resolution(SensorSettings<?> sensor) {
        boolean isAnyAlike = within.isEmpty() || sensor.chance() == Chance.PER_LOOK;
        return ProbabilityResolution.upTo(isAnyAlike ? ProbabilityStep.probability(ProbabilityStep.CERTAIN - 1) : 1.0);
    }

    /**
     * How finely a field resolves the probability that a look of a sensor detects the drone, if all that matters is
     * whether the probability on these terms reaches a step.
     *
     * @param step the step to be reached, above 0 and at most {@link ProbabilityStep#CERTAIN}
     */
    public ProbabilityResolution sideOf(int step, SensorSettings<?> sensor) {
        double least = ProbabilityStep.least(step);
        if (least == 0.0 || step == ProbabilityStep.CERTAIN) {
            return resolution(sensor);
        }
        // Exactly between two steps, rounding decides.
        double reached = least + ROUNDING;
        if (within.isEmpty()) {
            return ProbabilityResolution.sideOf(reached);
        }
        long number = looks(sensor);
        return number == 0 || sensor.chance() != Chance.PER_LOOK
                ? resolution(sensor)
                : ProbabilityResolution.sideOf(1.0 - StrictMath.pow(1.0 - reached, 1.0 / number));
    }
}
