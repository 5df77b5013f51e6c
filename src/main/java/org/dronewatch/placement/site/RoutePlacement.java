package org.dronewatch.placement.site;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.analysis.field.FieldGrid;
import org.dronewatch.placement.PlacementResult;
import org.dronewatch.route.search.WeakestRoute;

/**
 * The best layout that was found against the weakest of all routes. Values are exposures on the least exposed route,
 * capped at {@link WeakestRouteSearch#ENOUGH}.
 *
 * @param plan what was asked for
 * @param grid the cells over which routes are searched for
 * @param result of the search
 * @param weakest the least exposed route past the layout
 * @param lower a certified lower bound of the exposure of all routes past the layout
 * @param alone by the name of each sensor, the value of a layout of it alone; empty if that was not computed
 * @param without by the name of each sensor, the value without it; empty if that was not computed
 * @param front the order in which to buy the sensors, after those that are kept; empty if it was not computed
 * @param present the scene's own sensors; empty if it has none, or the search was interrupted before they were assessed
 * @param rounds number of layouts whose routes were searched for
 * @param routes number of routes that were compared
 * @param complete whether every candidate was assessed and the search ended by itself
 */
public record RoutePlacement(
        PlacePlan plan,
        FieldGrid grid,
        PlacementResult result,
        WeakestRoute weakest,
        double lower,
        Map<String, Double> alone,
        Map<String, Double> without,
        List<PlaceStep> front,
        Optional<PresentLayout> present,
        int rounds,
        int routes,
        boolean complete) {
    /** Copies the lists and maps. */
    public RoutePlacement {
        alone = Collections.unmodifiableMap(new LinkedHashMap<>(alone));
        without = Collections.unmodifiableMap(new LinkedHashMap<>(without));
        front = List.copyOf(front);
    }

    /** The sensors of the layout, in the order of the file. */
    public List<SiteCandidate> chosen() {
        return result.chosen().stream().map(plan.candidates()::get).toList();
    }

    /** The probability of at least one detection along a route of some exposure, 0 to 1. */
    public static double detection(double exposure) {
        return -Math.expm1(-exposure);
    }
}
