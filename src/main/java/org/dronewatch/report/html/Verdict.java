package org.dronewatch.report.html;

import static org.dronewatch.report.html.Numbers.format;
import static org.dronewatch.report.html.Numbers.number;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.scene.AlertResult;
import org.dronewatch.scene.PairResult;
import org.dronewatch.scene.RunResult;
import org.dronewatch.world.ThreatLabel;

/** What a run comes to, a few sentences for each drone. */
final class Verdict {
    /** Of more drones than these each only those are told of to which there is no alert in time. */
    private static final int MOST_DRONES = 4;

    private final RunResult run;

    Verdict(RunResult run) {
        this.run = run;
    }

    String inWords() {
        List<AlertResult> alerts = run.alerts();
        if (alerts.size() <= MOST_DRONES) {
            return alerts.stream().map(this::sentences).collect(Collectors.joining(" "));
        }
        List<AlertResult> bad = alerts.stream().filter(this::isBad).toList();
        String all = summary(alerts);
        if (bad.isEmpty()) {
            return all;
        }
        String worst = bad.stream().limit(MOST_DRONES).map(this::sentences).collect(Collectors.joining(" "));
        int more = bad.size() - MOST_DRONES;
        return all + " " + worst + (more > 0 ? " The table tells of " + more + " more like these." : "");
    }

    /** An attack to which there is no alert, or none in time. */
    private boolean isBad(AlertResult alert) {
        boolean late = alert.inTime().filter(enough -> !enough).isPresent();
        return role(alert) == ThreatLabel.Role.ATTACK && (alert.time().isEmpty() || late);
    }

    private String sentences(AlertResult alert) {
        return run.settings().alert().equals(AlertSettings.DEFAULT)
                ? detection(alert.drone())
                : detection(alert.drone()) + " " + alert(alert);
    }

    /** How many of many drones there was an alert to, and whether in time. */
    private String summary(List<AlertResult> alerts) {
        long alerted = alerts.stream().filter(alert -> alert.time().isPresent()).count();
        String attackers = alerts.stream().allMatch(alert -> role(alert) == ThreatLabel.Role.ATTACK)
                ? ""
                : format(
                        " (%d of them attack)",
                        alerts.stream()
                                .filter(alert -> role(alert) == ThreatLabel.Role.ATTACK)
                                .count());
        String all = format(
                "Of %d drones%s there is an alert to %s", alerts.size(), attackers, share(alerted, alerts.size()));
        if (alerts.stream().noneMatch(alert -> alert.inTime().isPresent())) {
            return all + ".";
        }
        long inTime =
                alerts.stream().filter(alert -> alert.inTime().orElse(false)).count();
        return all
                + format(
                        "; to %s it comes in time, %s s before they can be at what is protected.",
                        share(inTime, alerts.size()),
                        number(run.settings().alert().response()));
    }

    private ThreatLabel.Role role(AlertResult alert) {
        return run.settings().fliers().get(alert.drone()).label().role();
    }

    private static String share(long count, int of) {
        return count == of ? "all" : count == 0 ? "none" : Long.toString(count);
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
                                : missing + " of " + pairs.size() + " sensors never "
                                        + (missing == 1 ? "detects it" : "detect it")))
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
