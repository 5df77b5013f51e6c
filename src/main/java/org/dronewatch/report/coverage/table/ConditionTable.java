package org.dronewatch.report.coverage.table;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dronewatch.analysis.survey.ConditionCoverage;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.scenario.SceneCondition;

/** Tables of a site's coverage under several conditions: a row for each height, a column for each condition. */
public final class ConditionTable {
    private static final int WIDTH = 10;

    private ConditionTable() {}

    /**
     * For each height and condition, the fractions of the known cells that are covered and lost, and the sensor that
     * covers the most cells.
     *
     * @param conditions the first is the scene as it is
     * @param covered the probability with which a sensor must detect the drone, 0.008 to 0.996, or 1
     */
    public static List<String> lines(List<ConditionCoverage> conditions, double covered) {
        List<String> lines = new ArrayList<>();
        lines.add("covered" + CoverageInputs.withProbability(covered)
                + " under each condition, in % of the known cells:");
        addRows(lines, conditions, height -> percent(height, height.summary().covered()));
        lines.add("");
        lines.add("covered in the scene as it is, but not under the condition, in % of the cells known in the scene"
                + " as it is:");
        addRows(lines, conditions.subList(1, conditions.size()), ConditionTable::lost);
        lines.add("");
        lines.add("sensor that covers most under each condition, and the percentage of the known cells that it"
                + " covers:");
        addRows(lines, conditions, ConditionTable::best);
        lines.add("");
        conditions.subList(1, conditions.size()).forEach(one -> lines.add(words(conditions.get(0), one)));
        return lines;
    }

    /** The text of a cell. */
    private interface Text {
        String of(ConditionCoverage.Height height);
    }

    private static void addRows(List<String> lines, List<ConditionCoverage> conditions, Text text) {
        int[] widths = conditions.stream()
                .mapToInt(one -> one.heights().stream()
                        .mapToInt(height -> text.of(height).length())
                        .reduce(Math.max(WIDTH, name(one).length()), Math::max))
                .toArray();
        StringBuilder header = new StringBuilder(String.format(Locale.ROOT, "%10s", "height"));
        for (int i = 0; i < widths.length; i++) {
            header.append("  ").append(padded(name(conditions.get(i)), widths[i]));
        }
        lines.add(header.toString());
        for (int height = 0; height < conditions.get(0).heights().size(); height++) {
            StringBuilder row = new StringBuilder(String.format(
                    Locale.ROOT,
                    "%10s",
                    Numbers.text(conditions
                                    .get(0)
                                    .heights()
                                    .get(height)
                                    .summary()
                                    .height()) + " m"));
            for (int i = 0; i < widths.length; i++) {
                row.append("  ")
                        .append(padded(text.of(conditions.get(i).heights().get(height)), widths[i]));
            }
            lines.add(row.toString());
        }
    }

    private static String padded(String text, int width) {
        return " ".repeat(width - text.length()) + text;
    }

    /** The name of a condition, or the words for the scene as it is. */
    public static String name(ConditionCoverage condition) {
        return condition.name().isEmpty() ? SceneCondition.AS_IT_IS : condition.name();
    }

    /**
     * The sensor that covers the most cells under a condition, with their fraction of the known cells, in percent;
     * {@code none} if no sensor covers any.
     */
    public static String best(ConditionCoverage.Height height) {
        return height.best()
                .map(sensor -> sensor + " " + percent(height, height.bySensor().get(sensor)))
                .orElse("none");
    }

    /**
     * The cells that are covered in the scene as it is but not under the condition, in percent of the cells known in
     * the scene as it is; a dash if none is known.
     */
    public static String lost(ConditionCoverage.Height height) {
        return height.knownAsItIs() == 0 ? "-" : CoverageTable.percent(height.lost(), height.knownAsItIs());
    }

    /** A number of cells in percent of the cells known under a condition; a dash if none is known. */
    public static String percent(ConditionCoverage.Height height, int cells) {
        return height.summary().known() == 0
                ? "-"
                : CoverageTable.percent(cells, height.summary().known());
    }

    /** The bands of heights in which at least half of the coverage is lost under a condition. */
    public static String words(ConditionCoverage asItIs, ConditionCoverage condition) {
        List<String> bands = new ArrayList<>();
        int first = -1;
        for (int height = 0; height <= condition.heights().size(); height++) {
            boolean isLost = height < condition.heights().size()
                    && asItIs.heights().get(height).summary().covered() > 0
                    && 2 * condition.heights().get(height).lost()
                            >= asItIs.heights().get(height).summary().covered();
            if (isLost && first < 0) {
                first = height;
            } else if (!isLost && first >= 0) {
                bands.add(band(condition, first, height - 1));
                first = -1;
            }
        }
        if (asItIs.heights().stream().allMatch(height -> height.summary().covered() == 0)) {
            return condition.name() + ": nothing is covered in the scene as it is, so nothing can be lost";
        }
        return condition.name() + ": "
                + (bands.isEmpty()
                        ? "at each height, more than half of the coverage remains"
                        : "half of the coverage or more is lost at " + String.join(" and ", bands));
    }

    private static String band(ConditionCoverage condition, int first, int last) {
        String from = Numbers.text(condition.heights().get(first).summary().height());
        String to = Numbers.text(condition.heights().get(last).summary().height());
        return (first == last ? "" : from + " to ") + to + " m";
    }
}
