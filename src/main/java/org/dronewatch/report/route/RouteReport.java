package org.dronewatch.report.route;

import static org.dronewatch.report.html.ReadableNumbers.number;

import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.report.html.Figure;
import org.dronewatch.report.html.Html;
import org.dronewatch.report.html.Page;
import org.dronewatch.report.html.SensorTables;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.SiteRoutes;
import org.dronewatch.route.proof.ProvenChance;
import org.dronewatch.run.Stage;

/** The weakest routes of a site for decision-makers: the verdict, a table, the plan, a profile, and their scope. */
final class RouteReport {
    private final RouteResults results;
    private final RouteSurvey survey;
    private final RouteInputs inputs;
    private final Stage stage;
    private final RouteWords words;
    private final RouteNotes notes;

    RouteReport(RouteResults results, RouteInputs inputs, Stage stage) {
        this.results = results;
        this.survey = results.survey();
        this.inputs = inputs;
        this.stage = stage;
        this.words = new RouteWords(inputs);
        this.notes = new RouteNotes(inputs);
    }

    /**
     * Writes the page.
     *
     * @param figures in their order
     * @param provenance origin of the results, as names and values
     */
    void write(OutputStream target, Collection<Figure> figures, Map<String, String> provenance) throws IOException {
        Page page = new Page(target, inputs.scene() + ": route report", inputs.scene() + ": weakest routes");
        page.verdict(words.weakest(results));
        page.section(
                "The routes",
                introduction()
                        + table()
                        + notes.notes(results).stream()
                                .map(text -> Html.plain("p", text))
                                .reduce("", String::concat)
                        + notes.warnings(survey).stream()
                                .map(text -> Html.plain("p", "Warning: " + text + "."))
                                .reduce("", String::concat));
        for (Figure figure : figures) {
            page.add(Html.figure(figure.png(), figure.caption()));
        }
        if (!results.proofs().isEmpty()) {
            page.section("Check by flight", proofs());
        }
        SensorTables sensors = new SensorTables(inputs.settings());
        page.section("Sensors", sensors.sensors());
        page.section("Scope of these results", list(scope(sensors)));
        page.section("Provenance", Html.definitions(provenance));
        page.end();
    }

    private String introduction() {
        return Html.plain(
                "p",
                "The table lists, for each direction, the route on which the sensors are least likely to detect the"
                        + " drone"
                        + (survey.response() > 0.0
                                ? " while at least " + number(survey.response()) + " s are left for the response."
                                : " before it reaches " + inputs.targetInWords() + ".")
                        + " 'Detected' is the probability that any sensor detects it at all, computed from every look along the route"
                        + " as it is flown; 'search' is the estimate of the search, which assesses each cell only at its"
                        + " centre, and assumes that a sensor may look at any moment; 'time left' is the time between the typical (median) first detection and the drone's"
                        + " arrival"
                        + (survey.isAlertKnown()
                                ? "; 'alert in time' is the probability that the scene's rule raises an alert early enough,"
                                        + " assuming that flight time and response time each have a standard deviation of 30 %"
                                : "")
                        + (ModeWords.areSlow(survey)
                                ? "; 'slow' is how long the drone flies at "
                                        + ModeWords.slowSpeeds(survey)
                                        + ", which a radar rejects"
                                : "")
                        + (ModeWords.areGlides(survey) ? "; 'motors off' is how long the drone glides at the end" : "")
                        + ". 'Counted exposure' is the exposure, as computed from the cells of the search"
                        + (survey.response() > 0.0
                                ? ", on the part of the route where a detection would still be in time"
                                : "")
                        + ". The lower bound holds for every route through these cells that stays "
                        + inputs.heightsInWords()
                        + " above the ground. An exposure of 1 means a probability of 63 %, one of 3 means 95 %."
                        + (survey.response() > 0.0 ? " 'Search' is the probability along the whole route." : ""));
    }

    private String table() {
        boolean isRequired = survey.response() > 0.0;
        List<String> head = new ArrayList<>(List.of("from", "height", "flight", "detected", "search", "time left"));
        if (ModeWords.areSlow(survey)) {
            head.add("slow");
        }
        if (ModeWords.areGlides(survey)) {
            head.add("motors off");
        }
        if (isRequired) {
            head.addAll(List.of("detected in time", "compared with the response"));
        }
        if (survey.isAlertKnown()) {
            head.add("alert in time");
        }
        if (inputs.stopped().isPresent()) {
            head.add("stopped");
        }
        head.addAll(List.of("counted exposure", "lower bound"));
        List<List<String>> rows = new ArrayList<>();
        for (int sector = 0; sector < SiteRoutes.SECTORS; sector++) {
            Optional<SectorRoute> route = RouteWords.route(sector, survey);
            if (route.isPresent()) {
                rows.add(row(route.get()));
            } else if (survey.isComplete()) {
                List<String> row = new ArrayList<>(List.of(RouteWords.sector(sector), "no route"));
                row.addAll(Collections.nCopies(head.size() - row.size(), "-"));
                rows.add(row);
            }
        }
        return Html.table(head, rows) + sensors();
    }

    private List<String> row(SectorRoute route) {
        List<String> row = new ArrayList<>(List.of(
                RouteWords.sector(route),
                number(Math.rint(route.profile().medianHeight())) + " m",
                RouteNumbers.seconds(OptionalDouble.of(route.route().seconds())),
                RouteNumbers.percent(route.detection()),
                RouteNumbers.percent(route.searched().detection()),
                RouteNumbers.seconds(route.left())));
        if (ModeWords.areSlow(survey)) {
            row.add(RouteNumbers.seconds(ModeWords.slowed(route, survey)));
        }
        if (ModeWords.areGlides(survey)) {
            row.add(RouteNumbers.seconds(ModeWords.gliding(route, survey)));
        }
        if (survey.response() > 0.0) {
            row.add(RouteNumbers.percent(route.inTime(survey.response())));
            row.add(RouteNumbers.margin(route.left(), survey.response()));
        }
        if (survey.isAlertKnown()) {
            row.add(RouteNumbers.orDash(route.alertInTime()));
        }
        if (inputs.stopped().isPresent()) {
            row.add(RouteNumbers.orDash(RouteResults.effectiveness(route, inputs)));
        }
        row.add(RouteNumbers.exposure(route.route().exposure()));
        row.add(RouteNumbers.exposure(route.route().lower()));
        return row;
    }

    /** A separate table: with the numbers in it, too, it would be too wide for a page. */
    private String sensors() {
        RouteReasons reasons = new RouteReasons(inputs.settings());
        List<List<String>> rows = survey.routes().stream()
                .map(route -> List.of(
                        RouteWords.sector(route),
                        route.mostExposedTo()
                                .map(sensor -> sensor + " (" + RouteNumbers.percent(route.share(sensor)) + ")")
                                .orElse("no sensor"),
                        reasons.inWords(route).orElse("-")))
                .toList();
        return Html.table(List.of("from", "most exposed to", "reason for misses"), rows);
    }

    private String proofs() {
        List<List<String>> detections = new ArrayList<>();
        List<List<String>> alerts = new ArrayList<>();
        results.proofs().forEach((sector, proof) -> {
            List<String> row = row(sector, proof.detection());
            row.add(proof.cued().map(cued -> cued.count() + " of " + cued.of()).orElse("-"));
            detections.add(row);
            proof.alertInTime().ifPresent(alert -> alerts.add(row(sector, alert)));
        });
        return Html.plain(
                        "p",
                        "Each route was flown with many seeds, with sensors on positioners only searching. The"
                                + " prediction follows from all looks at the drone during such a flight. Where sensors are on positioners,"
                                + " up to 100 of these runs are repeated with all cues.")
                + Html.table(
                        List.of("from", "detected", "99 % interval", "predicted", "agrees", "with cues"), detections)
                + (alerts.isEmpty()
                        ? ""
                        : Html.plain(
                                        "p",
                                        "The table states how often, in these flights, the scene's rule raises an alert at"
                                                + " least "
                                                + number(survey.response())
                                                + " s before the drone arrives.")
                                + Html.table(
                                        List.of("from", "in time", "99 % interval", "predicted", "agrees"), alerts));
    }

    private static List<String> row(int sector, ProvenChance proven) {
        return new ArrayList<>(List.of(
                RouteWords.sector(sector),
                proven.flown().count() + " of " + proven.flown().of(),
                RouteNumbers.percent(proven.interval().low()) + " to "
                        + RouteNumbers.percent(proven.interval().high()),
                RouteNumbers.percent(proven.predicted()),
                proven.agrees() ? "yes" : "no"));
    }

    private List<String> scope(SensorTables sensors) {
        List<String> items = new ArrayList<>();
        items.add("The area searched is " + number(inputs.grid().side()) + " m by "
                + number(inputs.grid().side())
                + " m, " + inputs.cellsInWords()
                + ". Routes avoid everything solid, but an obstacle that hides a drone may be missed if it is"
                + " smaller than a cell.");
        items.add("Routes begin "
                + inputs.launch().map(area -> "in the area " + area).orElse("anywhere on the edge of that area") + ".");
        items.add("Only the drone '" + inputs.drone() + "' flies, within its limits on climb, descent and turns"
                + ModeWords.abilities(survey)
                + "; sensors on positioners "
                + (inputs.pointing() == FieldTerms.Turning.CUED ? "have turned to it." : "search for it."));
        inputs.stopped()
                .ifPresent(share -> items.add("The response is not simulated; it is assumed to stop the drone in "
                        + RouteNumbers.percent(share) + " of the cases in which the alert is in time."));
        items.add("Sensors are assumed to be independent; in reality, sensors behind the same obstacle are not.");
        items.addAll(sensors.omissions());
        items.addAll(stage.siteNotes());
        items.addAll(stage.credits());
        return items;
    }

    private static String list(List<String> items) {
        return Html.element(
                "ul", items.stream().map(item -> Html.plain("li", item)).reduce("", String::concat));
    }
}
