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

/**
 * The best layout that was found against the weakest of all routes. Values are exposures on the least exposed route,
 * capped at {@link WeakestRouteSearch#ENOUGH}; with several conditions, the exposure under the worst of them counts.
 *
 * @param plan what was asked for
 * @param grid the cells over which routes are searched for
 * @param result result of the search
 * @param weakest the least exposed route past the layout
 * @param lower a certified lower bound on the exposure along any route past the layout
 * @param asItIs value in the scene as it is
 * @param byCondition the value under each condition, by its name
 * @param parts figures of parts of the layout, and of the scene's own sensors
 * @param rounds number of layouts past which routes were searched for
 * @param routes number of routes that were compared
 * @param complete whether the search ran to completion and the computation of the figures of the parts, if any, was not
 *     interrupted
 */
public record RoutePlacement(
        PlacePlan plan,
        FieldGrid grid,
        PlacementResult result,
        DirectedRoute weakest,
        double lower,
        double asItIs,
        Map<String, Double> byCondition,
        RouteParts parts,
        int rounds,
        int routes,
        boolean complete)
        implements PlacedLayout {
    /** Copies the map. */
    public RoutePlacement {
        byCondition = Collections.unmodifiableMap(new LinkedHashMap<>(byCondition));
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
        Double known = parts.alone().get(sensor.name());
        return known == null ? OptionalDouble.empty() : OptionalDouble.of(known);
    }

    /**
     * The weakest routes past all affordable candidates together, from each direction under each condition, the weakest
     * of all first: no layout can close the gaps that these candidates leave. Empty if the value of the layout is above
     * 0.
     */
    public List<DirectedRoute> remaining() {
        return parts.remaining();
    }

    /**
     * The number of candidates that may be in a layout: the scene's sensors that are kept in every layout, and the
     * candidates that individually cost no more than the budget.
     */
    public int affordable() {
        return RouteFigures.affordable(plan).size();
    }

    @Override
    public Map<String, Double> withoutEach() {
        return parts.withoutEach();
    }

    /**
     * The names of the sensors whose loss is worst, by the value that remains without each of them: several if these
     * values are equal; all values of {@link WeakestRouteSearch#ENOUGH} or more count as equal. Empty if these values
     * were not computed.
     */
    public List<String> worstLosses() {
        double least = withoutEach().values().stream()
                .mapToDouble(Double::doubleValue)
                .min()
                .orElse(0.0);
        return withoutEach().entrySet().stream()
                .filter(one -> one.getValue() <= (1.0 + RouteFigures.ROUNDING) * least)
                .map(Map.Entry::getKey)
                .toList();
    }

    @Override
    public List<PlaceStep> purchases() {
        return parts.purchases();
    }

    @Override
    public Optional<PresentLayout> present() {
        return parts.present();
    }

    /** This placement with another bound; none below the value. */
    RoutePlacement within(double bound) {
        double atLeast = Math.max(result.value(), bound);
        return with(
                new PlacementResult(result.chosen(), result.value(), atLeast, result.cost(), result.complete()),
                parts,
                complete);
    }

    /** This placement with figures of its parts. */
    RoutePlacement with(RouteParts others) {
        return with(result, others, complete);
    }

    /** This placement as the result of a search that tried as many layouts and routes as another. */
    RoutePlacement countedAs(RoutePlacement other) {
        return new RoutePlacement(
                plan,
                grid,
                result,
                weakest,
                lower,
                asItIs,
                byCondition,
                parts,
                other.rounds(),
                Math.max(routes, other.routes()),
                complete);
    }

    /**
     * Whether this placement states the figures of its parts and of the scene's own sensors; also true if there are no
     * sensors.
     */
    public boolean isWithParts() {
        boolean isBare =
                result.chosen().isEmpty() && plan.present().enabledSensors().isEmpty();
        return isBare || !parts.equals(RouteParts.NONE);
    }

    /** This placement without figures of its parts, after an interruption. */
    RoutePlacement withoutParts() {
        return with(result, RouteParts.NONE, false);
    }

    private RoutePlacement with(PlacementResult found, RouteParts others, boolean isComplete) {
        return new RoutePlacement(
                plan, grid, found, weakest, lower, asItIs, byCondition, others, rounds, routes, isComplete);
    }

    /** The probability of at least one detection along a route with a given exposure, 0 to 1. */
    public static double detection(double exposure) {
        return -Math.expm1(-exposure);
    }
}
