package org.dronewatch.app;

import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dronewatch.analysis.CoverageGrid;
import org.dronewatch.analysis.field.Course;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldGrid;
import org.dronewatch.analysis.field.InboundTarget;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.SettingText;
import org.dronewatch.setting.SettingsForm;
import picocli.CommandLine.Option;

/** The options of {@code coverage} for several heights. */
final class FieldOptions {
    private static final String HEIGHTS = "--heights";
    private static final String CELL = "--cell";
    private static final String HEADING = "--heading";
    private static final String COVERED = "--covered";
    private static final double DEFAULT_COVERED = 0.5;
    private static final double CELLS = 100.0;

    /** Which heading of the drone counts. */
    private enum Heading {
        WORST,
        BEST,
        INBOUND
    }

    @Option(
            names = HEIGHTS,
            paramLabel = "H,H,...",
            description = "Heights above the ground; 10, 30, 60, 120 and 150 m by default.")
    private String heights;

    @Option(
            names = CELL,
            paramLabel = "L",
            description = "Length of a cell's side; a hundredth of that of the area by default.")
    private String cell;

    @Option(
            names = HEADING,
            paramLabel = "worst|best|inbound",
            description = "Heading of the drone: the one on which the sensors together are least or most likely to"
                    + " detect it, or towards the protected zone; worst by default.")
    private String heading;

    @Option(
            names = COVERED,
            paramLabel = "P",
            description = "The probability of one look with which a sensor covers a cell, above 0 and at most 1; 0.5 by"
                    + " default.")
    private Double covered;

    /** The first of these options that was given; null if none was. */
    String given() {
        return heights != null
                ? HEIGHTS
                : cell != null ? CELL : heading != null ? HEADING : covered != null ? COVERED : null;
    }

    /**
     * The cells.
     *
     * @param side length of the area's side, m
     */
    FieldGrid grid(Position middle, double side) {
        double edge = cell == null ? side / CELLS : length("cell", cell, FieldGrid.class, "cell");
        try {
            return new FieldGrid(middle.x(), middle.y(), side, edge, heights());
        } catch (IllegalArgumentException e) {
            throw new InputException((heights == null ? CELL : HEIGHTS) + ": " + e.getMessage(), e);
        }
    }

    private List<Double> heights() {
        if (heights == null) {
            return FieldGrid.HEIGHTS;
        }
        List<Double> parsed = new ArrayList<>();
        for (String one : heights.split(",", -1)) {
            parsed.add(length("heights", one.strip(), CoverageGrid.class, "height"));
        }
        return parsed;
    }

    private static double length(String option, String text, Class<? extends Record> type, String name) {
        RecordComponent part = SettingsForm.of(type).part(name).orElseThrow();
        try {
            Object value = SettingText.parse(part, text);
            Limits.check(part, value);
            return (double) value;
        } catch (IllegalArgumentException e) {
            throw new InputException("--" + option + " " + PlainText.value(text) + ": " + e.getMessage(), e);
        }
    }

    /** The probability with which a sensor covers a cell. */
    double covered() {
        double asked = covered == null ? DEFAULT_COVERED : covered;
        if (!(asked > 0.0 && asked <= 1.0)) {
            throw new InputException(COVERED + " " + covered + ": must be above 0 and at most 1");
        }
        return asked;
    }

    /** The heading as files state it. */
    String heading() {
        return kind().name().toLowerCase(Locale.ROOT);
    }

    private Heading kind() {
        if (heading == null) {
            return Heading.WORST;
        }
        for (Heading one : Heading.values()) {
            if (one.name().toLowerCase(Locale.ROOT).equals(heading)) {
                return one;
            }
        }
        throw new InputException(HEADING + " " + PlainText.value(heading) + ": must be worst, best or inbound");
    }

    /** The courses of a drone that have to be assessed. */
    List<Course> courses(SceneSettings settings, Stage stage, String drone) {
        return kind() == Heading.INBOUND
                ? List.of(Course.inbound(InboundTarget.of(settings, stage.protection())))
                : Course.all(settings.enabledSensors(), DetectionField.droneOf(stage, drone));
    }

    /** Which of them counts. */
    FieldCoverage.Choice choice() {
        return kind() == Heading.BEST ? FieldCoverage.Choice.BEST : FieldCoverage.Choice.WORST;
    }
}
