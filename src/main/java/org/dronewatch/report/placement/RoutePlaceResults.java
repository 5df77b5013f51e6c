package org.dronewatch.report.placement;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.route.RouteLayouts;
import org.dronewatch.placement.route.RoutePlacement;
import org.dronewatch.placement.site.BudgetFront;
import org.dronewatch.placement.site.LeftOut;
import org.dronewatch.run.Stage;
import tools.jackson.databind.node.ObjectNode;

/**
 * What a search for the best placement against the weakest route found.
 *
 * @param front best layouts for several budgets
 * @param layout the routes past the layout, as flown; empty if the layout has no sensor or its scene would be
 *     inconsistent, or if the search was interrupted or its time was up before the routes were flown
 * @param present the routes past the scene's own sensors, as flown; empty if the scene has no sensors, or for the
 *     reasons above
 * @param lost for each sensor whose loss is worst, by its name, the routes past the other sensors, as flown; no entry
 *     if the search has found a route past the other sensors on which nothing detects the drone, or for the reasons
 *     above
 * @param isCut whether routes are missing because of an interruption or the time limit
 * @param isSettled whether the figures hold for all routes along which flights have been computed; if not, the maximum
 *     number of comparisons of layouts has been reached
 */
public record RoutePlaceResults(
        BudgetFront<RoutePlacement> front,
        Optional<FlownLayout> layout,
        Optional<FlownLayout> present,
        Map<String, FlownLayout> lost,
        boolean isCut,
        boolean isSettled)
        implements PlaceResults {
    /** Copies the map. */
    public RoutePlaceResults {
        lost = Collections.unmodifiableMap(new LinkedHashMap<>(lost));
    }

    /** Results of a search that was not interrupted while routes were flown. */
    public RoutePlaceResults(
            BudgetFront<RoutePlacement> front, Optional<FlownLayout> layout, Optional<FlownLayout> present) {
        this(front, layout, present, Map.of(), false, true);
    }

    @Override
    public RoutePlacement best() {
        return front.best();
    }

    @Override
    public boolean isInterrupted() {
        return front.isInterrupted()
                || !front.isWithout(LeftOut.FLIGHTS)
                        && (isCut
                                || Stream.concat(
                                                Stream.of(layout, present).flatMap(Optional::stream),
                                                lost.values().stream())
                                        .anyMatch(flown -> !flown.results().isComplete()));
    }

    @Override
    public boolean complete() {
        return PlaceResults.super.complete() && isSettled;
    }

    @Override
    public PlaceResults without(LeftOut part, SolverLimits limits) {
        return new RoutePlaceResults(front.without(part, limits), layout, present, lost, isCut, isSettled);
    }

    @Override
    public PlaceMeasure measure() {
        return PlaceMeasure.of(best().plan());
    }

    private FlownPromise promise() {
        return new FlownPromise(best(), layout, lost);
    }

    @Override
    public Optional<String> shortfall() {
        return promise().shortfall();
    }

    @Override
    public Optional<String> worstLoss() {
        return promise().worstLoss();
    }

    @Override
    public List<String> lines() {
        PlaceTable table = new PlaceTable(best(), measure());
        List<String> lines = new ArrayList<>();
        shortfall().ifPresent(lines::add);
        lines.addAll(table.lines());
        lines.add("");
        table.nothing().ifPresent(lines::add);
        table.late().ifPresent(lines::add);
        lines.addAll(new RouteSentences(best(), shortfall().isPresent()).lines());
        new SilentDrone(best(), measure()).sentence().ifPresent(lines::add);
        table.byCondition().ifPresent(lines::add);
        table.present().ifPresent(lines::add);
        worstLoss().ifPresent(lines::add);
        lines.addAll(new FrontWords(measure(), best().plan().hasConditions()).lines(front));
        unsettled().ifPresent(lines::add);
        if (layout.isPresent() || present.isPresent()) {
            lines.addAll(new FlownTable(layout, present, best()).lines());
        }
        return lines;
    }

    @Override
    public List<String> reproduction(String scene) {
        return new FlownTable(layout, present, best())
                .reproduction(scene).stream().toList();
    }

    /** That flights may show weaker routes than the figures state, in a sentence; empty if they do not. */
    Optional<String> unsettled() {
        return isSettled
                ? Optional.empty()
                : Optional.of("Layouts are compared again after flights along routes, at most "
                        + RouteLayouts.MOST_COMPARED + " times. This limit was reached while flights past the layouts"
                        + " still revealed weaker routes than the search had found.");
    }

    @Override
    public ObjectNode toJson() {
        return PlaceFile.of(this, terms -> {}, this::addFlown, more -> {
            RoutePlaceFile.addRoute(more.putObject("route"), best());
            RoutePlaceFile.addRemaining(more.putArray("remaining"), best());
            more.put("rounds", best().rounds());
            more.put("routes", best().routes());
            RoutePlaceFile.addFlown(more.putArray("flown"), layout, present);
            RoutePlaceFile.addLosses(more.putArray("flown_losses"), promise().losses());
        });
    }

    /** Adds what flights past the layout show, next to the layout's value. */
    private void addFlown(ObjectNode root) {
        layout.flatMap(FlownLayout::weakest)
                .ifPresent(route ->
                        RoutePlaceFile.addInTime(root.putObject("weakest_flown"), route, layout.orElseThrow()));
        PlaceFile.conditions(best()).accept(root);
    }

    @Override
    public PlaceChapter chapter(Stage stage) throws IOException {
        return new RouteChapter(this, stage).chapter();
    }
}
