package org.dronewatch.report.placement;

import static org.dronewatch.report.html.ReadableNumbers.number;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.dronewatch.analysis.field.FieldHeading;
import org.dronewatch.analysis.field.InboundWarnings;
import org.dronewatch.placement.plan.AirSettings;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.site.LayoutWarnings;
import org.dronewatch.placement.site.WarningPlacement;
import org.dronewatch.report.coverage.WarningMap;
import org.dronewatch.report.coverage.WarningWords;
import org.dronewatch.report.coverage.table.CoverageInputs;
import org.dronewatch.report.coverage.table.CoverageSite;
import org.dronewatch.report.html.Figure;
import org.dronewatch.report.sheet.MapSheet;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;

/** What the report says about the layout with the longest warning: by bearing and height, beside today's. */
final class WarningChapter {
    private final WarningPlaceResults results;
    private final WarningPlacement best;
    private final PlacePlan plan;
    private final Stage stage;

    WarningChapter(WarningPlaceResults results, Stage stage) {
        this.results = results;
        this.best = results.best();
        this.plan = best.plan();
        this.stage = stage;
    }

    PlaceChapter chapter() throws IOException {
        Map<String, Figure> pictures = new LinkedHashMap<>();
        List<PlaceChapter.Section> sections = new ArrayList<>();
        if (results.warnings().isPresent()) {
            LayoutWarnings warnings = results.warnings().get();
            int[] ground = MapSheet.ground(stage.world(), best.grid());
            pictures.put("warnings.png", map(warnings.layout(), warnings.settings(), "best layout", ground));
            sections.add(section("Warning given by the best layout", warnings.layout(), pictures, "warnings.png"));
            if (warnings.present().isPresent()) {
                InboundWarnings own = warnings.present().get();
                pictures.put("warnings-today.png", map(own, plan.present(), "today's layout", ground));
                sections.add(section("Warning given by today's layout", own, pictures, "warnings-today.png"));
            }
        }
        String verdict = best.chosen().isEmpty() ? "" : new WarningSentences(best, results.measure()).detected();
        return new PlaceChapter(verdict, pictures, sections, scope());
    }

    private static PlaceChapter.Section section(
            String title, InboundWarnings warnings, Map<String, Figure> pictures, String picture) {
        return new PlaceChapter.Section(
                title, new WarningWords(warnings).html() + PlaceReport.figures(pictures, picture::equals));
    }

    private Figure map(InboundWarnings warnings, SceneSettings settings, String title, int[] ground)
            throws IOException {
        AirSettings air = plan.settings().air();
        CoverageInputs inputs = new CoverageInputs(
                plan.scene().name() + ", " + title,
                plan.drone(),
                FieldHeading.INBOUND.word(),
                air.covered(),
                air.terms(),
                air.area(),
                plan.present().world().origin());
        return new WarningMap(new CoverageSite(settings, stage), inputs)
                .sheet(best.grid(), ground, warnings)
                .figure();
    }

    private List<String> scope() {
        List<String> scope = new ArrayList<>(List.of(
                "The drone flies straight in from " + InboundWarnings.BEARINGS + " bearings, at heights of "
                        + best.grid().heights().stream()
                                .map(height -> number(height))
                                .collect(Collectors.joining(", "))
                        + " m above the ground, and the sensors look for it every "
                        + number(best.grid().cell()) + " m: what a sensor detects over a shorter distance may be"
                        + " missed.",
                PlaceReport.flight(plan)));
        new WarningSentences(best, results.measure()).difference().ifPresent(scope::add);
        return scope;
    }
}
