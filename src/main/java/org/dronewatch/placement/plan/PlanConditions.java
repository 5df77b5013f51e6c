package org.dronewatch.placement.plan;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.placement.KindLimits;
import org.dronewatch.placement.PlacementConditions;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Quantity;

/** What a plan demands of a layout, whatever its objective. */
public final class PlanConditions {
    private PlanConditions() {}

    /** The conditions, except the one on what must remain after a loss. */
    public static PlacementConditions of(PlacePlan plan) {
        LayoutConditions asked = plan.settings().conditions();
        Map<String, KindLimits> kinds = new HashMap<>();
        plan.settings()
                .candidates()
                .forEach((name, offer) -> kinds.put(
                        name, new KindLimits(offer.atLeast(), offer.atMost().orElse(Integer.MAX_VALUE))));
        return PlacementConditions.NONE
                .withBudget(plan.settings().budget())
                .withAtMost(asked.atMost().orElse(Integer.MAX_VALUE))
                .withKinds(kinds)
                .withFold(asked.fold())
                .withNeedsOneOf(new Cues(plan).needed());
    }

    /**
     * The exception for the case that no layout complies.
     *
     * @param remaining what must remain after a loss, in words; empty if nothing must
     */
    public static InputException impossible(PlacePlan plan, Optional<String> remaining) {
        return new InputException(
                "budget " + Quantity.NUMBER.inWords(plan.settings().budget())
                        + ": no layout was found that keeps to it and to the limits on the numbers of sensors"
                        + remaining
                                .map(what -> ", and leaves " + what + " after the loss of any one sensor")
                                .orElse(""));
    }
}
