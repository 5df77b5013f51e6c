package org.dronewatch.report.coverage.table;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.dronewatch.analysis.survey.FieldSummary;
import org.dronewatch.analysis.survey.HeightSummary;
import org.dronewatch.report.html.Html;
import org.dronewatch.sensor.Cause;
import org.dronewatch.setting.Counted;

/**
 * Why each sensor of a scene misses the drone, in the known cells of all heights. The dominant cause of a cell, by
 * contrast, is only that of the sensor that comes nearest to a detection.
 */
public final class SensorCausesTable {
    /** With more than one sensor beyond this number, only this many rows are printed. */
    private static final int MOST_ROWS = 12;

    private static final String NAME = "%-24s";

    private final Map<String, Map<Cause, Integer>> causes;
    private final int known;

    /** The table for a summary of all heights. */
    public SensorCausesTable(FieldSummary summary) {
        this(
                summary.causesBySensor(),
                summary.heights().stream().mapToInt(HeightSummary::known).sum());
    }

    /**
     * The table for numbers of cells.
     *
     * @param causes by sensor, the number of known cells by cause
     * @param known number of known cells
     */
    SensorCausesTable(Map<String, Map<Cause, Integer>> causes, int known) {
        this.causes = causes;
        this.known = known;
    }

    /** Whether it adds something to the dominant causes: there are several sensors, and cells to assess. */
    private boolean isNeeded() {
        return causes.size() > 1 && known > 0;
    }

    /**
     * The lines of the table; empty for a single sensor, whose causes are the dominant ones.
     *
     * @param inputs inputs of the coverage
     * @param report where the rows that are not printed can be found, such as {@code in field/report.html}
     */
    public List<String> lines(CoverageInputs inputs, String report) {
        List<String> lines = new ArrayList<>();
        if (!isNeeded()) {
            return lines;
        }
        CauseColumns columns = CauseColumns.of(causes.values());
        lines.add("what each sensor detects by itself, and why it misses the rest, in % of the known cells"
                + inputs.areaInWords() + " at all heights:");
        lines.add(text(NAME, "sensor") + columns.head());
        // A line that says that one more sensor is left out would be as long as that sensor's row.
        int shown = causes.size() == MOST_ROWS + 1 ? causes.size() : MOST_ROWS;
        causes.entrySet().stream()
                .limit(shown)
                .forEach(sensor -> lines.add(text(NAME, sensor.getKey())
                        + columns.row(cause -> sensor.getValue().getOrDefault(cause, 0), known)));
        if (causes.size() > shown) {
            lines.add("and " + Counted.of(causes.size() - shown, "more sensor") + " (" + report + ")");
        }
        inputs.detectedInASentence().ifPresent(lines::add);
        return lines;
    }

    /**
     * The table of a report, with all sensors; empty for a single sensor.
     *
     * @param inputs inputs of the coverage
     */
    public String html(CoverageInputs inputs) {
        if (!isNeeded()) {
            return "";
        }
        List<Cause> columns = CauseColumns.of(causes.values()).causes();
        List<String> head = new ArrayList<>(List.of("sensor"));
        columns.forEach(cause -> head.add(CoverageTable.name(cause) + " [%]"));
        List<List<String>> rows = new ArrayList<>();
        causes.forEach((sensor, its) -> {
            List<String> row = new ArrayList<>(List.of(sensor));
            columns.forEach(cause -> row.add(percent(its, cause)));
            rows.add(row);
        });
        return Html.plain(
                        "p",
                        "The table states what each sensor detects by itself, and why it misses the rest, in % of the"
                                + " known area" + inputs.areaInWords() + " at all heights."
                                + inputs.detectedInASentence().map(" "::concat).orElse(""))
                + Html.table(head, rows);
    }

    private String percent(Map<Cause, Integer> its, Cause cause) {
        return CoverageTable.percent(its.getOrDefault(cause, 0), known);
    }

    private static String text(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
