package org.dronewatch.placement.plan;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * A placement: a search for the sensors and positions that best serve an objective, such as coverage of the airspace,
 * within a budget.
 *
 * @param scene a packaged scene by name, or a scene file in the directory of this file or below it
 * @param drone the drone of the scene that is to be detected; the first by default
 * @param objective the quantity that is maximised: {@code coverage}; {@code warning-time}, the time from the first
 *     detection of the drone to its arrival at the protected zone; or {@code weakest-route}, the exposure on the least
 *     exposed route to that zone
 * @param warning the warning time that is maximised for {@code warning-time}: the {@code worst} over all bearings and
 *     heights, or the {@code mean}; {@code worst} by default
 * @param budget budget for all sensors except those that are kept, 0 to 1e12, in the currency of the scene's prices
 * @param candidates sensors that may be bought, by name; in the layout, the name of a bought sensor begins with this
 *     name
 * @param keep sensors of the scene that are kept, at no cost
 * @param conditions what the layout must meet, besides the budget
 * @param air airspace that is to be covered
 */
public record PlaceSettings(
        String scene,
        Optional<String> drone,
        PlaceObjective objective,
        WarningMeasure warning,
        @In(value = Quantity.NUMBER, from = 0, to = 1e12) double budget,
        Map<String, OfferSettings> candidates,
        List<String> keep,
        LayoutConditions conditions,
        AirSettings air) {
    private static final String NAME = "[A-Za-z0-9_-]{1,40}";

    /** Checks the limits and copies the map. */
    public PlaceSettings {
        Limits.check(PlaceSettings.class, scene, drone, objective, warning, budget, candidates, keep, conditions, air);
        candidates = Collections.unmodifiableMap(new LinkedHashMap<>(candidates));
        keep = List.copyOf(keep);
        candidates.keySet().forEach(name -> {
            if (!name.matches(NAME)) {
                throw new IllegalArgumentException(
                        "candidates." + name + ": a name must have 1 to 40 letters, digits, hyphens and underscores");
            }
        });
        if (!air.weights().isEmpty() && objective != PlaceObjective.COVERAGE) {
            throw new IllegalArgumentException("air.weights: has no meaning for the objective "
                    + objective.name().toLowerCase(Locale.ROOT).replace('_', '-')
                    + ": its value is not a sum over cells");
        }
        if (candidates.isEmpty()) {
            throw new IllegalArgumentException("candidates is empty: must name at least one sensor that may be bought");
        }
    }

    /** A search for the most coverage within a budget. */
    @Defaults({"scene", "budget", "candidates"})
    public static PlaceSettings of(String scene, double budget, Map<String, OfferSettings> candidates) {
        return new PlaceSettings(
                scene,
                Optional.empty(),
                PlaceObjective.COVERAGE,
                WarningMeasure.WORST,
                budget,
                candidates,
                List.of(),
                LayoutConditions.NONE,
                AirSettings.DEFAULT);
    }

    /** A copy with another budget. */
    public PlaceSettings withBudget(double other) {
        return SettingsForm.with(this, "budget", other);
    }
}
