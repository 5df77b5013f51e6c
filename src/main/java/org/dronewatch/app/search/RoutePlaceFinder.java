package org.dronewatch.app.search;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.placement.route.RouteLayouts;
import org.dronewatch.placement.route.RoutePlacement;
import org.dronewatch.placement.route.WeakestRouteSearch;
import org.dronewatch.placement.site.BudgetFront;
import org.dronewatch.placement.site.Layout;
import org.dronewatch.report.placement.FlownLayout;
import org.dronewatch.report.placement.PlaceResults;
import org.dronewatch.report.placement.RoutePlaceResults;
import org.dronewatch.report.route.RouteInputs;
import org.dronewatch.report.route.RouteResults;
import org.dronewatch.route.FlightMode;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.InputException;

/** Finds the layout against the weakest route, and flies the routes past it and past the scene's own sensors. */
final class RoutePlaceFinder implements PlaceFinder {
    @Override
    public PlaceResults find(PlaceTask task) {
        WeakestRouteSearch search = new WeakestRouteSearch(task.plan(), task.stage(), task.store(), task.solver());
        RouteLayouts layouts = task.during("rates of detection", search.looks(), search::assessed);
        RoutePlacement best = task.shown()
                .during(
                        "layouts and routes past them",
                        round -> layouts.found(task.limits(), tried -> round.accept(1)));
        BudgetFront<RoutePlacement> front = task.front(layouts.cheaper(best));
        Optional<FlownLayout> layout = front.complete() ? layout(task, front.best()) : Optional.empty();
        Optional<FlownLayout> present =
                layout.isPresent() && !task.plan().present().enabledSensors().isEmpty()
                        ? flown(task, front.best(), task.plan().present())
                        : Optional.empty();
        return new RoutePlaceResults(front, layout, present);
    }

    private static Optional<FlownLayout> layout(PlaceTask task, RoutePlacement best) {
        if (best.chosen().isEmpty()) {
            return Optional.empty();
        }
        try {
            return flown(task, best, Layout.of(task.plan(), best.chosen()));
        } catch (InputException e) {
            task.shown().notes().accept("the routes past the layout are not flown: " + e.getMessage());
            return Optional.empty();
        }
    }

    /** Searches for the routes past a layout as a scene, as {@code route} does, and flies them. */
    private static Optional<FlownLayout> flown(PlaceTask task, RoutePlacement best, SceneSettings settings) {
        RouteInputs inputs = new RouteInputs(
                task.plan().scene().name(),
                task.plan().drone(),
                settings,
                task.stage().protection(),
                best.grid(),
                task.plan().settings().air().pointing().orElse(FieldTerms.Turning.SEARCH),
                Optional.empty(),
                Optional.empty());
        try {
            RouteFinder finder = new RouteFinder(
                    task.plan().runner(),
                    inputs,
                    task.plan().runner().stage(settings),
                    task.interruption(),
                    task.shown());
            RouteResults results = finder.find(
                    FlightMode.of(
                            settings.individualDrones().get(task.plan().drone()),
                            settings.enabledSensors().values()),
                    Optional.empty(),
                    0);
            return Optional.of(new FlownLayout(inputs, results));
        } catch (CancellationException e) {
            return Optional.empty();
        }
    }
}
