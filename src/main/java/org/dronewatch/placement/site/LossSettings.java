package org.dronewatch.placement.site;

import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * The coverage that must remain after a loss.
 *
 * @param atLeast the least fraction of the air that is still covered, 0 to 1
 */
public record LossSettings(@In(value = Quantity.RATIO, from = 0, to = 1) double atLeast) {
    /** Checks the limits. */
    public LossSettings {
        Limits.check(LossSettings.class, atLeast);
    }
}
