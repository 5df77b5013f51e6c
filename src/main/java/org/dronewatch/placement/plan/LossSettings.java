package org.dronewatch.placement.plan;

import java.util.Optional;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * What must remain after a loss.
 *
 * @param atLeast minimum fraction of the airspace that must still be covered or, for {@code weakest-route}, minimum
 *     probability with which the drone must still be detected on any route, 0 to 1
 * @param warning minimum warning time that must remain, for {@code warning-time}, s
 */
public record LossSettings(
        @In(value = Quantity.RATIO, from = 0, to = 1) Optional<Double> atLeast,
        @In(value = Quantity.DURATION, from = 0, to = 86_400) Optional<Double> warning) {
    /** No requirement. */
    @Defaults
    public static final LossSettings NONE = new LossSettings(Optional.empty(), Optional.empty());

    /** Checks the limits. */
    public LossSettings {
        Limits.check(LossSettings.class, atLeast, warning);
    }

    /**
     * The fraction or probability.
     *
     * @throws InputException when another quantity is given, or none
     */
    public double fraction() {
        if (atLeast.isEmpty() || warning.isPresent()) {
            throw new InputException("conditions.anyoneLost: must have only 'atLeast' for this objective");
        }
        return atLeast.get();
    }

    /**
     * The warning time, s.
     *
     * @throws InputException when another quantity is given, or none
     */
    public double seconds() {
        if (warning.isEmpty() || atLeast.isPresent()) {
            throw new InputException("conditions.anyoneLost: must have only 'warning' for this objective");
        }
        return warning.get();
    }
}
