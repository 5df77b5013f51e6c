package org.dronewatch.report.coverage;

import static org.dronewatch.report.html.ReadableNumbers.number;

import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.Collection;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.InboundWarnings;
import org.dronewatch.analysis.survey.ConditionCoverage;
import org.dronewatch.analysis.survey.FieldSummary;
import org.dronewatch.analysis.survey.FieldSurvey;
import org.dronewatch.analysis.survey.HeightSummary;
import org.dronewatch.report.coverage.table.ConditionTable;
import org.dronewatch.report.coverage.table.CoverageInputs;
import org.dronewatch.report.coverage.table.CoverageSite;
import org.dronewatch.report.coverage.table.CoverageTable;
import org.dronewatch.report.coverage.table.FieldTable;
import org.dronewatch.report.coverage.table.Losses;
import org.dronewatch.report.coverage.table.ReferencePoint;
import org.dronewatch.report.coverage.table.SensorCausesTable;
import org.dronewatch.report.coverage.table.WorstPlaces;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.report.html.Figure;
import org.dronewatch.report.html.Html;
import org.dronewatch.report.html.Page;
import org.dronewatch.report.html.SensorTables;
import org.dronewatch.report.sheet.MapSheet;
import org.dronewatch.sensor.Cause;

/** The coverage of a site for decision-makers: the verdict, the worst places with their causes, maps, and warnings. */
final class CoverageReport {
    private final CoverageInputs inputs;
    private final CoverageSite site;
    private final FieldSummary summary;
    private final WorstPlaces places;
    private final Losses losses;
    private final WarningWords warnings;
    private final List<ConditionCoverage> conditions;

    /**
     * A report of a survey that is complete.
     *
     * @throws java.util.NoSuchElementException when it is not
     */
    CoverageReport(FieldSurvey survey, CoverageInputs inputs, CoverageSite site) {
        InboundWarnings inbound = survey.warnings().orElseThrow();
        this.inputs = inputs;
        this.site = site;
        this.summary = survey.summary();
        this.places = new WorstPlaces(
                summary, site, ReferencePoint.of(inbound, site.stage().protection(), inputs));
        this.losses = new Losses(summary);
        this.warnings = new WarningWords(inbound);
        this.conditions = survey.conditions();
    }

    /**
     * Writes the page.
     *
     * @param maps in their order
     * @param provenance origin of the results, as names and values; empty to omit this section
     */
    void write(OutputStream target, Collection<MapSheet> maps, Map<String, String> provenance) throws IOException {
        Page page = new Page(target, inputs.scene() + ": coverage report", inputs.scene() + ": coverage");
        page.verdict(verdict());
        page.section("The worst places", places.html());
        page.section("Coverage by height", heights());
        page.section("Warning of inbound flights", probability() + warnings.html());
        page.section("If a sensor fails", probability() + losses.html());
        if (!conditions.isEmpty()) {
            page.section("Under other conditions", probability() + underConditions());
        }
        page.section("Maps", "");
        for (MapSheet map : maps) {
            Figure figure = map.figure();
            page.add(Html.figure(figure.png(), figure.caption()));
        }
        SensorTables sensors = new SensorTables(site.settings());
        page.section("Sensors", sensors.sensors());
        page.section("Sources of the settings", sensors.sources());
        page.section("Scope of these results", list(conditions(sensors)));
        if (!provenance.isEmpty()) {
            page.section("Provenance", Html.definitions(provenance));
        }
        page.end();
    }

    /** States the probability with which a sensor must detect the drone, unless it is the default. */
    private String probability() {
        return inputs.hasDefaultProbability()
                ? ""
                : Html.plain(
                        "p", "The drone counts as detected where a sensor detects it" + inputs.withProbability() + ".");
    }

    private String verdict() {
        List<String> sentences = new ArrayList<>(List.of(covered()));
        FieldTable.unknownInWords(summary)
                .map(words -> "Unknown: " + words + ".")
                .ifPresent(sentences::add);
        sentences.addAll(List.of(places.worstInWords(), warnings.worstInWords()));
        losses.worstInWords().ifPresent(sentences::add);
        if (!summary.idleSensors().isEmpty()) {
            sentences.add(losses.idle());
        }
        return String.join(" ", sentences);
    }

    private String covered() {
        List<HeightSummary> known =
                summary.heights().stream().filter(height -> height.known() > 0).toList();
        if (known.isEmpty()) {
            return "Nothing is known about the area.";
        }
        HeightSummary least = known.get(0);
        HeightSummary most = least;
        for (HeightSummary height : known) {
            least = share(height) < share(least) ? height : least;
            most = share(height) > share(most) ? height : most;
        }
        String subject = "The drone '" + inputs.drone() + "', " + heading() + ", is detected " + time() + "in ";
        if (most.covered() == 0) {
            return "The drone '" + inputs.drone() + "', " + heading() + ", is not detected " + time()
                    + "anywhere in the area"
                    + (known.size() > 1
                            ? " at any of the heights."
                            : " at " + number(most.height()) + " m above the ground.");
        }
        String from = percent(least.covered(), least) + " % ";
        String area = summary.isAllKnown() ? "the area" : "the known area";
        if (share(least) == share(most) && known.size() > 1) {
            return subject + from + "of " + area + " at each of the heights.";
        }
        return least == most
                ? subject + from + "of " + area + " at " + number(least.height()) + " m above the ground."
                : subject + from + "(at " + number(least.height()) + " m above the ground) to "
                        + percent(most.covered(), most) + " % (at " + number(most.height()) + " m) of " + area + ".";
    }

    private String heading() {
        return switch (inputs.heading()) {
            case "inbound" -> "flying inbound";
            case "best" -> "on the heading on which it is most likely to be detected";
            default -> "on the heading on which it is least likely to be detected";
        };
    }

    /** In which time, and with which probability, the drone has to be detected. */
    private String time() {
        return within()
                + (inputs.hasDefaultProbability()
                        ? ""
                        : "with a probability of " + Numbers.text(inputs.covered()) + " or more ");
    }

    private String within() {
        return inputs.within()
                .map(seconds -> "within " + number(seconds) + " s ")
                .orElse("");
    }

    private static double share(HeightSummary height) {
        return (double) height.covered() / height.known();
    }

    /** A number of cells in percent; a dash if no cell is known. */
    private static String percent(int cells, HeightSummary height) {
        if (height.known() == 0) {
            return "-";
        }
        return cells == 0 ? "0" : CoverageTable.percent(cells, height.known());
    }

    private String heights() {
        Set<Cause> causes = EnumSet.noneOf(Cause.class);
        summary.heights().forEach(height -> causes.addAll(height.causes().keySet()));
        causes.remove(Cause.DETECTED);
        List<String> head = new ArrayList<>(List.of("height", "covered [%]", "by two or more [%]"));
        causes.forEach(cause -> head.add(CoverageTable.name(cause) + " [%]"));
        List<List<String>> rows = new ArrayList<>();
        for (HeightSummary height : summary.heights()) {
            int single = height.counts().length > 1 ? height.counts()[1] : 0;
            List<String> row = new ArrayList<>(List.of(
                    number(height.height()) + " m",
                    percent(height.covered(), height),
                    percent(height.covered() - single, height)));
            causes.forEach(cause -> row.add(percent(height.causes().getOrDefault(cause, 0), height)));
            rows.add(row);
        }
        return Html.plain(
                        "p",
                        "The table states the part of the known area at each height, in %, in which at least one sensor"
                                + " detects the drone "
                                + (inputs.within().isEmpty() ? "in one look " : within())
                                + "with a probability of " + Numbers.text(inputs.covered())
                                + " or more, and the causes of all sensors' misses "
                                + (inputs.within().isPresent()
                                        ? "in single looks."
                                        : inputs.hasDefaultProbability()
                                                ? "elsewhere."
                                                : "where none detects it with a probability of "
                                                        + number(FieldCoverage.DEFAULT_COVERED) + " or more."))
                + Html.table(head, rows)
                + new SensorCausesTable(summary).html(inputs)
                + FieldTable.slownessInWords(summary, inputs)
                        .map(words -> Html.plain("p", "Too slow: " + words + "."))
                        .orElse("");
    }

    private String underConditions() {
        List<String> head = new ArrayList<>(List.of("height"));
        conditions.forEach(one -> head.add(ConditionTable.name(one)));
        List<List<String>> rows = new ArrayList<>();
        for (int height = 0; height < summary.heights().size(); height++) {
            List<String> row =
                    new ArrayList<>(List.of(number(summary.heights().get(height).height()) + " m"));
            for (ConditionCoverage one : conditions) {
                ConditionCoverage.Height its = one.heights().get(height);
                row.add(percent(its.summary().covered(), its.summary())
                        + (its.summary().covered() > 0 ? "; most by " + ConditionTable.best(its) : ""));
            }
            rows.add(row);
        }
        List<String> words = conditions.stream()
                .skip(1)
                .map(one -> ConditionTable.words(conditions.get(0), one) + ".")
                .toList();
        return Html.plain(
                        "p",
                        "The table states the percentage of the known area that is covered, and the sensor that covers"
                                + " most, with its percentage.")
                + Html.table(head, rows)
                + list(words);
    }

    private List<String> conditions(SensorTables sensors) {
        FieldGrid grid = summary.coverage().field().grid();
        List<String> items = new ArrayList<>();
        items.add((inputs.area()
                        .map(name -> "The area assessed is the protected zone '" + name + "', in a square of ")
                        .orElse("The area assessed is "))
                + number(grid.columns() * grid.cell()) + " m by " + number(grid.columns() * grid.cell())
                + " m in cells of "
                + number(grid.cell()) + " m: anything smaller than a cell may be missed.");
        items.add(
                "Heights are measured from the ground, not from roofs. Places inside something solid do not count, nor do"
                        + " those that are unknown because they, or the line of sight to them, are beyond the known ground.");
        boolean mayHover =
                summary.coverage().field().courses().stream().anyMatch(course -> course.kind() == Course.Kind.HOVER);
        items.add("Only the drone '" + inputs.drone() + "' is assessed, in level flight at its cruise speed"
                + (mayHover ? " and hovering" : "") + "; sensors on positioners "
                + (inputs.terms().pointing() == FieldTerms.Turning.CUED
                        ? "have turned to it."
                        : "search for it: probabilities are means over one period of the search."));
        items.addAll(sensors.omissions());
        items.addAll(site.stage().siteNotes());
        items.addAll(site.stage().credits());
        return items;
    }

    private static String list(List<String> items) {
        return Html.element(
                "ul", items.stream().map(item -> Html.plain("li", item)).reduce("", String::concat));
    }
}
