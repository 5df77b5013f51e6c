package org.dronewatch.report.coverage.table;

import static org.dronewatch.report.html.ReadableNumbers.number;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.survey.FieldSummary;
import org.dronewatch.analysis.survey.Gap;
import org.dronewatch.analysis.survey.GapEvidence;
import org.dronewatch.analysis.survey.GapMap;
import org.dronewatch.analysis.survey.GapSpan;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.report.html.Html;
import org.dronewatch.sensor.Cause;
import org.dronewatch.setting.Counted;

/** The largest gaps, the worst first: where each begins, how large it is, and why it is there. */
public final class WorstPlaces {
    /** The greatest number of gaps that are described. */
    private static final int MOST_GAPS = 6;

    /** The greatest number of rows for sensors that are explained for each gap, those nearest to a detection. */
    private static final int MOST_ROWS = 8;

    private final FieldSummary summary;
    private final CoverageSite site;
    private final ReferencePoint reference;

    /** The gaps of more than a single cell, if there are any, the largest first. */
    private final List<GapSpan> gaps;

    private final int all;

    public WorstPlaces(FieldSummary summary, CoverageSite site, ReferencePoint reference) {
        this.summary = summary;
        this.site = site;
        this.reference = reference;
        List<GapSpan> all = GapSpan.of(summary.coverage());
        List<GapSpan> several =
                all.stream().filter(span -> span.gap().cells() > 1).toList();
        this.gaps = several.isEmpty() ? all : several;
        this.all = all.size();
    }

    /**
     * The section; cells of its gaps are assessed anew, on the {@link org.dronewatch.parallel.Workers} of the calling
     * thread.
     */
    public String html() {
        if (gaps.isEmpty()) {
            return Html.plain("p", "At each of these heights, the drone is detected everywhere" + known() + ".");
        }
        List<GapSpan> shown = gaps.subList(0, Math.min(MOST_GAPS, gaps.size()));
        StringBuilder html = new StringBuilder();
        for (int i = 0; i < shown.size(); i++) {
            html.append(describe(i + 1, shown.get(i)));
        }
        if (all > shown.size()) {
            html.append(Html.plain("p", "Smaller gaps are shown on the maps."));
        }
        html.append(Html.plain(
                "p",
                "Signals and obstacles are stated for the height at which a gap is largest. For radars, radio receivers"
                        + " and microphones, the strongest and the weakest signal are taken from all cells of the gap"
                        + " whose signal was computed, not merely bounded; other signals, and the obstacles, are taken"
                        + " from up to " + GapEvidence.MOST_SPREAD
                        + " cells for each sensor and cause, spread evenly over the gap."));
        return html.toString();
    }

    /** The largest gap of all, for the verdict. */
    public String worstInWords() {
        if (gaps.isEmpty()) {
            return "There is no gap in the coverage" + known() + " at these heights.";
        }
        GapSpan worst = gaps.get(0);
        return "The largest gap, at " + heights(worst) + ", has an area of " + size(worst) + ". It "
                + where(GapMap.of(summary.coverage(), worst.height()), worst) + ". The main reason there: "
                + cause(worst.gap().cause()) + ".";
    }

    private String describe(int rank, GapSpan span) {
        GapMap map = GapMap.of(summary.coverage(), span.height());
        List<GapEvidence> evidence = GapEvidence.of(map, span.number(), site.stage());
        return Html.plain(
                        "h3",
                        rank + ". At " + heights(span) + ": "
                                + inWords(span.gap().area()))
                + Html.plain(
                        "p",
                        "A gap of " + size(span) + (span.lowest() == span.highest() ? " " : ", ")
                                + where(map, span) + ". Its innermost point is at "
                                + reference.coordinates(
                                        span.gap().x(), span.gap().y()) + ". "
                                + why(span.gap(), evidence))
                + Html.table(
                        List.of("sensor", "why it does not detect the drone at " + height(span.height()) + " m"),
                        rows(evidence));
    }

    private String known() {
        return summary.isAllKnown() ? "" : " in the known area";
    }

    /** {@code 10 m above the ground}, or {@code 10 to 60 m above the ground}. */
    private String heights(GapSpan span) {
        String to = height(span.highest()) + " m above the ground";
        return span.lowest() == span.highest() ? to : height(span.lowest()) + " to " + to;
    }

    private String height(int height) {
        return number(summary.heights().get(height).height());
    }

    /** {@code 4.2 ha (12 % of the known area) at 30 m, where it is largest}. */
    private String size(GapSpan span) {
        String share = CoverageTable.percent(
                span.gap().cells(), summary.heights().get(span.height()).known());
        String where =
                span.lowest() == span.highest() ? "" : " at " + height(span.height()) + " m, where it is largest";
        return inWords(span.gap().area()) + " (" + share + " % of the known area)" + where;
    }

    private String where(GapMap map, GapSpan span) {
        FieldGrid grid = summary.coverage().field().grid();
        int nearest = reference.nearestCell(map, span.number());
        double x = grid.x(grid.column(nearest));
        double y = grid.y(grid.row(nearest));
        String begins = reference.distance(x, y) <= grid.cell()
                ? "includes " + reference.name()
                : "begins " + reference.describe(x, y);
        return begins
                + (span.gap().touchesRim()
                        ? " and reaches the edge of the area, beyond which it may continue"
                        : " and does not reach the edge of the area");
    }

    private String why(Gap gap, List<GapEvidence> evidence) {
        List<Map.Entry<Cause, Integer>> causes = new ArrayList<>(gap.causes().entrySet());
        causes.sort(Map.Entry.comparingByValue(Comparator.reverseOrder()));
        return (causes.size() == 1 ? "Cause of the gap: " : "Causes of the gap: ")
                + causes.stream()
                        .map(one -> cause(one.getKey())
                                + names(one.getKey(), evidence)
                                + (causes.size() == 1
                                        ? ""
                                        : " in " + MissWords.percent(one.getValue(), gap.cells()) + " of the cells"))
                        .collect(Collectors.joining(", "))
                + " (for the sensor that comes nearest to detecting the drone).";
    }

    private static String cause(Cause cause) {
        return cause == Cause.DETECTED ? CoverageTable.TOO_RARELY : CoverageTable.name(cause);
    }

    /** What hides the drone from any sensor, if that is the cause. */
    private static String names(Cause cause, List<GapEvidence> evidence) {
        List<GapEvidence.Examined> all =
                evidence.stream().flatMap(one -> one.examined().stream()).toList();
        String names = MissWords.blockers(all, cause);
        return names.isEmpty() ? "" : " (" + names + ")";
    }

    /** A row for each sensor; sensors with the same reasons share a row. */
    private List<List<String>> rows(List<GapEvidence> evidence) {
        List<GapEvidence> sorted = new ArrayList<>(evidence);
        sorted.sort(Comparator.comparingInt(WorstPlaces::nearestCause)
                .thenComparingDouble(one -> words(one).bestMargin())
                .reversed());
        Map<String, List<String>> sensors = new LinkedHashMap<>();
        sorted.forEach(one -> sensors.computeIfAbsent(words(one).inWords(), words -> new ArrayList<>())
                .add(one.sensor()));
        List<List<String>> rows = new ArrayList<>();
        int others = 0;
        for (Map.Entry<String, List<String>> one : sensors.entrySet()) {
            if (rows.size() < MOST_ROWS) {
                rows.add(List.of(String.join(", ", one.getValue()), one.getKey()));
            } else {
                others += one.getValue().size();
            }
        }
        if (others > 0) {
            rows.add(List.of(Counted.of(others, "other"), "not shown: even farther from detecting the drone"));
        }
        return rows;
    }

    private MissWords words(GapEvidence evidence) {
        return new MissWords(evidence, site.settings().enabledSensors().get(evidence.sensor()));
    }

    /** The number of the cause that is nearest to a detection. */
    private static int nearestCause(GapEvidence evidence) {
        return evidence.causes().keySet().stream()
                .mapToInt(Cause::ordinal)
                .max()
                .orElse(0);
    }

    static String inWords(double area) {
        return area < 1e5 ? Numbers.area(area) : String.format(Locale.ROOT, "%.1f ha", 1e-4 * area);
    }
}
