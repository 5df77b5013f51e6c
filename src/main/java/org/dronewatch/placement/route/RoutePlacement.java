package org.dronewatch.placement.route;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.placement.PlacementResult;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.plan.SiteCandidate;
import org.dronewatch.placement.site.PlaceStep;
import org.dronewatch.placement.site.PlacedLayout;
import org.dronewatch.placement.site.PresentLayout;
import org.dronewatch.route.search.WeakestRoute;

/**
 * The best layout that was found against the weakest of all routes. Values are exposures on the least exposed route,
 * capped at {@link WeakestRouteSearch#ENOUGH}.
 *
 * @param plan what was asked for
 * @param grid the cells over which routes are searched for
 * @param result result of the search
 * @param weakest the least exposed route past the layout
 * @param bearing bearing of the direction from which that route comes, clockwise from north, rad
 * @param lower a certified lower bound on the exposure along any route past the layout
 * @param alone by the name of each sensor, the value of a layout of that sensor alone; empty if it was not computed
 * @param withoutEach by the name of each sensor, the value without that sensor; empty if it was not computed
 * @param purchases the order in which to buy the sensors, after those that are kept; empty if it was not computed
 * @param present the scene's own sensors; empty if it has none, or the search was interrupted before they were assessed
 * @param rounds number of layouts whose routes were searched for
 * @param routes number of routes that were compared
 * @param complete whether every candidate was assessed and the search ran to completion
 */
public record RoutePlacement(
        PlacePlan plan,
        FieldGrid grid,
        PlacementResult result,
        WeakestRoute weakest,
        double bearing,
        double lower,
        Map<String, Double> alone,
        Map<String, Double> withoutEach,
        List<PlaceStep> purchases,
        Optional<PresentLayout> present,
        int rounds,
        int routes,
        boolean complete)
        implements PlacedLayout {
    /** Copies the lists and maps. */
    public RoutePlacement {
        alone = Collections.unmodifiableMap(new LinkedHashMap<>(alone));
        withoutEach = Collections.unmodifiableMap(new LinkedHashMap<>(withoutEach));
        purchases = List.copyOf(purchases);
    }

    @Override
    public double value() {
        return result.value();
    }

    @Override
    public double bound() {
        return result.bound();
    }

    @Override
    public OptionalDouble alone(SiteCandidate sensor) {
        Double known = alone.get(sensor.name());
        return known == null ? OptionalDouble.empty() : OptionalDouble.of(known);
    }

    /** The same with another bound; none below the value. */
    RoutePlacement within(double bound) {
        double atLeast = Math.max(result.value(), bound);
        return new RoutePlacement(
                plan,
                grid,
                new PlacementResult(result.chosen(), result.value(), atLeast, result.cost(), result.complete()),
                weakest,
                bearing,
                lower,
                alone,
                withoutEach,
                purchases,
                present,
                rounds,
                routes,
                complete);
    }

    /** The probability of at least one detection along a route with a given exposure, 0 to 1. */
    public static double detection(double exposure) {
        return -Math.expm1(-exposure);
    }
}
