package org.dronewatch.report.placement;

import static org.dronewatch.report.html.ReadableNumbers.number;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.survey.HeightSummary;
import org.dronewatch.placement.plan.AirSettings;
import org.dronewatch.placement.site.LayoutFields;
import org.dronewatch.placement.site.SitePlacement;
import org.dronewatch.report.coverage.table.Losses;
import org.dronewatch.report.html.Figure;
import org.dronewatch.report.html.Html;
import org.dronewatch.run.Stage;

/** What the report says about the layout that covers the most air: coverage by height, losses and maps. */
final class CoverageChapter {
    private final CoveragePlaceResults results;
    private final SitePlacement best;
    private final Stage stage;

    CoverageChapter(CoveragePlaceResults results, Stage stage) {
        this.results = results;
        this.best = results.best();
        this.stage = stage;
    }

    PlaceChapter chapter() throws IOException {
        Map<String, Figure> pictures = new PlacePictures(results, stage).all();
        List<PlaceChapter.Section> sections = new ArrayList<>();
        ZoneTable zones = new ZoneTable(best);
        if (zones.isNeeded()) {
            sections.add(new PlaceChapter.Section("Coverage by zone", zones.html()));
        }
        if (results.fields().isPresent()) {
            LayoutFields fields = results.fields().get();
            sections.add(new PlaceChapter.Section("Coverage by height", byHeight(fields)));
            sections.add(new PlaceChapter.Section("If a sensor fails", losses(fields)));
            sections.add(new PlaceChapter.Section("Maps", PlaceReport.figures(pictures, shown(fields))));
        }
        return new PlaceChapter(new CoverageSentences(results).leastCovered(), pictures, sections, scope());
    }

    private String byHeight(LayoutFields fields) {
        int fold = best.plan().settings().conditions().fold();
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
                        "The table states the coverage" + FieldsTable.byOne(fold) + FieldsTable.heading(fields)
                                + (best.headings() > 1
                                        ? ", not " + ShareMeasure.mean(best.headings()) + " as in the tables above"
                                        : "")
                                + ", in % of the known area at each height; the same after the loss of the sensor that"
                                + " matters most there; and the largest gap. "
                                + FieldsTable.worstPlace(fields.layout())
                                + FieldsTable.differences(best).stream()
                                        .map(sentence -> " " + sentence)
                                        .collect(Collectors.joining()))
                + Html.table(head, rows);
    }

    /** The losses on the worst heading, beside those that count in the search: these may be those of other sensors. */
    private String losses(LayoutFields fields) {
        Losses losses = new Losses(fields.layout());
        if (best.headings() == 1) {
            return losses.html();
        }
        Map<String, String> without = new LinkedHashMap<>();
        best.withoutEach().forEach((sensor, value) -> without.put(sensor, FrontWords.percent(value)));
        return losses.html(Optional.of(new Losses.OtherFigure(
                "The figures of each height count only the heading that is worst in each cell; those in the first"
                        + " column are " + ShareMeasure.mean(best.headings())
                        + ", as in 'What to buy'. A sensor that adds much to the"
                        + " latter may add nothing to the former. ",
                "the coverage" + FieldsTable.heading(fields),
                "all heights, " + ShareMeasure.mean(best.headings()),
                FrontWords.percent(best.value()),
                without)));
    }

    private static List<String> figures(HeightSummary height) {
        HeightFigures figures = new HeightFigures(height);
        return List.of(figures.covered(), figures.afterNamedLoss(), figures.largestGap());
    }

    /** What changes at each height, and both layouts where the best covers least. */
    private Predicate<String> shown(LayoutFields fields) {
        String worst =
                PlacePictures.name("", CoverageSentences.leastCovered(fields).height());
        boolean isAlone = fields.present().isEmpty();
        return name -> name.startsWith("change")
                || name.startsWith("layout") && (isAlone || name.endsWith(worst))
                || name.startsWith("today") && name.endsWith(worst);
    }

    private List<String> scope() {
        FieldGrid grid = best.grid();
        AirSettings air = best.plan().settings().air();
        return List.of(
                "The airspace is "
                        + air.area()
                                .map(name -> "that over '" + name + "', in ")
                                .orElse("")
                        + "a square with sides of " + number(grid.columns() * grid.cell()) + " m, in cells of "
                        + number(grid.cell()) + " m, at heights of "
                        + grid.heights().stream().map(height -> number(height)).collect(Collectors.joining(", "))
                        + " m above the ground: anything smaller than a cell may be missed.",
                best.headings() > 1
                        ? "Unless stated otherwise, the " + ShareMeasure.inWords(best.headings())
                                + " headings of the drone count alike: a cell that is covered on half of them counts as half"
                                + " a cell."
                        : "The drone flies towards the protected zone.",
                PlaceReport.flight(best.plan()));
    }
}
