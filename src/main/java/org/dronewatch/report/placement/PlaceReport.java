package org.dronewatch.report.placement;

import static org.dronewatch.report.html.ReadableNumbers.number;

import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.dronewatch.analysis.field.FieldGrid;
import org.dronewatch.analysis.field.FieldTerms;
import org.dronewatch.analysis.field.HeightSummary;
import org.dronewatch.placement.site.AirSettings;
import org.dronewatch.placement.site.FrontPoint;
import org.dronewatch.placement.site.LayoutFields;
import org.dronewatch.placement.site.PlacePlan;
import org.dronewatch.placement.site.PlaceStep;
import org.dronewatch.placement.site.SiteCandidate;
import org.dronewatch.placement.site.SitePlacement;
import org.dronewatch.report.coverage.Losses;
import org.dronewatch.report.html.Figure;
import org.dronewatch.report.html.Html;
import org.dronewatch.report.html.Page;
import org.dronewatch.report.html.SensorTables;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.Counted;

/** The best layout for those who decide: what to buy, what more money buys, and what changes on the site. */
final class PlaceReport {
    private final PlaceResults results;
    private final SitePlacement best;
    private final PlacePlan plan;
    private final Stage stage;
    private final PlaceWords words;

    PlaceReport(PlaceResults results, Stage stage) {
        this.results = results;
        this.best = results.best();
        this.plan = best.plan();
        this.stage = stage;
        this.words = new PlaceWords(results);
    }

    /**
     * Writes the page.
     *
     * @param pictures by the names of their files
     * @param layout the scene with the layout's sensors alone
     * @param provenance origin of the results, as names and values
     */
    void write(OutputStream target, Map<String, Figure> pictures, SceneSettings layout, Map<String, String> provenance)
            throws IOException {
        String scene = plan.scene().name();
        Page page = new Page(target, scene + ": placement report", scene + ": the best layout for the money");
        page.verdict(words.verdict());
        if (!results.complete()) {
            page.warning("the search was interrupted: this is the best layout so far");
        }
        page.section("What to buy", purchases());
        page.section("What more money buys", front() + figures(pictures, name -> name.startsWith("front")));
        if (results.fields().isPresent()) {
            LayoutFields fields = results.fields().get();
            page.section("Coverage by height", byHeight(fields));
            page.section("If a sensor fails", new Losses(fields.layout()).html());
            page.section("Maps", figures(pictures, shown(fields)));
        }
        SensorTables sensors = new SensorTables(layout);
        page.section("Sensors of the layout", sensors.sensors());
        page.section("Sources of the settings", sensors.sources());
        page.section(
                "Scope of these results",
                Html.element(
                        "ul",
                        scope(sensors).stream()
                                .map(item -> Html.plain("li", item))
                                .collect(Collectors.joining())));
        page.section("Provenance", Html.definitions(provenance));
        page.end();
    }

    private String purchases() {
        List<String> head = List.of(
                "sensor", "kind", "east, north, up [m]", "azimuth", words.priced("cost"), "sum", "alone", "together");
        List<List<String>> rows = new ArrayList<>();
        best.chosen().stream()
                .filter(sensor -> sensor.candidate().fixed())
                .forEach(sensor -> rows.add(row(sensor, "kept", "", "")));
        for (PlaceStep step : best.purchases()) {
            SiteCandidate sensor = PlaceTable.added(step, best);
            rows.add(row(
                    sensor,
                    PlaceWords.money(sensor.candidate().cost()),
                    PlaceWords.money(step.cost()),
                    FrontWords.percent(step.value())));
        }
        return Html.plain(
                        "p",
                        "The sensors in the order in which to buy them: each time the one that adds most for its price."
                                + " 'Alone' is the part of the airspace that a sensor covers by itself, 'together' what all"
                                + " sensors so far cover.")
                + Html.table(head, rows);
    }

    private List<String> row(SiteCandidate sensor, String cost, String sum, String together) {
        OptionalDouble azimuth = PlaceTable.azimuth(sensor);
        return List.of(
                sensor.name(),
                sensor.sensor().kind(),
                PlaceTable.position(sensor),
                azimuth.isPresent() ? PlaceTable.text("%.0f°", azimuth.getAsDouble()) : "-",
                cost,
                sum,
                FrontWords.percent(best.alone(sensor)),
                together);
    }

    private String front() {
        List<List<String>> rows = new ArrayList<>();
        double before = Double.NaN;
        for (FrontPoint point : results.front().points()) {
            rows.add(List.of(
                    PlaceWords.money(point.cost()),
                    Double.isNaN(before) ? "-" : PlaceWords.money(point.cost() - before),
                    FrontWords.percent(point.layout().value()),
                    FrontWords.percent(point.layout().bound()),
                    FrontWords.change(point)));
            before = point.cost();
        }
        return Html.plain(
                        "p",
                        "Each row is the best layout that was found for its cost, in a separate search; a dearer layout"
                                + " need not contain a cheaper one. 'At most' is what no layout for that money can exceed."
                                + " The change states what is bought, and where most is gained: the direction from the"
                                + " middle of the area, and the heights.")
                + Html.table(List.of(words.priced("cost"), "more", "covered", "at most", "change"), rows);
    }

    private String byHeight(LayoutFields fields) {
        List<List<String>> rows = new ArrayList<>();
        for (int height = 0; height < fields.layout().heights().size(); height++) {
            HeightSummary its = fields.layout().heights().get(height);
            List<String> row = new ArrayList<>(List.of(number(its.height()) + " m"));
            if (fields.present().isPresent()) {
                row.addAll(figures(fields.present().get().heights().get(height)));
            }
            row.addAll(figures(its));
            rows.add(row);
        }
        List<String> head = new ArrayList<>(List.of("height"));
        for (String of : fields.present().isPresent() ? List.of("today: ", "layout: ") : List.of("")) {
            head.addAll(List.of(of + "covered [%]", of + "after the worst loss [%]", of + "largest gap [ha]"));
        }
        return Html.plain(
                        "p",
                        "The coverage" + FieldsTable.heading(fields)
                                + ", in % of the known area at each height; after the loss of the sensor that matters most"
                                + " there; and the largest gap. " + FieldsTable.worstPlace(fields.layout()))
                + Html.table(head, rows)
                + Html.plain(
                        "p",
                        "The command 'coverage layout.yaml " + SameCoverage.options(best)
                                + "' gives the figures of the layout, and the reasons for its gaps.");
    }

    private static List<String> figures(HeightSummary height) {
        HeightFigures figures = new HeightFigures(height);
        return List.of(figures.covered(), figures.afterNamedLoss(), figures.largestGap());
    }

    /** What changes at each height, and both layouts where the best covers least. */
    private Predicate<String> shown(LayoutFields fields) {
        String worst = PlacePictures.name("", PlaceWords.leastCovered(fields).height());
        boolean isAlone = fields.present().isEmpty();
        return name -> name.startsWith("change")
                || name.startsWith("layout") && (isAlone || name.endsWith(worst))
                || name.startsWith("today") && name.endsWith(worst);
    }

    private static String figures(Map<String, Figure> pictures, Predicate<String> isShown) {
        return pictures.entrySet().stream()
                .filter(picture -> isShown.test(picture.getKey()))
                .map(picture ->
                        Html.figure(picture.getValue().png(), picture.getValue().caption()))
                .collect(Collectors.joining());
    }

    private List<String> scope(SensorTables sensors) {
        FieldGrid grid = best.grid();
        AirSettings air = plan.settings().air();
        List<String> items = new ArrayList<>();
        items.add("Only the candidates of the placement file were compared: "
                + Counted.of(plan.candidates().size(), "candidate") + ".");
        items.add("The airspace is "
                + air.area().map(name -> "that over '" + name + "', in ").orElse("")
                + "a square of " + number(grid.columns() * grid.cell()) + " m in cells of " + number(grid.cell())
                + " m, at heights of "
                + grid.heights().stream().map(height -> number(height)).collect(Collectors.joining(", "))
                + " m above the ground: what is smaller than a cell may be missed.");
        items.add(
                best.headings() > 1
                        ? "Unless stated otherwise, each of eight headings of the drone counts as an eighth of a cell."
                        : "The drone flies towards the protected zone.");
        items.add("Only the drone '" + plan.drone() + "' flies, level and at its cruise speed; sensors on positioners "
                + (air.terms().pointing() == FieldTerms.Turning.CUED ? "have turned to it." : "search for it."));
        items.addAll(sensors.omissions());
        items.addAll(stage.siteNotes());
        items.addAll(stage.credits());
        return items;
    }
}
