package org.dronewatch.report.placement;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.analysis.survey.FieldSummary;
import org.dronewatch.geometry.Position;
import org.dronewatch.placement.plan.AirSettings;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.site.LayoutFields;
import org.dronewatch.report.coverage.CauseMap;
import org.dronewatch.report.coverage.ChangeMap;
import org.dronewatch.report.coverage.table.CoverageInputs;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.report.html.Figure;
import org.dronewatch.report.sheet.MapSheet;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.PlainText;

/** Maps of what the layout and the scene's own sensors cover at each height. */
final class PlacePictures {
    /** The greatest number of labels on a map. */
    private static final int MOST_NAMES = 12;

    /** Labels of sensors within this fraction of the map's side would cover each other. */
    private static final double NEAR = 0.03;

    private final CoveragePlaceResults results;
    private final PlacePlan plan;
    private final Stage stage;

    PlacePictures(CoveragePlaceResults results, Stage stage) {
        this.results = results;
        this.plan = results.best().plan();
        this.stage = stage;
    }

    /**
     * The pictures by the names of their files, drawn on the {@link org.dronewatch.parallel.Workers} of the calling
     * thread.
     */
    Map<String, Figure> all() throws IOException {
        Map<String, Figure> figures = new LinkedHashMap<>();
        if (results.fields().isPresent()) {
            LayoutFields fields = results.fields().get();
            int[] ground = MapSheet.ground(stage.world(), results.best().grid());
            for (int height = 0; height < fields.layout().heights().size(); height++) {
                figures.put(name("layout", above(height)), causes(fields.layout(), fields.settings(), height, ground));
                if (fields.present().isPresent()) {
                    figures.put(
                            name("today", above(height)),
                            causes(fields.present().get(), plan.present(), height, ground));
                    figures.put(name("change", above(height)), change(fields, height, ground));
                }
            }
        }
        return figures;
    }

    /** The name of a map's file: {@code layout-30.png}. */
    static String name(String what, double height) {
        return what + "-" + Numbers.text(height) + ".png";
    }

    private double above(int height) {
        return results.best().grid().heights().get(height);
    }

    private Figure causes(FieldSummary summary, SceneSettings settings, int height, int[] ground) throws IOException {
        boolean isToday = settings == plan.present();
        MapSheet sheet = new MapSheet(results.best().grid());
        CauseMap map = new CauseMap(summary, height, inputs());
        sheet.drawMap(ground, map::fill, positions(settings));
        label(sheet, settings);
        sheet.credits(stage.credits());
        sheet.title(isToday ? "today's layout" : "best layout");
        map.writeLegend(sheet);
        sheet.caption((isToday ? "Today's layout" : "The best layout") + " at " + Numbers.text(above(height))
                + " m above the ground: where it detects the drone, and elsewhere the main reason why not.");
        return sheet.figure();
    }

    private Figure change(LayoutFields fields, int height, int[] ground) throws IOException {
        MapSheet sheet = new MapSheet(results.best().grid());
        ChangeMap map = new ChangeMap(
                fields.present().orElseThrow().coverage(), fields.layout().coverage(), height);
        sheet.drawMap(ground, map::fill, positions(fields.settings()));
        positions(plan.present()).forEach(sheet::square);
        label(sheet, fields.settings());
        sheet.credits(stage.credits());
        sheet.title("what changes");
        String above = Numbers.text(above(height)) + " m";
        sheet.line("best layout compared with today's");
        sheet.line("at " + above + " above the ground,");
        sheet.line(inputs().headingInWords() + ":");
        sheet.space();
        map.writeLegend(sheet);
        sheet.space();
        sheet.squareSample("sensor of today's layout");
        sheet.line("dots: sensors of the best layout");
        sheet.line("cells of " + Numbers.text(results.best().grid().cell()) + " m");
        sheet.caption("At " + above + " above the ground: what the best layout covers and today's does not, and the"
                + " reverse (" + map.inWords() + ").");
        return sheet.figure();
    }

    private static List<Position> positions(SceneSettings settings) {
        return settings.enabledSensors().values().stream()
                .map(sensor -> sensor.position())
                .toList();
    }

    /** Names the sensors; those that are almost at one place share a label. */
    private void label(MapSheet sheet, SceneSettings settings) {
        double near = NEAR * results.best().grid().side();
        Map<Position, List<String>> groups = new LinkedHashMap<>();
        settings.enabledSensors().forEach((name, sensor) -> {
            Position at = groups.keySet().stream()
                    .filter(other -> Math.hypot(
                                    other.x() - sensor.position().x(),
                                    other.y() - sensor.position().y())
                            < near)
                    .findFirst()
                    .orElse(sensor.position());
            groups.computeIfAbsent(at, first -> new ArrayList<>()).add(name);
        });
        if (groups.size() <= MOST_NAMES) {
            groups.forEach((at, names) -> sheet.label(
                    at,
                    names.size() <= 2
                            ? PlainText.list(names)
                            : names.get(0) + " and " + (names.size() - 1) + " others"));
            sheet.frame();
        }
    }

    private CoverageInputs inputs() {
        AirSettings air = plan.settings().air();
        return new CoverageInputs(
                plan.scene().name(),
                plan.drone(),
                results.fields().orElseThrow().heading().word(),
                air.covered(),
                air.terms(),
                air.area(),
                plan.present().world().origin());
    }
}
