package org.dronewatch.report.html.run;

import static org.dronewatch.report.html.ReadableNumbers.format;
import static org.dronewatch.report.html.ReadableNumbers.number;

import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.dronewatch.drone.ThreatLabel;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.run.AlertResult;
import org.dronewatch.run.PairResult;
import org.dronewatch.run.RunResult;
import org.dronewatch.setting.PlainText;

/** The result of one run in a few sentences for each drone and each swarm. */
final class Verdict {
    /** If there are more drones and swarms, only those without a timely alert are described. */
    private static final int MAX_GROUPS = 4;

    private final RunResult run;

    Verdict(RunResult run) {
        this.run = run;
    }

    String inWords() {
        List<DroneGroup> groups = DroneGroup.of(run.settings());
        if (groups.size() <= MAX_GROUPS) {
            return groups.stream().map(this::sentences).collect(Collectors.joining(" "));
        }
        List<DroneGroup> bad = groups.stream().filter(this::isBad).toList();
        String worst = bad.stream()
                .limit(MAX_GROUPS)
                .map(group -> " " + sentences(group))
                .collect(Collectors.joining());
        int more = bad.size() - MAX_GROUPS;
        return summary()
                + worst
                + (more > 0 ? format(" For %d more, the alert is also late or missing: see the table.", more) : "");
    }

    private boolean isBad(DroneGroup group) {
        return group.role() == ThreatLabel.Role.ATTACK
                && alerts(group).stream().anyMatch(alert -> alert.time().isEmpty() || RunRank.isLate(alert));
    }

    private List<AlertResult> alerts(DroneGroup group) {
        return run.alerts().stream()
                .filter(alert -> group.members().contains(alert.drone()))
                .toList();
    }

    /** For how many of many drones an alert is raised, and for how many in time. */
    private String summary() {
        List<AlertResult> alerts = run.alerts();
        long attackers = run.settings().individualDrones().values().stream()
                .filter(drone -> drone.label().role() == ThreatLabel.Role.ATTACK)
                .count();
        String role = attackers == alerts.size() ? "" : format(" (%d of them attacking)", attackers);
        return alerted(alerts, alerts.size() + " drones" + role);
    }

    /** {@code An alert is raised for 20 of 25 drones, in time for 18.} Or {@code for all 25 drones}. */
    private String alerted(List<AlertResult> alerts, String of) {
        long alerted = alerts.stream().filter(alert -> alert.time().isPresent()).count();
        if (alerted == 0) {
            return "No alert is raised for any of " + (isCounted(of) ? "the " : "") + of + ".";
        }
        String joint = alerted == alerts.size() && isCounted(of) ? " " : " of ";
        String all = "An alert is raised for " + count(alerted, alerts.size()) + joint + of;
        if (alerts.stream().noneMatch(alert -> alert.inTime().isPresent())) {
            return all + ".";
        }
        long inTime =
                alerts.stream().filter(alert -> alert.inTime().orElse(false)).count();
        return all + format(", in time for %s %s.", count(inTime, alerts.size()), required());
    }

    private static boolean isCounted(String drones) {
        return Character.isDigit(drones.charAt(0));
    }

    private static String count(long count, int of) {
        return count == 0 ? "none" : count == of ? "all" : Long.toString(count);
    }

    private String required() {
        return format("(the response takes %s s)", number(run.settings().alert().response()));
    }

    private String sentences(DroneGroup group) {
        // A swarm of one drone is described like a drone.
        boolean isSwarm = group.members().size() > 1;
        String detected = isSwarm ? ofSwarm(group) : ofDrone(group.members().get(0));
        if (run.settings().alert().equals(AlertSettings.DEFAULT)) {
            return detected;
        }
        List<AlertResult> alerts = alerts(group);
        if (!isSwarm) {
            return detected + " " + alerts.stream().map(this::alert).collect(Collectors.joining(" "));
        }
        AlertResult worst = alerts.stream().min(RunRank.WORST_ALERT_FIRST).orElseThrow();
        String which = worst.time().isEmpty()
                ? ""
                : " The worst case is '" + worst.drone() + "': " + uncapitalised(alert(worst));
        return detected + " " + alerted(alerts, "the swarm's " + alerts.size() + " drones") + which;
    }

    private static String uncapitalised(String sentence) {
        return sentence.substring(0, 1).toLowerCase(Locale.ROOT) + sentence.substring(1);
    }

    private Optional<PairResult> first(DroneGroup group) {
        return run.pairs().stream()
                .filter(pair -> group.members().contains(pair.drone())
                        && pair.firstDetected().isPresent())
                .min(Comparator.comparingDouble(pair -> pair.firstDetected().getAsDouble()));
    }

    /** How many drones of a swarm are detected, which first, at what range and when. */
    private String ofSwarm(DroneGroup swarm) {
        int all = swarm.members().size();
        long detected = run.pairs().stream()
                .filter(pair -> swarm.members().contains(pair.drone())
                        && pair.firstDetected().isPresent())
                .map(PairResult::drone)
                .distinct()
                .count();
        return first(swarm)
                .map(pair -> format(
                        "%s drones of swarm '%s' %s detected; the first is '%s', detected %s.",
                        detected == all ? "All " + all : detected + " of the " + all,
                        swarm.name(),
                        detected == 1 ? "is" : "are",
                        pair.drone(),
                        where(pair)))
                .orElseGet(() -> format("None of the %d drones of swarm '%s' is detected.", all, swarm.name()));
    }

    /** Which sensor detects a drone first, at what range and when. */
    private String ofDrone(String drone) {
        List<PairResult> pairs =
                run.pairs().stream().filter(pair -> pair.drone().equals(drone)).toList();
        long missing =
                pairs.stream().filter(pair -> pair.firstDetected().isEmpty()).count();
        String others = missing == 0
                ? "all sensors detect it"
                : missing + " of " + pairs.size() + " sensors never " + (missing == 1 ? "detects it" : "detect it");
        return first(new DroneGroup(drone, false, List.of(drone), ThreatLabel.Role.ATTACK))
                .map(pair -> "'" + drone + "' is first detected " + where(pair)
                        + (pairs.size() == 1 ? "." : "; " + others + "."))
                .orElse("'" + drone + "' is not detected by any sensor.");
    }

    private static String where(PairResult pair) {
        return format(
                "by '%s' (%s) at a range of %s m, %s s after the start",
                pair.sensor(),
                pair.kind(),
                number(pair.range().orElseThrow()),
                number(pair.firstDetected().getAsDouble()));
    }

    /** When the alert is raised, and how much warning time it gives. */
    private String alert(AlertResult alert) {
        if (alert.time().isEmpty()) {
            return "No alert is raised.";
        }
        String when = format(
                "The alert is raised by %s %s s after the start",
                PlainText.list(alert.sensors().stream()
                        .map(sensor -> "'" + sensor + "'")
                        .toList()),
                number(alert.time().getAsDouble()));
        if (alert.warning().isEmpty()) {
            return when + ".";
        }
        String left = format(
                ", when the drone is %s m (%s s of flight) from the protected zone",
                number(alert.zoneDistance().getAsDouble()),
                number(alert.warning().getAsDouble()));
        return when
                + left
                + alert.inTime()
                        .map(enough -> format(": %s %s.", enough ? "in time" : "too late", required()))
                        .orElse(".");
    }
}
