package org.dronewatch.placement.site;

import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * What must remain after a loss.
 *
 * @param atLeast the least fraction of the air that is still covered or, for {@code weakest-route}, the least
 *     probability with which the drone is still detected on any route, 0 to 1
 */
public record LossSettings(@In(value = Quantity.RATIO, from = 0, to = 1) double atLeast) {
    /** Checks the limits. */
    public LossSettings {
        Limits.check(LossSettings.class, atLeast);
    }
}
