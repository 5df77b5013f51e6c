package org.dronewatch.report.coverage.table;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.dronewatch.analysis.survey.FieldSummary;
import org.dronewatch.analysis.survey.HeightSummary;
import org.dronewatch.report.html.Html;
import org.dronewatch.sensor.Cause;
import org.dronewatch.setting.Counted;

/**
 * Why each sensor of a scene misses the drone, in the known cells of all heights: the dominant causes are those of the
 * sensor that comes nearest to a detection, and hide those of the others.
 */
public final class SensorCausesTable {
    /** Of more sensors than one beyond this number, the printed table has only this many. */
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

    /** The lines of the table; empty for a single sensor, whose causes are the dominant ones. */
    public List<String> lines() {
        List<String> lines = new ArrayList<>();
        if (!isNeeded()) {
            return lines;
        }
        List<Cause> columns = columns();
        lines.add("causes of each sensor's misses, in % of the known cells at all heights:");
        StringBuilder header = new StringBuilder(text(NAME, "sensor"));
        columns.forEach(cause -> header.append("  ").append(CoverageTable.name(cause)));
        lines.add(header.toString());
        // A line that says that one more sensor is left out would be as long as that sensor's row.
        int shown = causes.size() == MOST_ROWS + 1 ? causes.size() : MOST_ROWS;
        causes.entrySet().stream().limit(shown).forEach(sensor -> {
            StringBuilder line = new StringBuilder(text(NAME, sensor.getKey()));
            columns.forEach(cause -> line.append(
                    text("  %" + CoverageTable.name(cause).length() + "s", percent(sensor.getValue(), cause))));
            lines.add(line.toString());
        });
        if (causes.size() > shown) {
            lines.add("and " + Counted.of(causes.size() - shown, "more sensor") + " in report.html");
        }
        return lines;
    }

    /** The table of a report, with all sensors; empty for a single sensor. */
    public String html() {
        if (!isNeeded()) {
            return "";
        }
        List<Cause> columns = columns();
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
                        "The table states why each sensor by itself misses the drone in a look, in % of the known area"
                                + " at all heights.")
                + Html.table(head, rows);
    }

    /** Detected is the last of the causes and the first of the columns. */
    private List<Cause> columns() {
        Set<Cause> shown = EnumSet.noneOf(Cause.class);
        causes.values().forEach(its -> shown.addAll(its.keySet()));
        shown.remove(Cause.DETECTED);
        List<Cause> columns = new ArrayList<>(List.of(Cause.DETECTED));
        columns.addAll(shown);
        return columns;
    }

    private String percent(Map<Cause, Integer> its, Cause cause) {
        return CoverageTable.percent(its.getOrDefault(cause, 0), known);
    }

    private static String text(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
