package org.dronewatch.report.coverage.table;

import java.util.ArrayList;
import java.util.Collection;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.function.ToIntFunction;
import org.dronewatch.sensor.Cause;

/**
 * The columns of a table with a row for each sensor: one for what the sensor detects, then one for each cause of misses
 * that occurs.
 */
record CauseColumns(List<Cause> causes) {
    /** Detected is the last of the causes and the first of the columns. */
    static CauseColumns of(Collection<Map<Cause, Integer>> rows) {
        Set<Cause> shown = EnumSet.noneOf(Cause.class);
        rows.forEach(row -> shown.addAll(row.keySet()));
        shown.remove(Cause.DETECTED);
        List<Cause> causes = new ArrayList<>(List.of(Cause.DETECTED));
        causes.addAll(shown);
        return new CauseColumns(causes);
    }

    /** The heads of the columns, as the end of a line. */
    String head() {
        StringBuilder head = new StringBuilder();
        causes.forEach(cause -> head.append("  ").append(CoverageTable.name(cause)));
        return head.toString();
    }

    /**
     * A row, as the end of a line.
     *
     * @param cells number of cells for each cause
     * @param of number of all cells
     */
    String row(ToIntFunction<Cause> cells, int of) {
        StringBuilder row = new StringBuilder();
        causes.forEach(cause -> row.append(String.format(
                Locale.ROOT,
                "  %" + CoverageTable.name(cause).length() + "s",
                CoverageTable.percent(cells.applyAsInt(cause), of))));
        return row.toString();
    }
}
