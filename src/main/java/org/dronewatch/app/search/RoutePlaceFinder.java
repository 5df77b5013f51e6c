package org.dronewatch.app.search;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import org.dronewatch.placement.plan.SiteCandidate;
import org.dronewatch.placement.route.RouteLayouts;
import org.dronewatch.placement.route.RoutePlacement;
import org.dronewatch.placement.route.WeakestRouteSearch;
import org.dronewatch.placement.site.BudgetFront;
import org.dronewatch.placement.site.Layout;
import org.dronewatch.placement.site.LeftOut;
import org.dronewatch.report.placement.FlownLayout;
import org.dronewatch.report.placement.PlaceResults;
import org.dronewatch.report.placement.RoutePlaceResults;
import org.dronewatch.report.route.RouteInputs;
import org.dronewatch.report.route.RouteResults;
import org.dronewatch.route.FlightMode;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/** Finds the layout against the weakest route, and flies the routes past it and past the scene's own sensors. */
final class RoutePlaceFinder implements PlaceFinder {
    @Override
    public PlaceResults find(PlaceTask task) {
        WeakestRouteSearch search = new WeakestRouteSearch(task.plan(), task.stage(), task.store(), task.solver());
        RouteLayouts layouts = task.during("rates of detection", search.looks(), search::assessed);
        task.limitTime();
        return new Search(task, layouts).results();
    }

    /** Searches again for as long as flights past the best layout, or cheaper ones, show weaker routes past it. */
    private static final class Search {
        private final PlaceTask task;
        private final RouteLayouts layouts;

        /** The layouts whose routes have been flown, by their sensors; empty for those whose routes cannot be flown. */
        private final Map<List<Integer>, Optional<FlownLayout>> flown = new HashMap<>();

        private Optional<FlownLayout> present = Optional.empty();

        /** Whether an interruption or the time limit has left out something. */
        private boolean isCut;

        Search(PlaceTask task, RouteLayouts layouts) {
            this.task = task;
            this.layouts = layouts;
        }

        RoutePlaceResults results() {
            return new ComparisonRounds(RouteLayouts.MOST_COMPARED, this::isEnding).result(this::round);
        }

        /** The best layout and cheaper ones, with the routes past them known as they are flown, if all figures hold. */
        private Optional<RoutePlaceResults> round(boolean isLast) {
            RoutePlacement best = task.shown()
                    .during(
                            "layouts and routes past them",
                            tried -> layouts.found(task.limits(), number -> tried.accept(1)));
            layout(best);
            if (!isLast && !holds(best)) {
                return Optional.empty();
            }
            BudgetFront<RoutePlacement> front = task.front(layouts.cheaper(best));
            Optional<FlownLayout> layout = layout(front.best());
            boolean isSettled = holds(front);
            return isLast || isSettled
                    ? Optional.of(results(front, layout, isSettled || isEnding()))
                    : Optional.empty();
        }

        private RoutePlaceResults results(
                BudgetFront<RoutePlacement> front, Optional<FlownLayout> layout, boolean isSettled) {
            Map<String, FlownLayout> lost = lost(front.best());
            BudgetFront<RoutePlacement> checked =
                    task.checked(front, LeftOut.PARTS, !front.best().isWithParts());
            return new RoutePlaceResults(
                    task.checked(checked, LeftOut.FLIGHTS, isCut), layout, present, lost, isCut, isSettled);
        }

        /**
         * Whether the user wants to end the search, or nothing else can be flown in time. Once only the time of the
         * search is over, layouts that have been tried are still compared as often as flights show other routes.
         */
        private boolean isEnding() {
            return task.limits().end().isStopped() || task.interruption().happened();
        }

        private boolean holds(BudgetFront<RoutePlacement> front) {
            return front.points().stream().allMatch(point -> holds(point.layout()));
        }

        /** Whether something has to be left out, because the user wants to end the search or the time is up. */
        private boolean cuts() {
            // What was interrupted may have cleared the interrupt status of the thread.
            isCut |= task.interruption().happened();
            return isCut;
        }

        /** Whether the routes past a layout need not be searched for again; after an interruption, nothing is. */
        private boolean holds(RoutePlacement layout) {
            try {
                return isCut || layouts.holds(layout);
            } catch (CancellationException e) {
                isCut = true;
                return true;
            }
        }

        /** The routes past a layout as they are flown, and past the scene's own sensors; all are known afterwards. */
        private Optional<FlownLayout> layout(RoutePlacement best) {
            List<Integer> chosen = best.result().chosen();
            if (!chosen.isEmpty() && !flown.containsKey(chosen) && !cuts()) {
                flown.put(chosen, learned(past(best, best.chosen(), "the layout")));
            }
            Optional<FlownLayout> layout = flown.getOrDefault(chosen, Optional.empty());
            if ((chosen.isEmpty() || layout.isPresent())
                    && present.isEmpty()
                    && !task.plan().present().enabledSensors().isEmpty()
                    && !cuts()) {
                present = learned(flown(best, task.plan().present()));
            }
            return layout;
        }

        /** The routes of a layout, which are known to the search for layouts from now on if they are complete. */
        private Optional<FlownLayout> learned(Optional<FlownLayout> layout) {
            layout.map(FlownLayout::results)
                    .filter(RouteResults::isComplete)
                    .ifPresent(results -> layouts.learn(results.found()));
            return layout;
        }

        private Optional<FlownLayout> past(RoutePlacement best, List<SiteCandidate> sensors, String whom) {
            try {
                return flown(best, Layout.of(task.plan(), sensors));
            } catch (InputException e) {
                task.shown().notes().accept("the routes past " + whom + " are not flown: " + e.getMessage());
                return Optional.empty();
            }
        }

        /**
         * The routes past the layout without each of the sensors whose loss is worst, by the name of that sensor:
         * losses that are equally bad in the search may differ in flights. Without exposure there is nothing to fly.
         */
        private Map<String, FlownLayout> lost(RoutePlacement best) {
            Map<String, FlownLayout> lost = new LinkedHashMap<>();
            for (String name : best.worstLosses()) {
                List<SiteCandidate> others = best.chosen().stream()
                        .filter(one -> !one.name().equals(name))
                        .toList();
                if (best.withoutEach().get(name) > 0.0 && !others.isEmpty() && !cuts()) {
                    past(best, others, "the layout without '" + PlainText.value(name) + "'")
                            .ifPresent(flown -> lost.put(name, flown));
                }
            }
            return lost;
        }

        /** Searches for the routes past a layout as a scene, as {@code route} does, and flies them. */
        private Optional<FlownLayout> flown(RoutePlacement best, SceneSettings settings) {
            RouteInputs inputs = new RouteInputs(
                    task.plan().scene().name(),
                    task.plan().drone(),
                    settings,
                    task.stage().protection(),
                    best.grid(),
                    task.plan().pointing(),
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
                        // The modes of the layout search, which the numbers in its routes refer to.
                        FlightMode.of(
                                settings.individualDrones().get(task.plan().drone()),
                                task.plan().sensors()),
                        Optional.empty(),
                        0);
                isCut |= !results.isComplete();
                return Optional.of(new FlownLayout(inputs, results));
            } catch (CancellationException e) {
                isCut = true;
                return Optional.empty();
            }
        }
    }
}
