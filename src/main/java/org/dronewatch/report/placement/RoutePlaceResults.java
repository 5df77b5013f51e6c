package org.dronewatch.report.placement;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.dronewatch.placement.route.RoutePlacement;
import org.dronewatch.placement.site.BudgetFront;
import org.dronewatch.run.Stage;
import tools.jackson.databind.node.ObjectNode;

/**
 * What a search for the best placement against the weakest route found.
 *
 * @param front best layouts for several budgets
 * @param layout the routes past the layout, as flown; empty if the layout has no sensor, its scene would be
 *     inconsistent, or the search was interrupted before they were computed
 * @param present the routes past the scene's own sensors, as flown; empty if it has none, or for the reasons above
 * @param isCut whether an interruption has left out either of these
 */
public record RoutePlaceResults(
        BudgetFront<RoutePlacement> front, Optional<FlownLayout> layout, Optional<FlownLayout> present, boolean isCut)
        implements PlaceResults {
    /** Results of a search that was not interrupted while routes were flown. */
    public RoutePlaceResults(
            BudgetFront<RoutePlacement> front, Optional<FlownLayout> layout, Optional<FlownLayout> present) {
        this(front, layout, present, false);
    }

    @Override
    public RoutePlacement best() {
        return front.best();
    }

    @Override
    public boolean isInterrupted() {
        return front.isInterrupted()
                || isCut
                || Stream.of(layout, present).flatMap(Optional::stream).anyMatch(flown -> !flown.results()
                        .isComplete());
    }

    @Override
    public PlaceMeasure measure() {
        return PlaceMeasure.of(best().plan());
    }

    @Override
    public List<String> lines() {
        PlaceTable table = new PlaceTable(best(), measure());
        List<String> lines = new ArrayList<>(table.lines());
        lines.add("");
        table.nothing().ifPresent(lines::add);
        table.late().ifPresent(lines::add);
        lines.addAll(new RouteSentences(best()).lines());
        table.byCondition().ifPresent(lines::add);
        table.present().ifPresent(lines::add);
        table.worstLoss().ifPresent(lines::add);
        lines.addAll(new FrontWords(measure()).lines(front));
        layout.ifPresent(flown -> lines.addAll(new FlownTable(flown, present, best()).lines()));
        return lines;
    }

    @Override
    public ObjectNode toJson() {
        return PlaceFile.of(this, terms -> {}, PlaceFile.conditions(best()), more -> {
            RoutePlaceFile.addRoute(more.putObject("route"), best());
            more.put("rounds", best().rounds());
            more.put("routes", best().routes());
            RoutePlaceFile.addFlown(more.putArray("flown"), layout, present);
        });
    }

    @Override
    public PlaceChapter chapter(Stage stage) throws IOException {
        return new RouteChapter(this, stage).chapter();
    }
}
