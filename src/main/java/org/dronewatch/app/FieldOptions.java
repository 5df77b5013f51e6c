package org.dronewatch.app;

import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import org.dronewatch.analysis.CoverageGrid;
import org.dronewatch.analysis.field.Course;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldGrid;
import org.dronewatch.analysis.field.FieldHeading;
import org.dronewatch.analysis.field.FieldTerms;
import org.dronewatch.analysis.field.InboundTarget;
import org.dronewatch.fusion.AreaZone;
import org.dronewatch.fusion.Protection;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneCondition;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.In;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingText;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.setting.Spelling;
import picocli.CommandLine.Option;

/** The options of {@code coverage} for several heights. */
final class FieldOptions {
    private static final String HEIGHTS = "--heights";
    private static final String CELL = "--cell";
    private static final String CENTRE = "--centre";
    private static final String HEADING = "--heading";
    private static final String COVERED = "--covered";
    private static final String WITHIN = "--within";
    private static final String AREA = "--area";
    private static final String POINTING = "--pointing";
    private static final String CONDITIONS = "--conditions";

    @Option(
            names = HEIGHTS,
            paramLabel = "H,H,...",
            description = "Heights above the ground; 10, 30, 60, 120 and 150 m by default.")
    private String heights;

    @Option(
            names = CELL,
            paramLabel = "L",
            description = "Length of a cell's side; a hundredth of the area's side by default.")
    private String cell;

    @Option(
            names = CENTRE,
            paramLabel = "EAST,NORTH",
            description = "Middle of the area in the scene's frame; the middle of the sensors by default.")
    private String centre;

    @Option(
            names = HEADING,
            paramLabel = "worst|best|inbound",
            description = "Heading of the drone: the one on which the sensors together are least or most likely to"
                    + " detect it, or towards the protected zone; worst by default.")
    private String heading;

    @Option(
            names = COVERED,
            paramLabel = "P",
            description =
                    "The probability with which a sensor covers a cell, in one look or within a time (--within), above"
                            + " 0 and at most 1; 0.5 by default.")
    private Double covered;

    @Option(
            names = WITHIN,
            paramLabel = "S",
            description = "Time in which a sensor has to detect the drone with that probability, as long as it stays"
                    + " in its cell; one look by default.")
    private String within;

    @Option(
            names = AREA,
            paramLabel = "NAME",
            description = "A protected zone of the scene, in place of --side: only cells whose centre is in it count.")
    private String area;

    @Option(
            names = POINTING,
            paramLabel = "cued|search",
            description = "How sensors on positioners point: turned to the drone and zoomed in, or searching; cued by"
                    + " default.")
    private String pointing;

    @Option(
            names = CONDITIONS,
            paramLabel = "FILE",
            description = "YAML file of conditions, such as night or rain, under which the coverage is assessed again:"
                    + " under each name, settings by their paths.")
    private String conditions;

    /** The first of these options that was given; null if none was. */
    String given() {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put(HEIGHTS, heights);
        values.put(CELL, cell);
        values.put(CENTRE, centre);
        values.put(HEADING, heading);
        values.put(COVERED, covered);
        values.put(WITHIN, within);
        values.put(AREA, area);
        values.put(POINTING, pointing);
        values.put(CONDITIONS, conditions);
        return values.entrySet().stream()
                .filter(option -> option.getValue() != null)
                .map(Map.Entry::getKey)
                .findFirst()
                .orElse(null);
    }

    /**
     * The cells: of a protected area, or around the sensors.
     *
     * @param side length of the side around the sensors, m; empty if none was given
     */
    FieldGrid grid(SceneSettings settings, OptionalDouble side) {
        if (area != null && (side.isPresent() || centre != null)) {
            throw new InputException(AREA + " " + PlainText.value(area) + ": cannot be combined with "
                    + (side.isPresent() ? "--side" : CENTRE));
        }
        Position middle = centre == null ? InboundTarget.sensors(settings) : centre();
        try {
            return area == null
                    ? square(middle, side.orElse(FieldGrid.DEFAULT_SIDE))
                    : over(AreaZone.inPlan(area, settings.alert()).orElseThrow(() -> noArea(settings)));
        } catch (IllegalArgumentException e) {
            throw new InputException((heights == null ? CELL : HEIGHTS) + ": " + e.getMessage(), e);
        }
    }

    private Position centre() {
        String[] parts = centre.split(",", -1);
        if (parts.length != 2) {
            throw new InputException(
                    CENTRE + " " + PlainText.value(centre) + ": must be EAST,NORTH, such as 100m,-50m");
        }
        return new Position(
                (double) value("centre", parts[0].strip(), FieldGrid.class, "east"),
                (double) value("centre", parts[1].strip(), FieldGrid.class, "north"),
                0.0);
    }

    private FieldGrid square(Position middle, double side) {
        return new FieldGrid(middle.x(), middle.y(), side, edge(side), heights());
    }

    private FieldGrid over(AreaZone zone) {
        double side = FieldGrid.over(zone, In.FARTHEST, heights()).side();
        FieldGrid grid = FieldGrid.over(zone, edge(side), heights());
        boolean isEmpty = IntStream.range(0, grid.cells())
                .allMatch(at -> grid.isOutside(at % grid.columns(), at / grid.columns()));
        if (isEmpty) {
            throw new InputException(CELL + " " + grid.cell() + " m: must be smaller, since no cell has its centre in '"
                    + zone.name() + "'");
        }
        return grid;
    }

    private double edge(double side) {
        return cell == null ? side / FieldGrid.DEFAULT_CELLS : (double) value("cell", cell, FieldGrid.class, "cell");
    }

    private InputException noArea(SceneSettings settings) {
        List<String> known = new ArrayList<>(settings.alert().zones().keySet());
        settings.alert().protect().ifPresent(ball -> known.add(Protection.ZONE));
        return new InputException(AREA + " " + PlainText.value(area) + ": no such zone; the scene protects "
                + (known.isEmpty() ? "nothing" : String.join(", ", known)) + Spelling.didYouMean(area, known));
    }

    /** The conditions; none without a file. */
    List<SceneCondition> conditions() {
        return conditions == null ? List.of() : SceneCondition.read(PathWord.of(CONDITIONS, conditions));
    }

    /** The name of the protected area; empty if none was given. */
    Optional<String> area() {
        return Optional.ofNullable(area);
    }

    /** On which terms the drone counts as detected. */
    FieldTerms terms() {
        FieldTerms pointed = FieldTerms.ONE_LOOK.withPointing(turning());
        return within == null
                ? pointed
                : new FieldTerms(pointed.pointing(), optional(value("within", within, FieldTerms.class, "within")));
    }

    private FieldTerms.Turning turning() {
        return pointing == null
                ? FieldTerms.Turning.CUED
                : word(POINTING, pointing, FieldTerms.Turning.values(), "cued or search");
    }

    /** One of a few words. */
    static <E extends Enum<E>> E word(String option, String given, E[] words, String known) {
        for (E one : words) {
            if (one.name().toLowerCase(Locale.ROOT).equals(given)) {
                return one;
            }
        }
        throw new InputException((option + " " + PlainText.value(given)).strip() + ": must be " + known);
    }

    private static Optional<Double> optional(Object value) {
        return ((Optional<?>) value).map(Double.class::cast);
    }

    private List<Double> heights() {
        if (heights == null) {
            return FieldGrid.HEIGHTS;
        }
        List<Double> parsed = new ArrayList<>();
        for (String one : heights.split(",", -1)) {
            parsed.add((Double) value("heights", one.strip(), CoverageGrid.class, "height"));
        }
        return parsed;
    }

    /** The value of an option, with the unit and the limits of a component of a record. */
    static Object value(String option, String text, Class<? extends Record> type, String name) {
        RecordComponent part = SettingsForm.of(type).part(name).orElseThrow();
        try {
            Object value = SettingText.parse(part, text);
            Limits.check(part, value);
            return value;
        } catch (IllegalArgumentException e) {
            throw new InputException("--" + option + " " + PlainText.value(text) + ": " + e.getMessage(), e);
        }
    }

    /** The probability with which a sensor covers a cell. */
    double covered() {
        double asked = covered == null ? FieldCoverage.DEFAULT_COVERED : covered;
        if (!(asked > 0.0 && asked <= 1.0)) {
            throw new InputException(COVERED + " " + Quantity.RATIO.inWords(asked) + ": must be above 0 and at most 1");
        }
        return asked;
    }

    /** The heading as files state it. */
    String heading() {
        return kind().word();
    }

    private FieldHeading kind() {
        return heading == null
                ? FieldHeading.WORST
                : word(HEADING, heading, FieldHeading.values(), "worst, best or inbound");
    }

    /** The courses of a drone that have to be assessed. */
    List<Course> courses(SceneSettings settings, Stage stage, String drone, FieldGrid grid) {
        return kind().courses(settings, stage, drone, grid);
    }

    /** Which of them counts. */
    FieldCoverage.Choice choice() {
        return kind().choice();
    }
}
