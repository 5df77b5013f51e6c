package org.dronewatch.placement.site;

import org.dronewatch.placement.plan.PlaceObjective;
import org.dronewatch.placement.plan.PlaceSettings;
import org.dronewatch.placement.plan.WarningMeasure;

/** How the order in which to buy the sensors of a layout is found. */
public enum BuyingRule {
    /** From the first purchase onwards: at each step, the sensor that adds the most for its price is bought. */
    MOST_ADDED,

    /**
     * From the last purchase backwards: at each step, the sensor that contributes least per unit of price is left out.
     * Used where several sensors must detect the drone, since the first of them are worth nothing by themselves.
     */
    LEAST_LOST,

    /**
     * From the last purchase backwards: each step leaves out the sensor without which the worst case is best or, in a
     * tie, the one that contributes least over all cases per unit of price. Used where only the worst case counts,
     * since the first sensors often do not improve it.
     */
    BEST_LEFT;

    /** The rule for an objective and its conditions. */
    static BuyingRule of(PlaceSettings settings) {
        boolean isWorst = settings.objective() == PlaceObjective.WEAKEST_ROUTE
                || settings.objective() == PlaceObjective.WARNING_TIME && settings.warning() == WarningMeasure.WORST;
        if (isWorst) {
            return BEST_LEFT;
        }
        return settings.conditions().fold() > 1 ? LEAST_LOST : MOST_ADDED;
    }
}
