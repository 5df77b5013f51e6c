package org.dronewatch.report.placement;

import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.plan.SiteCandidate;
import org.dronewatch.placement.site.FrontPoint;
import org.dronewatch.placement.site.PlaceStep;
import org.dronewatch.placement.site.PlacedLayout;
import org.dronewatch.report.Charts;
import org.dronewatch.report.html.Figure;
import org.dronewatch.report.html.Html;
import org.dronewatch.report.html.Page;
import org.dronewatch.report.html.SensorTables;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;

/** The best layout for decision-makers: what to buy, what more money buys, and what changes on the site. */
final class PlaceReport {
    private static final String FRONT = "front.png";

    private final PlaceResults results;
    private final PlacedLayout best;
    private final PlacePlan plan;
    private final Stage stage;
    private final PlaceMeasure measure;
    private final PlaceWords words;
    private final PlaceChapter chapter;

    /**
     * A report.
     *
     * @param stage the site
     */
    PlaceReport(PlaceResults results, Stage stage) throws IOException {
        this.results = results;
        this.best = results.best();
        this.plan = best.plan();
        this.stage = stage;
        this.measure = results.measure();
        this.words = new PlaceWords(results);
        this.chapter = results.chapter(stage);
    }

    /** The pictures by the names of their files: the plot of value over cost, and those of the objective. */
    Map<String, Figure> pictures() throws IOException {
        Map<String, Figure> pictures = new LinkedHashMap<>();
        // A plot of nothing but the origin would show nothing.
        if (best.result().cost() > 0.0 || best.value() > 0.0) {
            pictures.put(
                    FRONT,
                    Figure.of(
                            "The value of the best layouts versus their cost, and the most that any layout could"
                                    + " achieve.",
                            Charts.picture(new FrontPicture(results.front(), measure).chart())));
        }
        pictures.putAll(chapter.pictures());
        return pictures;
    }

    /**
     * Writes the page.
     *
     * @param pictures pictures by the names of their files
     * @param layout the scene with only the layout's sensors
     * @param again which commands reproduce the figures, in sentences
     * @param provenance origin of the results, as names and values
     */
    void write(
            OutputStream target,
            Map<String, Figure> pictures,
            SceneSettings layout,
            List<String> again,
            Map<String, String> provenance)
            throws IOException {
        String scene = plan.scene().name();
        Page page = new Page(target, scene + ": placement report", scene + ": the best layout for the money");
        page.verdict((words.verdict() + " " + chapter.verdict()).strip());
        if (results.isInterrupted()) {
            page.warning("the search was interrupted: these are the results so far");
        }
        if (results.front().stopped().isPresent()) {
            // The page closes a warning with a full stop.
            page.warning(
                    TimeStopWords.sentences(results.front().stopped().get()).replaceFirst("[.]$", ""));
        }
        boolean isEmpty = best.chosen().isEmpty();
        page.section(
                "What to buy", isEmpty ? Html.plain("p", "Nothing is bought, and no sensor is kept.") : purchases());
        page.section("What more money buys", front() + figures(pictures, FRONT::equals));
        for (PlaceChapter.Section section : chapter.sections()) {
            page.section(section.title(), section.html());
        }
        SensorTables sensors = new SensorTables(layout);
        if (!isEmpty) {
            page.section("Sensors of the layout", sensors.sensors("The prices are those of the placement file."));
            page.section("Sources of the settings", sensors.sources());
        }
        page.section(
                "Scope of these results",
                Html.element(
                        "ul",
                        Stream.concat(scope(sensors).stream(), again.stream())
                                .map(item -> Html.plain("li", item))
                                .collect(Collectors.joining())));
        page.section("Provenance", Html.definitions(provenance));
        page.end();
    }

    private String purchases() {
        List<String> head = List.of(
                "sensor", "kind", "east, north, up [m]", "azimuth", words.priced("cost"), "sum", "alone", "together");
        PlaceTable table = new PlaceTable(best, measure);
        List<List<String>> rows = new ArrayList<>();
        boolean isOrdered = !best.purchases().isEmpty();
        best.chosen().stream()
                .filter(sensor -> !isOrdered || sensor.candidate().fixed())
                .forEach(sensor -> rows.add(row(
                        table,
                        sensor,
                        sensor.candidate().fixed()
                                ? "kept"
                                : PlaceWords.money(sensor.candidate().cost()),
                        "",
                        "")));
        for (PlaceStep step : best.purchases()) {
            SiteCandidate sensor = PlaceTable.added(step, best);
            rows.add(row(
                    table,
                    sensor,
                    PlaceWords.money(sensor.candidate().cost()),
                    PlaceWords.money(step.cost()),
                    measure.text(step.value())));
        }
        return Html.plain("p", measure.headingsOfTable() + order() + measure.columns())
                + Html.table(head, rows)
                + table.late().map(late -> Html.plain("p", late)).orElse("")
                + table.early().map(early -> Html.plain("p", early)).orElse("");
    }

    private String order() {
        return switch (best.buyingRule()) {
            case MOST_ADDED ->
                "The sensors are listed in order of purchase: at each step, the one that adds most for"
                        + " its price. ";
            case LEAST_LOST ->
                "The sensors are listed in order of purchase. Since several must detect the drone, the"
                        + " order was found backwards: at each step, the sensor that contributes least per unit of"
                        + " price was left out. ";
            case BEST_LEFT ->
                "The sensors are listed in order of purchase. Since only the worst case counts, which the"
                        + " first sensors may not improve, the order was found backwards: at each step, the sensor"
                        + " whose removal worsens the result least was left out; in a tie, the one that contributes least over all"
                        + " cases per unit of price. ";
        };
    }

    private static List<String> row(PlaceTable table, SiteCandidate sensor, String cost, String sum, String together) {
        return List.of(
                sensor.name(),
                sensor.sensor().kind(),
                PlaceTable.position(sensor),
                PlaceTable.azimuthInWords(sensor),
                cost,
                sum,
                table.alone(sensor),
                together);
    }

    private String front() {
        FrontWords front = new FrontWords(measure, plan.hasConditions());
        List<List<String>> rows = new ArrayList<>();
        double before = Double.NaN;
        for (FrontPoint<? extends PlacedLayout> point : results.front().points()) {
            rows.add(List.of(
                    PlaceWords.money(point.cost()),
                    Double.isNaN(before) ? "-" : PlaceWords.money(point.cost() - before),
                    measure.text(point.layout().value()),
                    measure.text(point.layout().bound()),
                    front.change(point)));
            before = point.cost();
        }
        return Html.plain(
                        "p",
                        measure.headingsOfTable()
                                + "Each row is the best layout that was found for its cost, in a separate search; a more"
                                + " expensive layout need not contain a cheaper one. No layout for that money can exceed the upper"
                                + " bound. 'Change' states what is bought, and where most is gained, as seen from the"
                                + " centre of the area.")
                + Html.table(
                        List.of(words.priced("cost"), "added cost", measure.heading(), "upper bound", "change"), rows)
                + front.tried(results.front().tried(), PlaceWords::money).stream()
                        .map(sentence -> Html.plain("p", sentence))
                        .collect(Collectors.joining());
    }

    /** Those of the pictures whose file name is to be shown, with their captions. */
    static String figures(Map<String, Figure> pictures, Predicate<String> isShown) {
        return pictures.entrySet().stream()
                .filter(picture -> isShown.test(picture.getKey()))
                .map(picture ->
                        Html.figure(picture.getValue().png(), picture.getValue().caption()))
                .collect(Collectors.joining());
    }

    /** How the drone flies, and where sensors on positioners point, if it flies level. */
    static String flight(PlacePlan plan) {
        return "Only the drone '" + plan.drone() + "' flies, level and at its cruise speed; sensors on positioners "
                + (plan.pointing() == FieldTerms.Turning.CUED ? "have turned to it." : "search for it.");
    }

    private List<String> scope(SensorTables sensors) {
        List<String> items = new ArrayList<>();
        items.add("Only the candidates of the placement file were compared: "
                + new PlaceTable(best, measure).candidates() + ".");
        items.addAll(chapter.scope());
        items.addAll(sensors.omissions());
        items.addAll(stage.siteNotes());
        items.addAll(stage.credits());
        return items;
    }
}
