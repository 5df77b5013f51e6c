package org.dronewatch.report.html;

import static org.dronewatch.report.html.Numbers.format;
import static org.dronewatch.report.html.Numbers.orElse;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.dronewatch.scene.AlertResult;
import org.dronewatch.scene.DetectionEvent;
import org.dronewatch.scene.PairResult;
import org.dronewatch.scene.RunResult;
import org.dronewatch.scene.SceneResult;
import org.dronewatch.scene.SceneSettings;
import org.dronewatch.scene.Sightline;
import org.dronewatch.world.DroneSettings;
import org.dronewatch.world.ThreatLabel;

/** Who detects what, and how early the site is alerted: all runs in tables. */
final class ResultTables {
    /** A table of more rows is no help. */
    static final int MOST_ROWS = 60;

    private final SceneResult result;
    private final Looks looks;
    private final boolean sweeps;

    ResultTables(SceneResult result, Looks looks) {
        this.result = result;
        this.looks = looks;
        this.sweeps = result.runs().size() > 1;
    }

    /** A row for each sensor with each drone; where these are very many, for those that were detected. */
    String detections() {
        List<String> head = head(
                "sensor",
                "kind",
                "drone",
                "first detected [s]",
                "at [m]",
                "last [s]",
                "farthest [m]",
                "looks that detect");
        List<PairResult> pairs = result.pairs();
        String note = "";
        if (pairs.size() > MOST_ROWS) {
            pairs = pairs.stream()
                    .filter(pair -> pair.firstDetected().isPresent())
                    .toList();
            int others = result.pairs().size() - pairs.size();
            note = Html.plain("p", "Without the " + others + " pairs of sensor and drone that came to no detection.");
        }
        List<List<String>> rows = new ArrayList<>();
        for (PairResult pair : pairs) {
            rows.add(row(
                    pair.run(),
                    pair.sensor(),
                    pair.kind(),
                    pair.drone(),
                    orElse(pair.firstDetected(), "never"),
                    orElse(pair.range(), "-"),
                    last(pair),
                    orElse(pair.maxRange(), "-"),
                    format("%.0f %%", 100.0 * looks.share(pair.run(), pair.sensor(), pair.drone()))));
        }
        return note + Html.table(head, rows);
    }

    /** A row for each drone. */
    String alerts() {
        boolean zone = result.runs().stream()
                .anyMatch(run -> run.settings().alert().protect().isPresent());
        List<String> head = head("drone", "in sight from [s]", "alert [s]", "later by [s]", "by");
        if (zone) {
            head.addAll(List.of("then to go [m]", "warning [s]", "reaches zone [s]", "in time"));
        }
        List<List<String>> rows = new ArrayList<>();
        for (AlertResult alert : result.alerts()) {
            List<String> row = row(
                    alert.run(),
                    labelled(alert),
                    orElse(alert.firstSight(), looks(alert.run()) ? "never" : "-"),
                    orElse(alert.time(), "never"),
                    orElse(alert.timeToAlert(), "-"),
                    alert.sensors().isEmpty() ? "-" : String.join(", ", alert.sensors()));
            if (zone) {
                row.addAll(List.of(
                        orElse(alert.zoneDistance(), "-"),
                        orElse(alert.warning(), "none"),
                        orElse(alert.entered(), "not in this run"),
                        alert.inTime().map(enough -> enough ? "yes" : "NO").orElse("not asked")));
            }
            rows.add(row);
        }
        return Html.table(head, rows);
    }

    /** Whether any sensor of a run has a field of view. */
    private boolean looks(int run) {
        return result.runs().get(run).settings().sensors().values().stream().anyMatch(Sightline::looks);
    }

    /** A drone's name; with a word when an alert to it is no success. */
    private String labelled(AlertResult alert) {
        Map<String, DroneSettings> fliers =
                result.runs().get(alert.run()).settings().fliers();
        ThreatLabel.Role role = fliers.get(alert.drone()).label().role();
        return switch (role) {
            case ATTACK -> alert.drone();
            case DECOY -> alert.drone() + " (decoy)";
            case BYSTANDER -> alert.drone() + " (bystander)";
        };
    }

    private List<String> head(String... names) {
        List<String> head = new ArrayList<>(List.of(names));
        if (sweeps) {
            head.add(0, "run");
        }
        return head;
    }

    private List<String> row(int run, String... cells) {
        List<String> row = new ArrayList<>(List.of(cells));
        if (sweeps) {
            row.add(0, withSwept(run));
        }
        return row;
    }

    /** Until when a sensor detects a drone: when it loses it for the last time. */
    private String last(PairResult pair) {
        RunResult run = result.runs().get(pair.run());
        String last = "-";
        for (DetectionEvent event : run.events()) {
            if (event.observation().sensor().equals(pair.sensor())
                    && event.observation().drone().equals(pair.drone())) {
                last = event.gained()
                        ? "to the end"
                        : format("%.1f", event.observation().arrival());
            }
        }
        return last;
    }

    private String withSwept(int run) {
        SceneSettings settings = result.runs().get(run).settings();
        return run
                + settings.sweep()
                        .map(sweep -> ": "
                                + sweep.parameter().substring(sweep.parameter().lastIndexOf('.') + 1) + " "
                                + shortNumber(sweep.valueIn(settings)))
                        .orElse("");
    }

    private static String shortNumber(Object value) {
        return value instanceof Double number ? format("%.4g", number) : value.toString();
    }
}
