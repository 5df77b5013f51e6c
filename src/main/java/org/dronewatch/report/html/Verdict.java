package org.dronewatch.report.html;

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

/** What one run comes to: a few sentences for each drone and each swarm. */
final class Verdict {
    /** Of more drones and swarms only those are described to which there is no alert in time. */
    private static final int MOST_GROUPS = 4;

    private final RunResult run;

    Verdict(RunResult run) {
        this.run = run;
    }

    String inWords() {
        List<DroneGroup> groups = DroneGroup.of(run.settings());
        if (groups.size() <= MOST_GROUPS) {
            return groups.stream().map(this::sentences).collect(Collectors.joining(" "));
        }
        List<DroneGroup> bad = groups.stream().filter(this::isBad).toList();
        String worst = bad.stream()
                .limit(MOST_GROUPS)
                .map(group -> " " + sentences(group))
                .collect(Collectors.joining());
        int more = bad.size() - MOST_GROUPS;
        return summary() + worst + (more > 0 ? " " + more + " more fared like these: see the table." : "");
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

    /** How many of many drones there was an alert to, and whether in time. */
    private String summary() {
        List<AlertResult> alerts = run.alerts();
        long attackers = run.settings().fliers().values().stream()
                .filter(drone -> drone.label().role() == ThreatLabel.Role.ATTACK)
                .count();
        String role = attackers == alerts.size() ? "" : format(" (%d of them attacking)", attackers);
        return alerted(alerts, alerts.size() + " drones" + role);
    }

    /** {@code There is an alert for 20 of 25 drones, in time for 18.} Or {@code for all 25 drones}. */
    private String alerted(List<AlertResult> alerts, String of) {
        long alerted = alerts.stream().filter(alert -> alert.time().isPresent()).count();
        boolean unnamed = alerted == alerts.size() && Character.isDigit(of.charAt(0));
        String all = "There is an alert for " + count(alerted, alerts.size()) + (unnamed ? " " : " of ") + of;
        if (alerts.stream().noneMatch(alert -> alert.inTime().isPresent())) {
            return all + ".";
        }
        long inTime =
                alerts.stream().filter(alert -> alert.inTime().orElse(false)).count();
        return all + format(", in time for %s; %s s are needed.", count(inTime, alerts.size()), response());
    }

    private static String count(long count, int of) {
        return count == 0 ? "none" : count == of ? "all" : Long.toString(count);
    }

    private String response() {
        return number(run.settings().alert().response());
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

    /** How many drones of a swarm are detected, which first, how far away, how early. */
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
                        "%s drones of swarm '%s' %s detected; the first is '%s', %s.",
                        detected == all ? "All " + all : detected + " of the " + all,
                        swarm.name(),
                        detected == 1 ? "is" : "are",
                        pair.drone(),
                        where(pair)))
                .orElseGet(() -> format("None of the %d drones of swarm '%s' is detected.", all, swarm.name()));
    }

    /** Who detects a drone first, how far away, how early. */
    private String ofDrone(String drone) {
        List<PairResult> pairs =
                run.pairs().stream().filter(pair -> pair.drone().equals(drone)).toList();
        long missing =
                pairs.stream().filter(pair -> pair.firstDetected().isEmpty()).count();
        String others = missing == 0
                ? "all sensors detect it"
                : missing + " of " + pairs.size() + " sensors never " + (missing == 1 ? "detects it" : "detect it");
        return first(new DroneGroup(drone, false, List.of(drone), ThreatLabel.Role.ATTACK))
                .map(pair -> "'" + drone + "' is first detected " + where(pair) + "; " + others + ".")
                .orElse("'" + drone + "' is not detected by any sensor.");
    }

    private static String where(PairResult pair) {
        return format(
                "by '%s' (%s), %s m away, %s s after the start",
                pair.sensor(),
                pair.kind(),
                number(pair.range().orElseThrow()),
                number(pair.firstDetected().getAsDouble()));
    }

    /** When the alert comes, and what time it leaves. */
    private String alert(AlertResult alert) {
        if (alert.time().isEmpty()) {
            return "There is no alert.";
        }
        String when = format(
                "The alert comes %s s after the start, from %s",
                number(alert.time().getAsDouble()), "'" + String.join("', '", alert.sensors()) + "'");
        if (alert.warning().isEmpty()) {
            return when + ".";
        }
        String left = format(
                ", when the drone is %s m and %s s of flight away from the protected zone",
                number(alert.zoneDistance().getAsDouble()),
                number(alert.warning().getAsDouble()));
        return when
                + left
                + alert.inTime()
                        .map(enough -> format("; %s s are needed: %s.", response(), enough ? "in time" : "too late"))
                        .orElse(".");
    }
}
