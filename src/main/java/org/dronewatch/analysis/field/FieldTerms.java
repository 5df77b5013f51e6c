package org.dronewatch.analysis.field;

import java.util.Optional;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * The terms on which a field counts a drone as detected.
 *
 * @param within the time in which a sensor has to detect a drone that stays in its cell, above 0 and at most 86,400 s;
 *     empty for a single look
 */
public record FieldTerms(@In(value = Quantity.DURATION, above = 0, to = 86_400) Optional<Double> within) {
    /** A single look. */
    public static final FieldTerms ONE_LOOK = new FieldTerms(Optional.empty());

    /** So that the number of looks in 0.3 s at 10 Hz is three, whatever the product is rounded to. */
    private static final double ROUNDING = 1e-9;

    /** Checks the limits. */
    public FieldTerms {
        Limits.check(FieldTerms.class, within);
    }

    /** These terms with a time in which the drone has to be detected, s. */
    public FieldTerms withWithin(double seconds) {
        return new FieldTerms(Optional.of(seconds));
    }

    /**
     * The probability that a sensor detects a drone whose looks all have the same probability: in one look p itself, in
     * the n whole looks within a time {@code 1 - (1 - p)^n}. Where chance decides once per encounter, it is that of an
     * observer drawn at random who searches for as long as these looks take, n intervals between two of them:
     * {@code p (1 - exp(-p t / 3.4 s))}, the mean of {@link Chance#hazard} over all draws.
     *
     * @param look probability of one look, 0 to 1
     * @return 0 and 1 only where they are exact
     */
    double probability(double look, SensorSettings<?> sensor) {
        if (within.isEmpty() || look <= 0.0) {
            return look;
        }
        double looks = Math.floor(within.get() * sensor.rate() + ROUNDING);
        if (looks == 0.0) {
            return 0.0;
        }
        double detected;
        if (sensor.chance() == Chance.PER_ENCOUNTER) {
            double searched = looks / sensor.rate();
            detected = -look * StrictMath.expm1(-searched * sensor.chance().hazard(look, sensor.rate(), look));
        } else {
            detected = look == 1.0 ? 1.0 : Math.min(Math.nextDown(1.0), 1.0 - StrictMath.pow(1.0 - look, looks));
        }
        return Math.max(Double.MIN_VALUE, detected);
    }

    /** From which probability of a look on up to 1, exclusive, it does not matter how high it is. */
    double high(SensorSettings<?> sensor) {
        boolean isAnyAlike = within.isEmpty() || sensor.chance() == Chance.PER_LOOK;
        return isAnyAlike ? (SensorLayer.STEPS - 1.0) / SensorLayer.STEPS : 1.0;
    }
}
