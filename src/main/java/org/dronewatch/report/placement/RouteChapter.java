package org.dronewatch.report.placement;

import static org.dronewatch.report.html.ReadableNumbers.number;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.route.RoutePlacement;
import org.dronewatch.report.html.Figure;
import org.dronewatch.report.html.Html;
import org.dronewatch.report.route.RouteInputs;
import org.dronewatch.report.route.RoutePictures;
import org.dronewatch.report.sheet.MapSheet;
import org.dronewatch.run.Stage;

/** What the report says about the layout against the weakest route: the routes past it as they are flown. */
final class RouteChapter {
    private final RoutePlaceResults results;
    private final RoutePlacement best;
    private final PlacePlan plan;
    private final Stage stage;

    RouteChapter(RoutePlaceResults results, Stage stage) {
        this.results = results;
        this.best = results.best();
        this.plan = best.plan();
        this.stage = stage;
    }

    PlaceChapter chapter() throws IOException {
        Map<String, Figure> pictures = new LinkedHashMap<>();
        List<PlaceChapter.Section> sections = new ArrayList<>();
        if (results.layout().isPresent() || results.present().isPresent()) {
            int[] ground = MapSheet.ground(stage.world(), best.grid());
            if (results.layout().isPresent()) {
                pictures.put("routes.png", map(results.layout().get(), "best layout", ground));
            }
            if (results.present().isPresent()) {
                pictures.put("routes-today.png", map(results.present().get(), "today's layout", ground));
            }
            sections.add(new PlaceChapter.Section(
                    "The weakest routes", routes() + PlaceReport.figures(pictures, name -> true)));
        }
        RouteSentences sentences = new RouteSentences(best, results.shortfall().isPresent());
        String verdict = (best.value() == 0.0 ? remaining(sentences) + " " : "")
                + sentences.lower()
                + results.unsettled().map(sentence -> " " + sentence).orElse("");
        return new PlaceChapter(verdict, pictures, sections, scope());
    }

    /** The route that remains if nothing gains anything, and the gaps that could be closed. */
    private static String remaining(RouteSentences sentences) {
        return Stream.of(Optional.of(sentences.weakest()), sentences.points(), sentences.remaining())
                .flatMap(Optional::stream)
                .collect(Collectors.joining(" "));
    }

    private String routes() {
        List<List<String>> rows = new ArrayList<>();
        for (FlownTable.Pair pair : FlownTable.pairs(results.layout(), results.present())) {
            List<String> row = new ArrayList<>(List.of(pair.from()));
            row.addAll(FlownTable.figures(pair));
            rows.add(row);
        }
        FlownTable table = new FlownTable(results.layout(), results.present(), best);
        List<String> head = new ArrayList<>(List.of("from"));
        head.addAll(FlownTable.heads());
        return Html.plain(
                        "p",
                        "For each direction, the table states the probability that the drone is detected in time on the"
                                + " route on which that is least likely, past today's sensors and past the layout: by"
                                + " the search, which assesses each cell only at its centre, and as computed from every look along the"
                                + " route as it is flown" + table.asItIs()
                                + ". 'Time left' is the time between the typical (median) first"
                                + " detection and the drone's arrival.")
                + Html.table(head, rows)
                + table.words().stream().map(line -> Html.plain("p", line)).collect(Collectors.joining());
    }

    private Figure map(FlownLayout flown, String title, int[] ground) throws IOException {
        RouteInputs its = flown.inputs();
        RouteInputs named = new RouteInputs(
                its.scene() + ", " + title,
                its.drone(),
                its.settings(),
                its.protection(),
                its.grid(),
                its.pointing(),
                Optional.empty(),
                Optional.empty());
        return new RoutePictures(stage, named)
                .plan(flown.results().survey(), ground)
                .figure();
    }

    private List<String> scope() {
        FieldGrid grid = best.grid();
        return List.of(
                "Routes are searched for in a square with sides of " + number(grid.side())
                        + " m around the protected zone, in cells"
                        + " of " + number(grid.cell()) + " m, at heights of "
                        + grid.heights().stream().map(height -> number(height)).collect(Collectors.joining(", "))
                        + " m above the ground: an obstacle that hides a drone may be missed if it is smaller than"
                        + " a cell.",
                "Only the drone '" + plan.drone() + "' flies, within its limits on climb, descent and turns; sensors on"
                        + " positioners "
                        + (plan.pointing() == FieldTerms.Turning.CUED ? "have turned to it." : "search for it."),
                "Sensors are assumed to be independent; in reality, sensors behind the same obstacle are not.");
    }
}
