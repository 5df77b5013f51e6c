package org.dronewatch.report.html;

import static org.dronewatch.report.html.Numbers.format;
import static org.dronewatch.report.html.Numbers.number;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.scene.AlertResult;
import org.dronewatch.scene.PairResult;
import org.dronewatch.scene.RunResult;

/** What a run comes to, a few sentences for each drone. */
final class Verdict {
    /** Of more drones than these, as in a large swarm, only the tables tell. */
    private static final int MOST_SENTENCES = 20;

    private final RunResult run;

    Verdict(RunResult run) {
        this.run = run;
    }

    String inWords() {
        List<String> sentences = new ArrayList<>();
        List<AlertResult> alerts = run.alerts();
        for (AlertResult alert : alerts.subList(0, Math.min(alerts.size(), MOST_SENTENCES))) {
            sentences.add(detection(alert.drone()));
            if (!run.settings().alert().equals(AlertSettings.DEFAULT)) {
                sentences.add(alert(alert));
            }
        }
        if (alerts.size() > MOST_SENTENCES) {
            sentences.add("The table tells of " + (alerts.size() - MOST_SENTENCES) + " more drones.");
        }
        return String.join(" ", sentences);
    }

    /** Who detects a drone first, how far away, how early. */
    private String detection(String drone) {
        List<PairResult> pairs =
                run.pairs().stream().filter(pair -> pair.drone().equals(drone)).toList();
        Optional<PairResult> first = pairs.stream()
                .filter(pair -> pair.firstDetected().isPresent())
                .min(Comparator.comparingDouble(pair -> pair.firstDetected().getAsDouble()));
        long missing =
                pairs.stream().filter(pair -> pair.firstDetected().isEmpty()).count();
        return first.map(pair -> format(
                        "'%s' is first detected by '%s' (%s), %s m away, %s s after the start; %s.",
                        drone,
                        pair.sensor(),
                        pair.kind(),
                        number(pair.range().orElseThrow()),
                        number(pair.firstDetected().getAsDouble()),
                        missing == 0
                                ? "all sensors detect it"
                                : missing + " of " + pairs.size() + " sensors never detect it"))
                .orElse("'" + drone + "' is not detected by any sensor.");
    }

    /** When the alert comes, and what time it leaves. */
    private String alert(AlertResult alert) {
        double needed = run.settings().alert().response();
        if (alert.time().isEmpty()) {
            return "There is no alert.";
        }
        String when =
                format("The alert comes after %s s, by %s", number(alert.time().getAsDouble()), names(alert.sensors()));
        if (alert.warning().isEmpty()) {
            return when + ".";
        }
        String left = format(
                ", %s m and %s s of flight before what is protected",
                number(alert.zoneDistance().getAsDouble()),
                number(alert.warning().getAsDouble()));
        return when
                + left
                + alert.inTime()
                        .map(enough ->
                                format("; %s s are needed: %s.", number(needed), enough ? "in time" : "too late"))
                        .orElse(".");
    }

    private static String names(List<String> sensors) {
        return "'" + String.join("', '", sensors) + "'";
    }
}
