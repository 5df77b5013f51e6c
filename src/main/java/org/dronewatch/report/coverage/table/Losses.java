package org.dronewatch.report.coverage.table;

import static org.dronewatch.report.html.ReadableNumbers.number;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.analysis.survey.FieldSummary;
import org.dronewatch.analysis.survey.HeightSummary;
import org.dronewatch.report.html.Html;

/** What is lost if a sensor fails, at which heights, and which sensors add nothing. */
public final class Losses {
    /** A height at which this fraction of the coverage is lost belongs to a lost band. */
    private static final double MOST_OF_IT = 0.5;

    /** A coverage of this fraction of the known area or less is too little to mention its loss. */
    private static final double HARDLY_ANY = 0.001;

    private static final String THIS = "this coverage";

    private final FieldSummary summary;
    private final List<HeightSummary> heights;
    private final List<String> sensors;

    /**
     * A figure for all heights together, shown beside the figures of single heights although it is based on other
     * headings of the drone.
     *
     * @param introduction sentences that explain this difference
     * @param coverage what the figures of single heights state, such as {@code the coverage of inbound flight}
     * @param head title of the column of this figure
     * @param all the figure with all sensors
     * @param without for each sensor, by its name, the figure with all sensors but this one
     */
    public record OtherFigure(
            String introduction, String coverage, String head, String all, Map<String, String> without) {
        /** Copies the map. */
        public OtherFigure {
            without = Map.copyOf(without);
        }
    }

    /** The losses of a coverage. */
    public Losses(FieldSummary summary) {
        this.summary = summary;
        this.heights = summary.heights();
        this.sensors = summary.coverage().field().sensors();
    }

    /** The section of a report: a table, and the heights at which the most coverage depends on one sensor. */
    public String html() {
        return html(Optional.empty());
    }

    /** The section as {@link #html()} returns it, with another figure in the first column if one is given. */
    public String html(Optional<OtherFigure> other) {
        StringBuilder html = new StringBuilder();
        html.append(Html.plain(
                "p",
                other.map(OtherFigure::introduction).orElse("")
                        + "The table states the coverage, in % of the known area at each height, with all sensors and"
                        + " without each one. If a sensor fails, a different heading of the drone may become the"
                        + " worst for the others."));
        html.append(table(other));
        List<String> bands = sensors.stream()
                .map(this::band)
                .flatMap(Optional::stream)
                .map(text -> Html.plain("li", text))
                .toList();
        if (!bands.isEmpty()) {
            html.append(Html.element("ul", String.join("", bands)));
        }
        return html.append(Html.plain("p", idle(other.map(OtherFigure::coverage).orElse(THIS))))
                .toString();
    }

    private String table(Optional<OtherFigure> other) {
        List<String> head = new ArrayList<>(List.of("sensors"));
        List<String> all = new ArrayList<>(List.of("all"));
        other.ifPresent(its -> {
            head.add(its.head());
            all.add(its.all());
        });
        for (HeightSummary height : heights) {
            head.add(metres(height));
            all.add(percent(height.covered(), height));
        }
        List<List<String>> rows = new ArrayList<>(List.of(all));
        for (String sensor : sensors) {
            List<String> row = new ArrayList<>(List.of("without " + sensor));
            other.ifPresent(its -> row.add(its.without().getOrDefault(sensor, "-")));
            for (HeightSummary height : heights) {
                int lost = height.lost().get(sensor);
                row.add(percent(height.covered() - lost, height)
                        + (height.changed().get(sensor) == 0 ? "" : difference(lost, height)));
            }
            rows.add(row);
        }
        return Html.table(head, rows);
    }

    private static String difference(int lost, HeightSummary height) {
        return lost == 0
                ? " (different cells)"
                : String.format(Locale.ROOT, " (%+.1f)", -100.0 * lost / height.known());
    }

    /** At which heights most of the coverage depends on a sensor; empty if at none. */
    private Optional<String> band(String sensor) {
        List<String> bands = new ArrayList<>();
        int start = -1;
        for (int i = 0; i <= heights.size(); i++) {
            boolean isLost = i < heights.size() && isLost(heights.get(i), sensor);
            if (isLost && start < 0) {
                start = i;
            } else if (!isLost && start >= 0) {
                bands.add(
                        start == i - 1
                                ? metres(heights.get(start))
                                : number(heights.get(start).height()) + " to " + metres(heights.get(i - 1)));
                start = -1;
            }
        }
        return bands.isEmpty()
                ? Optional.empty()
                : Optional.of("Without '" + sensor + "', at least half of the coverage is lost at "
                        + String.join(" and ", bands) + ".");
    }

    private static boolean isLost(HeightSummary height, String sensor) {
        return height.covered() > HARDLY_ANY * height.known()
                && height.lost().get(sensor) >= MOST_OF_IT * height.covered();
    }

    /**
     * The sensor whose failure loses the most coverage, in a sentence for the verdict; empty if no failure loses any.
     */
    public Optional<String> worstInWords() {
        String worst = "";
        HeightSummary where = null;
        double most = 0.0;
        for (String sensor : sensors) {
            for (HeightSummary height : heights) {
                double lost = height.known() == 0 ? 0.0 : (double) height.lost().get(sensor) / height.known();
                if (lost > most) {
                    most = lost;
                    worst = sensor;
                    where = height;
                }
            }
        }
        return where == null
                ? Optional.empty()
                : Optional.of(String.format(
                        Locale.ROOT,
                        "If one sensor fails, the loss is greatest without '%s': at %s, %s %% of the area remains"
                                + " covered instead of %s %%.",
                        worst,
                        metres(where),
                        percent(where.covered() - where.lost().get(worst), where),
                        percent(where.covered(), where)));
    }

    /** The sensors that add nothing, in sentences. */
    public String idle() {
        return idle(THIS);
    }

    private String idle(String coverage) {
        List<String> idle = summary.idleSensors();
        if (idle.isEmpty()) {
            return heights.stream().allMatch(height -> height.covered() == 0)
                    ? "Nothing is covered, so nothing can be lost."
                    : "No sensor can be left out without changing the coverage.";
        }
        String names = ("'" + String.join("', '", idle) + "'").replaceFirst(", ('[^']+')$", " and $1");
        return idle.size() == 1
                ? names
                        + " adds nothing to " + coverage
                        + ": without it, the same cells are covered at every height. It still"
                        + " serves as a backup if another sensor fails, and may confirm what others detect."
                : names + " each add nothing to " + coverage
                        + ": without any one of them, the same cells are covered at every height."
                        + " Without several of them, some cells may no longer be covered.";
    }

    private static String metres(HeightSummary height) {
        return number(height.height()) + " m";
    }

    private static String percent(int cells, HeightSummary height) {
        return height.known() == 0 ? "-" : cells == 0 ? "0" : CoverageTable.percent(cells, height.known());
    }
}
