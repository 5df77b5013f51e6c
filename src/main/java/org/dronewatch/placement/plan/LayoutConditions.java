package org.dronewatch.placement.plan;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * The conditions that the layout must meet, besides the budget.
 *
 * @param atMost maximum number of sensors in the layout, including those that are kept; no limit by default
 * @param fold number of sensors that must cover a cell for it to count, 1 to 10; 1 by default
 * @param anyoneLost what must remain after the loss of the sensor whose loss is worst; no requirement by default
 * @param base position of a base station, m: positions without a line of sight to it, as for a radio link, are left
 *     out; none by default
 */
public record LayoutConditions(
        @In(value = Quantity.NUMBER, from = 1, to = 1000) Optional<Integer> atMost,
        @In(value = Quantity.NUMBER, from = 1, to = 10) int fold,
        Optional<LossSettings> anyoneLost,
        Optional<Position> base) {
    /** No conditions. */
    @Defaults
    public static final LayoutConditions NONE =
            new LayoutConditions(Optional.empty(), 1, Optional.empty(), Optional.empty());

    /** Checks the limits. */
    public LayoutConditions {
        Limits.check(LayoutConditions.class, atMost, fold, anyoneLost, base);
    }
}
