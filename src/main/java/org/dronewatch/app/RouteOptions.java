package org.dronewatch.app;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.analysis.CoverageGrid;
import org.dronewatch.analysis.field.FieldGrid;
import org.dronewatch.analysis.field.FieldTerms;
import org.dronewatch.fusion.AreaZone;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import picocli.CommandLine.Option;

/** The options of {@code route} that decide over which cells it searches, and from where. */
final class RouteOptions {
    /** Heights above the ground at which a drone may fly, m. */
    static final List<Double> HEIGHTS = List.of(10.0, 20.0, 30.0, 45.0, 60.0, 90.0, 120.0, 150.0);

    private static final String LAUNCH = "--launch";
    private static final String RESPONSE = "--response";

    @Option(
            names = "--side",
            paramLabel = "L",
            description = "Length of a side of the area, centred on the protected zone or on the sensors; by"
                    + " default the area extends 250 m farther on each side than the drone flies during the response.")
    private String side;

    @Option(
            names = "--cell",
            paramLabel = "L",
            description = "Length of a cell's side; a hundredth of the area's side by default.")
    private String cell;

    @Option(
            names = "--heights",
            paramLabel = "H,H,...",
            description =
                    "Heights above the ground at which the drone may fly; 10, 20, 30, 45, 60, 90, 120 and 150 m by"
                            + " default.")
    private String heights;

    @Option(
            names = LAUNCH,
            paramLabel = "AREA",
            description = "Where the routes begin: a zone of the scene, or an area as scene files state it, such as"
                    + " '{centre: [0, 900], radius: 50 m}'; anywhere on the edge by default.")
    private String launch;

    @Option(
            names = RESPONSE,
            paramLabel = "S",
            description = "Time from a detection until the drone is stopped, in place of the scene's alert.response.")
    private String response;

    @Option(
            names = "--pointing",
            paramLabel = "search|cued",
            description = "How sensors on positioners point: searching, or turned to the drone and zoomed in; search by"
                    + " default, since nothing has cued them before the first detection.")
    private String pointing;

    /** Checks what can be checked before anything is loaded, and passes on the response. */
    void apply(SceneRunner runner) {
        heights();
        length("side", side);
        length("cell", cell);
        terms();
        if (response != null) {
            try {
                runner.set("alert.response", response);
                runner.settings();
            } catch (InputException e) {
                throw new InputException(
                        RESPONSE + " " + PlainText.value(response) + ": "
                                + e.getMessage().replaceFirst("^--set alert.response=\\S+: ", ""),
                        e);
            }
        }
    }

    /** On which terms the drone counts as detected in a look. */
    FieldTerms terms() {
        return FieldTerms.ONE_LOOK.withPointing(
                pointing == null
                        ? FieldTerms.Turning.SEARCH
                        : FieldOptions.word("--pointing", pointing, FieldTerms.Turning.values(), "search or cued"));
    }

    /**
     * The cells.
     *
     * @param middle of the area, m
     * @param usual length of its side unless another was given, m
     */
    FieldGrid grid(Position middle, double usual) {
        double across = length("side", side).orElse(usual);
        double edge = length("cell", cell).orElse(across / FieldGrid.DEFAULT_CELLS);
        FieldGrid grid;
        try {
            grid = new FieldGrid(middle.x(), middle.y(), across, edge, heights());
        } catch (IllegalArgumentException e) {
            throw new InputException((heights == null ? "--cell" : "--heights") + ": " + e.getMessage(), e);
        }
        if (grid.columns() < 2) {
            throw new InputException(
                    "--cell " + edge + " m: must be at most half the side of the area, " + across + " m");
        }
        return grid;
    }

    private static OptionalDouble length(String name, String text) {
        return text == null
                ? OptionalDouble.empty()
                : OptionalDouble.of((double) FieldOptions.value(name, text, FieldGrid.class, name));
    }

    private List<Double> heights() {
        if (heights == null) {
            return HEIGHTS;
        }
        List<Double> parsed = new ArrayList<>();
        for (String one : heights.split(",", -1)) {
            parsed.add((Double) FieldOptions.value("heights", one.strip(), CoverageGrid.class, "height"));
        }
        return parsed;
    }

    /** The area from which the routes come, in plan view; empty for the edge. */
    Optional<AreaZone> launchArea(SceneRunner runner, SceneSettings settings) {
        if (launch == null) {
            return Optional.empty();
        }
        if (launch.strip().startsWith("{")) {
            return Optional.of(new AreaZone("launch", runner.area(LAUNCH, launch, settings), 0.0, 0.0));
        }
        return Optional.of(AreaZone.inPlan(launch, settings.alert())
                .orElseThrow(() -> new InputException(LAUNCH + " " + PlainText.value(launch)
                        + ": neither a zone of the scene nor an area such as '{centre: [0, 900], radius: 50 m}'")));
    }

    /** The area from which the routes come as it was given. */
    Optional<String> launch() {
        return Optional.ofNullable(launch);
    }
}
