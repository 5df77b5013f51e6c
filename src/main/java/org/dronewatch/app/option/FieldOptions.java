package org.dronewatch.app.option;

import java.lang.reflect.RecordComponent;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldHeading;
import org.dronewatch.scenario.SceneCondition;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.SettingText;
import org.dronewatch.setting.SettingsForm;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The options of {@code coverage} for several heights. */
public final class FieldOptions {
    private static final String HEADING = "--heading";
    private static final String COVERED = "--covered";
    private static final String WITHIN = "--within";
    private static final String POINTING = "--pointing";
    private static final String CONDITIONS = "--conditions";

    @Mixin
    private GridOptions cells = new GridOptions();

    @Option(
            names = HEADING,
            paramLabel = "worst|best|inbound",
            description = "Heading of the drone: the one on which the sensors together are least or most likely to"
                    + " detect it, or towards the protected zone; worst by default.")
    private String heading;

    @Option(
            names = COVERED,
            paramLabel = "P",
            description = "Minimum probability of detection, in one look or within a time (--within), at which a sensor"
                    + " covers a cell: 0.008 to 0.996, or 1; probabilities are compared in steps of 1/250; 0.5"
                    + " by default.")
    private Double covered;

    @Option(
            names = WITHIN,
            paramLabel = "S",
            description = "Time within which a sensor must detect the drone with the probability of --covered while the"
                    + " drone stays in its cell; a single look by default.")
    private String within;

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
                    + " for each name, the settings that change, by their paths.")
    private String conditions;

    /** The first of the options for several heights that was given; null if none was. */
    public String given() {
        Map<String, Object> values = cells.values();
        values.put(HEADING, heading);
        values.put(COVERED, covered);
        values.put(WITHIN, within);
        values.put(POINTING, pointing);
        values.put(CONDITIONS, conditions);
        return values.entrySet().stream()
                .filter(option -> option.getValue() != null)
                .map(Map.Entry::getKey)
                .findFirst()
                .orElse(null);
    }

    /**
     * The cells, which cover a protected area or a square around the sensors.
     *
     * @param side side of the area around the sensors, m; empty if none was given
     */
    public FieldGrid grid(SceneSettings settings, OptionalDouble side) {
        return cells.grid(settings, side);
    }

    /** The conditions; none if no file was given. */
    public List<SceneCondition> conditions() {
        return conditions == null ? List.of() : SceneCondition.read(PathWord.of(CONDITIONS, conditions));
    }

    /** The name of the protected area; empty if none was given. */
    public Optional<String> area() {
        return cells.area();
    }

    /** The terms on which the drone counts as detected. */
    public FieldTerms terms() {
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

    /** The constant for an option's value that must be one of a few words. */
    static <E extends Enum<E>> E word(String option, String given, E[] words, String known) {
        for (E one : words) {
            if (one.name().toLowerCase(Locale.ROOT).equals(given)) {
                return one;
            }
        }
        throw new InputException(GivenOption.words(option, given) + ": must be " + known);
    }

    private static Optional<Double> optional(Object value) {
        return ((Optional<?>) value).map(Double.class::cast);
    }

    /**
     * Parses the value of an option as that of a component of a record, with the component's unit and limits.
     *
     * @param option name of the option in messages, without {@code --}
     * @param text the value as given on the command line
     * @param type type of the record
     * @param name name of the component
     * @throws InputException with a one-line message when the text is not a value within the limits
     */
    public static Object value(String option, String text, Class<? extends Record> type, String name) {
        RecordComponent part = SettingsForm.of(type).part(name).orElseThrow();
        try {
            Object value = SettingText.parse(part, text);
            Limits.check(part, value);
            return value;
        } catch (IllegalArgumentException e) {
            throw new InputException(GivenOption.words("--" + option, text) + ": " + e.getMessage(), e);
        }
    }

    /** The least probability of detection at which a sensor covers a cell. */
    public double covered() {
        double asked = covered == null ? FieldCoverage.DEFAULT_COVERED : covered;
        try {
            return FieldCoverage.checkedProbability(asked);
        } catch (IllegalArgumentException e) {
            throw new InputException(COVERED + " " + e.getMessage(), e);
        }
    }

    /** The word for the heading in files: {@code worst}, {@code best} or {@code inbound}. */
    public String heading() {
        return kind().word();
    }

    /** The drone's heading for which the coverage counts: the worst, the best, or inbound. */
    public FieldHeading kind() {
        return heading == null
                ? FieldHeading.WORST
                : word(HEADING, heading, FieldHeading.values(), "worst, best or inbound");
    }

    /** Which of the drone's headings counts. */
    public FieldCoverage.Choice choice() {
        return kind().choice();
    }
}
