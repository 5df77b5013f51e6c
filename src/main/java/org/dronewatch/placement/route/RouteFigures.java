package org.dronewatch.placement.route;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.placement.Candidate;
import org.dronewatch.placement.CandidateLosses;
import org.dronewatch.placement.PlacementResult;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.plan.PlanConditions;
import org.dronewatch.placement.plan.SiteCandidate;
import org.dronewatch.placement.site.BuyingOrder;
import org.dronewatch.placement.site.PlaceStep;
import org.dronewatch.placement.site.PresentLayout;
import org.dronewatch.placement.solver.CutResult;

/** What is stated about a layout that was found: routes are searched for past each part of it. */
final class RouteFigures {
    /** Values that differ by a smaller fraction are equal. */
    static final double ROUNDING = 1e-9;

    private final PlacePlan plan;
    private final FieldGrid grid;
    private final RouteRows rows;

    RouteFigures(PlacePlan plan, FieldGrid grid, RouteRows rows) {
        this.plan = plan;
        this.grid = grid;
        this.rows = rows;
    }

    /** The figures; without those of parts of the layout and of the scene if this thread is interrupted. */
    RoutePlacement of(CutResult cut) {
        return withParts(inBrief(cut));
    }

    /** The figures of a layout, without those of its parts and of the scene. */
    RoutePlacement inBrief(CutResult cut) {
        PlacementResult found = cut.result();
        // These routes have been searched for already.
        List<DirectedRoute> past = rows.pastCandidates(found.chosen());
        Map<Optional<String>, Double> values = rows.values(found.chosen());
        double value = values.values().stream().mapToDouble(Double::doubleValue).reduce(found.value(), Math::min);
        double lower =
                past.stream().mapToDouble(one -> one.route().lower()).min().orElse(0.0);
        Map<String, Double> byCondition = new LinkedHashMap<>();
        plan.conditions().forEach(one -> byCondition.put(one.name(), values.get(Optional.of(one.name()))));
        return new RoutePlacement(
                plan,
                grid,
                new PlacementResult(found.chosen(), value, found.bound(), found.cost(), found.complete()),
                past.get(0),
                Math.min(lower, value),
                values.get(Optional.<String>empty()),
                byCondition,
                RouteParts.NONE,
                cut.rounds(),
                cut.problem().table().rows(),
                found.complete());
    }

    /** A layout with the figures of its parts and of the scene; without them if this thread is interrupted. */
    RoutePlacement withParts(RoutePlacement brief) {
        try {
            return brief.with(parts(brief));
        } catch (CancellationException e) {
            return brief.withoutParts();
        }
    }

    /** Whether the figures of a layout still hold for all routes that are known by now. */
    boolean holds(RoutePlacement layout) {
        // Parts first: their figures may need routes that are not known yet.
        boolean isSame = layout.parts().alone().isEmpty() || layout.parts().equals(parts(layout));
        return isSame && rows.value(layout.result().chosen()) >= (1.0 - ROUNDING) * layout.value();
    }

    private RouteParts parts(RoutePlacement brief) {
        return new RouteParts(alone(brief), without(brief), purchases(brief), present(), remaining(brief));
    }

    /**
     * If no layout gains anything, the routes that show why: no layout exposes a drone more than all candidates
     * together do.
     */
    private List<DirectedRoute> remaining(RoutePlacement brief) {
        return brief.value() == 0.0 ? rows.pastCandidates(affordable(plan)) : List.of();
    }

    /** The candidates that individually cost no more than the budget, and those that are kept. */
    static List<Integer> affordable(PlacePlan plan) {
        return IntStream.range(0, plan.candidates().size())
                .filter(number -> {
                    Candidate one = plan.candidates().get(number).candidate();
                    return one.fixed() || one.cost() <= plan.settings().budget();
                })
                .boxed()
                .toList();
    }

    private Map<String, Double> alone(RoutePlacement brief) {
        Map<String, Double> alone = new LinkedHashMap<>();
        brief.result().chosen().forEach(one -> alone.put(name(one), rows.value(List.of(one))));
        return alone;
    }

    private Map<String, Double> without(RoutePlacement brief) {
        List<Integer> chosen = brief.result().chosen();
        CandidateLosses losses = losses(plan);
        Map<String, Double> without = new LinkedHashMap<>();
        chosen.forEach(lost -> without.put(name(lost), rows.value(losses.remaining(chosen, lost))));
        return without;
    }

    /** What remains after losses of the candidates of a plan. */
    static CandidateLosses losses(PlacePlan plan) {
        return new CandidateLosses(
                plan.candidates().stream().map(SiteCandidate::name).toList(), PlanConditions.of(plan));
    }

    private String name(int candidate) {
        return plan.candidates().get(candidate).name();
    }

    private Optional<PresentLayout> present() {
        Set<String> own = plan.present().enabledSensors().keySet();
        return own.isEmpty()
                ? Optional.empty()
                : Optional.of(new PresentLayout(own.size(), RouteRows.counted(rows.past(own))));
    }

    /** Where the weakest routes are equally exposed, the mean exposure over all routes breaks the tie. */
    private List<PlaceStep> purchases(RoutePlacement brief) {
        return new BuyingOrder(
                        number -> plan.candidates().get(number).candidate().cost(), rows::value, rows::most, rows::mean)
                .steps(brief, DoubleUnaryOperator.identity());
    }
}
