package org.dronewatch.placement.site;

import java.util.Optional;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * What the layout must comply with, beside the budget.
 *
 * @param atMost number of sensors that it may have, those that are kept among them; any by default
 * @param fold number of sensors that must cover a cell for it to count, 1 to 10; 1 by default
 * @param anyoneLost what must remain covered after the loss of the sensor whose loss is worst
 */
public record LayoutConditions(
        @In(value = Quantity.NUMBER, from = 1, to = 1000) Optional<Integer> atMost,
        @In(value = Quantity.NUMBER, from = 1, to = 10) int fold,
        Optional<LossSettings> anyoneLost) {
    /** No condition. */
    @Defaults
    public static final LayoutConditions NONE = new LayoutConditions(Optional.empty(), 1, Optional.empty());

    /** Checks the limits. */
    public LayoutConditions {
        Limits.check(LayoutConditions.class, atMost, fold, anyoneLost);
    }
}
