package org.dronewatch.placement.route;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.IntConsumer;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.placement.PlacementSolver;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.plan.AirSettings;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.plan.PlaceSettings;
import org.dronewatch.placement.plan.SiteCandidate;
import org.dronewatch.route.FieldExposure;
import org.dronewatch.route.SensorFields;
import org.dronewatch.run.Stage;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.InputException;

/**
 * Finds the layout of a plan that makes the weakest route to the protected zone as exposed as possible, under the worst
 * of the plan's conditions. Each candidate is assessed once by itself under each condition; then the search alternates
 * between trying layouts against the known routes and looking for weaker routes past these layouts.
 */
public final class WeakestRouteSearch {
    /** The exposure to one look whose probability is at its cap; greater exposures count as equal to it. */
    public static final double ENOUGH = -Math.log1p(-FieldExposure.HIGHEST);

    private final PlacePlan plan;
    private final FieldGrid grid;

    /** In the scene as it is, and under each condition. */
    private final List<RouteFields> scenes = new ArrayList<>();

    private final PlacementSolver solver;

    /**
     * A search.
     *
     * @param stage stage of the plan's scene
     * @param store store of earlier assessments
     * @throws InputException when a setting makes no sense for routes, or the scene has no protected zone
     */
    public WeakestRouteSearch(PlacePlan plan, Stage stage, LayerStore store, PlacementSolver solver) {
        this.plan = plan;
        this.solver = solver;
        checkSense(plan.settings());
        this.grid = RouteFields.grid(plan, stage);
        scenes.add(new RouteFields(plan, plan.present(), stage, store, grid));
        plan.conditions().forEach(condition -> {
            Stage there = plan.runner().stage(condition.settings());
            LayerStore under =
                    store.under(condition.settings(), plan.runner().inputs().models());
            scenes.add(new RouteFields(plan, condition.settings(), there, under, grid));
        });
    }

    private static void checkSense(PlaceSettings settings) {
        AirSettings air = settings.air();
        refuse(settings.conditions().fold() > 1, "conditions.fold", "all sensors along a route count");
        refuse(air.area().isPresent(), "air.area", "routes lead to the protected zone from the edge of a square");
        refuse(air.within().isPresent(), "air.within", "each look counts");
        refuse(Double.compare(air.covered(), FieldCoverage.DEFAULT_COVERED) != 0, "air.covered", "each look counts");
        refuse(air.heading() != AirSettings.Heading.ANY, "air.heading", "a route has its own headings");
    }

    private static void refuse(boolean isGiven, String setting, String reason) {
        if (isGiven) {
            throw new InputException(setting + ": has no meaning for the objective weakest-route: " + reason);
        }
    }

    /** The approximate number of cells at which sensors have to be assessed. */
    public long looks() {
        long each = scenes.stream().mapToLong(RouteFields::looks).sum();
        return each * (plan.candidates().size() + others().size());
    }

    /** The scene's own sensors that are not candidates, by their names. */
    private Map<String, SensorSettings<?>> others() {
        Map<String, SensorSettings<?>> others =
                new LinkedHashMap<>(plan.present().enabledSensors());
        plan.candidates().forEach(one -> others.remove(one.name()));
        return others;
    }

    /**
     * The best layout that this search finds; if this thread is interrupted, the best of those tried so far, and the
     * interrupt status is kept.
     *
     * @param progress receives the number of cells that were assessed since the last call
     * @param round receives the number of layouts that have been tried so far
     * @throws InputException when no layout complies with the conditions, or there is no route
     * @throws CancellationException when this thread is interrupted before the first layout has been tried
     */
    public RoutePlacement found(SolverLimits limits, IntConsumer progress, IntConsumer round) {
        return assessed(progress).found(limits, round);
    }

    /**
     * Assesses each sensor by itself.
     *
     * @param progress receives the number of cells that were assessed since the last call
     * @throws InputException when there is no route
     * @throws CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public RouteLayouts assessed(IntConsumer progress) {
        List<SceneRoutes> routes = new ArrayList<>();
        for (int number = 0; number < scenes.size(); number++) {
            Optional<String> condition = number == 0
                    ? Optional.empty()
                    : Optional.of(plan.conditions().get(number - 1).name());
            routes.add(routes(condition, scenes.get(number), progress));
        }
        List<String> candidates =
                plan.candidates().stream().map(SiteCandidate::name).toList();
        return new RouteLayouts(plan, grid, new RouteRows(routes, candidates), solver);
    }

    private SceneRoutes routes(Optional<String> condition, RouteFields fields, IntConsumer progress) {
        List<SensorFields> known = new ArrayList<>();
        plan.candidates().forEach(one -> known.add(fields.of(one.name(), one.sensor(), progress)));
        others().forEach((name, sensor) -> known.add(fields.of(name, sensor, progress)));
        try {
            return new SceneRoutes(
                    condition,
                    fields.routes(known),
                    fields.disabled(),
                    known.stream().map(SensorFields::name).toList());
        } catch (IllegalArgumentException e) {
            throw new InputException("air: " + e.getMessage() + SceneRoutes.under(condition), e);
        }
    }
}
