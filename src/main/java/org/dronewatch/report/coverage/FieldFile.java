package org.dronewatch.report.coverage;

import java.util.Locale;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectableHeights;
import org.dronewatch.analysis.field.InboundWarnings;
import org.dronewatch.analysis.field.VisibleHeights;
import org.dronewatch.analysis.field.Warning;
import org.dronewatch.analysis.layer.InterpolationError;
import org.dronewatch.analysis.survey.ConditionCoverage;
import org.dronewatch.analysis.survey.FieldSummary;
import org.dronewatch.analysis.survey.FieldSurvey;
import org.dronewatch.analysis.survey.Gap;
import org.dronewatch.analysis.survey.HeightSummary;
import org.dronewatch.report.coverage.table.CoverageInputs;
import org.dronewatch.report.file.JsonFile;
import org.dronewatch.report.file.Numbers;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** The contents of {@code coverage.json}. Equal inputs give the same bytes for any number of threads. */
public final class FieldFile {
    /** The version of the keys. */
    private static final int FORMAT = 1;

    private FieldFile() {}

    /** The contents, with all keys. */
    public static ObjectNode toJson(FieldSurvey survey, CoverageInputs inputs) {
        FieldSummary summary = survey.summary();
        FieldGrid grid = survey.grid();
        ObjectNode root = JsonNodeFactory.instance.objectNode();
        root.put("format", FORMAT);
        root.put("scene", inputs.scene());
        root.put("drone", inputs.drone());
        root.put("covered", Numbers.rounded(inputs.covered()));
        if (inputs.within().isPresent()) {
            root.put("within_s", Numbers.rounded(inputs.within().get()));
        } else {
            root.putNull("within_s");
        }
        root.put("heading", inputs.heading());
        root.put("pointing", inputs.terms().pointing().name().toLowerCase(Locale.ROOT));
        root.put("area", inputs.area().orElse(null));
        root.put("cell_m", Numbers.rounded(grid.cell()));
        root.put("cells_per_side", grid.columns());
        root.put("west_m", Numbers.rounded(grid.x(0) - 0.5 * grid.cell()));
        root.put("north_m", Numbers.rounded(grid.y(0) + 0.5 * grid.cell()));
        inputs.origin().ifPresent(origin -> JsonFile.add(root.putObject("origin"), origin));
        ArrayNode heights = root.putArray("heights");
        summary.heights().forEach(height -> add(heights.addObject(), height, survey));
        if (survey.hasAllHeights()) {
            ArrayNode idle = root.putArray("idle_sensors");
            summary.idleSensors().forEach(idle::add);
        } else {
            root.putNull("idle_sensors");
        }
        if (survey.detectable().isPresent()) {
            add(root.putObject("covered_again_gap"), survey.detectable().get());
        } else {
            root.putNull("covered_again_gap");
        }
        if (survey.warnings().isPresent()) {
            InboundWarnings warnings = survey.warnings().get();
            ArrayNode bearings = root.putArray("warning");
            warnings.all().forEach(one -> add(bearings.addObject(), one, warnings.response()));
        } else {
            root.putNull("warning");
        }
        if (survey.conditions().isEmpty()) {
            root.putNull("conditions");
        } else {
            ObjectNode conditions = root.putObject("conditions");
            survey.conditions().stream()
                    .skip(1)
                    .forEach(one -> add(conditions.putObject(one.name()).putArray("heights"), one));
        }
        summary.coverage()
                .field()
                .interpolated()
                .forEach((sensor, error) ->
                        add(root.withObjectProperty("interpolated").putObject(sensor), error));
        root.put("complete", survey.isComplete());
        return root;
    }

    private static void add(ArrayNode heights, ConditionCoverage condition) {
        for (ConditionCoverage.Height height : condition.heights()) {
            HeightSummary numbers = height.summary();
            ObjectNode node = heights.addObject();
            node.put("height_m", Numbers.rounded(numbers.height()));
            node.put("known", numbers.known());
            share(node, "covered_share", numbers.covered(), numbers.known());
            share(node, "lost_share", height.lost(), height.knownAsItIs());
            ObjectNode causes = node.putObject("causes");
            numbers.causes().forEach((cause, cells) -> share(causes, CauseKey.of(cause), cells, numbers.known()));
            ObjectNode sensors = node.putObject("sensors");
            height.bySensor().forEach((sensor, cells) -> share(sensors, sensor, cells, numbers.known()));
        }
    }

    private static void add(ObjectNode node, InterpolationError error) {
        node.put("places", error.places());
        node.put("held_out", error.heldOut());
        node.put("error_95_db", Numbers.rounded(error.percentile95()));
        node.put("look_error_95_db", Numbers.rounded(error.percentile95OfLooks()));
    }

    private static void add(ObjectNode node, DetectableHeights detectable) {
        share(node, "share", detectable.coveredAgain(), detectable.columns());
        node.put("largest_m", Numbers.rounded(detectable.largestGap()));
    }

    private static void add(ObjectNode node, HeightSummary height, FieldSurvey survey) {
        node.put("height_m", Numbers.rounded(height.height()));
        node.put("known", height.known());
        share(node, "unknown_share", height.unknown(), height.cells());
        share(node, "inside_share", height.inside(), height.cells());
        share(node, "covered_share", height.covered(), height.known());
        int visible = survey.visible().map(its -> its.count(height.height())).orElse(0);
        share(
                node,
                "visible_share",
                visible,
                survey.visible().map(VisibleHeights::columns).orElse(0));
        int detectable =
                survey.detectable().map(its -> its.count(height.height())).orElse(0);
        share(
                node,
                "detectable_share",
                detectable,
                survey.detectable().map(DetectableHeights::columns).orElse(0));
        node.put("volume_m3", Numbers.rounded(height.volume()));
        ObjectNode causes = node.putObject("causes");
        height.causes().forEach((cause, cells) -> share(causes, CauseKey.of(cause), cells, height.known()));
        ObjectNode bySensor = node.putObject("causes_by_sensor");
        height.causesBySensor().forEach((sensor, its) -> {
            ObjectNode own = bySensor.putObject(sensor);
            its.forEach((cause, cells) -> share(own, CauseKey.of(cause), cells, height.known()));
        });
        ObjectNode counts = node.putObject("count_shares");
        for (int sensors = 0; sensors < height.counts().length; sensors++) {
            if (height.counts()[sensors] > 0) {
                share(counts, String.valueOf(sensors), height.counts()[sensors], height.known());
            }
        }
        ObjectNode lost = node.putObject("n_minus_1");
        height.lost().forEach((sensor, cells) -> share(lost, sensor, cells, height.known()));
        node.put("largest_gap_m2", Numbers.rounded(height.gap().map(Gap::area).orElse(0.0)));
        if (height.gap().isPresent()) {
            add(node.putObject("gap"), height.gap().get());
        } else {
            node.putNull("gap");
        }
    }

    /**
     * Adds a warning. Whether it is in time is not stated if no response is required, or if its flight begins too near.
     */
    private static void add(ObjectNode node, Warning warning, double response) {
        node.put("bearing_deg", Numbers.rounded(Math.toDegrees(warning.bearing())));
        node.put("height_m", Numbers.rounded(warning.height()));
        if (warning.range().isPresent() && warning.time().isPresent()) {
            node.put("range_m", Numbers.rounded(warning.range().getAsDouble()));
            node.put("warning_s", Numbers.rounded(warning.time().getAsDouble()));
        } else {
            node.putNull("range_m");
            node.putNull("warning_s");
        }
        node.put("at_least", warning.isFromStart());
        if (response > 0.0 && !warning.isUndecided(response)) {
            node.put("in_time", warning.isInTime(response));
        } else {
            node.putNull("in_time");
        }
    }

    private static void add(ObjectNode node, Gap gap) {
        node.put("x", Numbers.rounded(gap.x()));
        node.put("y", Numbers.rounded(gap.y()));
        node.put("cause", CauseKey.of(gap.cause()));
        node.put("touches_rim", gap.touchesRim());
    }

    /** A fraction of cells; null where there are none. */
    private static void share(ObjectNode node, String key, int cells, int of) {
        if (of == 0) {
            node.putNull(key);
        } else {
            node.put(key, Numbers.rounded((double) cells / of));
        }
    }
}
