package org.dronewatch.report.coverage.table;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.dronewatch.analysis.Coverage;
import org.dronewatch.sensor.Cause;

/**
 * Tables of a {@link Coverage}: the areas in which sensors detect the drone, and the reasons why each misses it
 * elsewhere.
 */
public final class CoverageTable {
    /** The words for a sensor that may detect the drone, but less often than required. */
    static final String TOO_RARELY = "detected, but with too low a probability";

    private static final String NAMES = "%-24s %-10s";
    /** Fractions below this are more than nothing, but less than what a table shows, %. */
    private static final double LEAST_SHOWN = 0.05;

    /** Fractions of at least this are less than all, but round to 100, %. */
    private static final double MOST_ROUNDED = 99.95;

    private CoverageTable() {}

    /** The area in which each sensor detects the drone, a line for each. */
    public static List<String> areas(Coverage coverage) {
        List<String> lines = new ArrayList<>();
        lines.add(format(NAMES + " %13s", "sensor", "kind", "detected [ha]"));
        coverage.sensors()
                .forEach((id, sensor) ->
                        lines.add(format(NAMES + " %13.2f", id, sensor.kind(), 1e-4 * coverage.area(id))));
        return lines;
    }

    /**
     * The fractions of the cells with ground in which each sensor detects the drone and, by cause, misses it; a line
     * for each sensor, a column for each cause that occurs.
     *
     * @param causes number of cells for each cause, by sensor, as {@link Coverage#causes} returns it
     */
    public static List<String> causes(Coverage coverage, Map<String, Map<Cause, Integer>> causes) {
        CauseColumns columns = CauseColumns.of(causes.values());
        List<String> lines = new ArrayList<>();
        lines.add(format("in %% of the %,d cells with ground below them:", coverage.groundCells()));
        lines.add(format(NAMES, "sensor", "kind") + columns.head());
        coverage.sensors()
                .forEach((id, sensor) -> lines.add(format(NAMES, id, sensor.kind())
                        + columns.row(
                                cause -> cause == Cause.DETECTED
                                        ? coverage.reachedCells(id)
                                        : causes.get(id).getOrDefault(cause, 0),
                                coverage.groundCells())));
        return lines;
    }

    /** A cause in words, such as {@code hidden by terrain}. */
    public static String name(Cause cause) {
        return switch (cause) {
            case UNKNOWN -> "unknown";
            case OUT_OF_RANGE -> "out of range";
            case OUT_OF_VIEW -> "out of view";
            case SILENT -> "no recognised emission";
            case TOO_SLOW -> "too slow";
            case TOO_FAST -> "too fast";
            case HIDDEN_BY_TERRAIN -> "hidden by terrain";
            case HIDDEN_BY_BUILDING -> "hidden by a building";
            case HIDDEN_BY_VEGETATION -> "hidden by vegetation";
            case HIDDEN_BY_OTHER -> "hidden by another object";
            case TOO_WEAK -> "signal too weak";
            case DETECTED -> "detected";
        };
    }

    /**
     * A fraction of cells, in percent: {@code 100.0} only for all of them, a dash for none.
     *
     * @param cells number of cells in the fraction
     * @param of number of all cells, above 0 unless {@code cells} is 0
     */
    public static String percent(int cells, int of) {
        double percent = 100.0 * cells / of;
        if (cells == 0) {
            return "-";
        }
        if (cells < of && percent >= MOST_ROUNDED) {
            return ">99.9";
        }
        return percent < LEAST_SHOWN ? "<0.1" : format("%.1f", percent);
    }

    private static String format(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
