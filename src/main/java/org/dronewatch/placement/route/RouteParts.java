package org.dronewatch.placement.route;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.placement.site.PlaceStep;
import org.dronewatch.placement.site.PresentLayout;

/**
 * Figures of parts of a layout, and of the scene's own sensors. For each of these figures, routes have to be searched
 * for.
 *
 * @param alone by name of the sensor, the value of a layout of that sensor alone; empty if not computed
 * @param withoutEach by name of the sensor, the value of the layout without that sensor; empty if not computed
 * @param purchases the order in which to buy the sensors, after those that are kept; empty if not computed
 * @param present the scene's own sensors; empty if it has none, or they were not assessed
 * @param remaining if no layout raises the exposure on the weakest route above 0, the weakest routes past all
 *     affordable candidates together, from each direction under each condition, the weakest of all first; otherwise
 *     empty
 */
public record RouteParts(
        Map<String, Double> alone,
        Map<String, Double> withoutEach,
        List<PlaceStep> purchases,
        Optional<PresentLayout> present,
        List<DirectedRoute> remaining) {
    /** No figures. */
    static final RouteParts NONE = new RouteParts(Map.of(), Map.of(), List.of(), Optional.empty(), List.of());

    /** Copies the lists and maps. */
    public RouteParts {
        alone = Collections.unmodifiableMap(new LinkedHashMap<>(alone));
        withoutEach = Collections.unmodifiableMap(new LinkedHashMap<>(withoutEach));
        purchases = List.copyOf(purchases);
        remaining = List.copyOf(remaining);
    }
}
