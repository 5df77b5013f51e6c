package org.dronewatch.report.html.run;

import static org.dronewatch.report.html.ReadableNumbers.format;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.report.html.Html;
import org.dronewatch.report.html.ReadableNumbers;
import org.dronewatch.run.DetectionIntervals;
import org.dronewatch.run.PairResult;
import org.dronewatch.run.RunResult;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.SensorSettings;

/**
 * The drones that sensors of a run never detected, did not detect for part of the time, or lost and did not regain, and
 * why: a row for each sensor with each drone or swarm.
 */
final class Misses {
    /** In a larger swarm, reasons are determined for this number of drones, evenly spaced in the list. */
    private static final int MAX_MEMBERS = 20;

    private final RunResult run;
    private final RunLooks looks;
    private final Reasons reasons;
    private final List<DroneGroup> groups;
    private final DetectionIntervals intervals;

    Misses(RunResult run, RunLooks looks, Reasons reasons) {
        this.run = run;
        this.looks = looks;
        this.reasons = reasons;
        this.groups = DroneGroup.of(run.settings());
        this.intervals = DetectionIntervals.of(run.events());
    }

    String tables() {
        String never = never();
        String partly = partly();
        if (never.isEmpty() && partly.isEmpty()) {
            return Html.plain("p", "None: every sensor detects every drone for at least 99 % of the time.") + lost();
        }
        String words = never.isEmpty()
                ? "Every sensor detects every drone at some time. The table states for how much of the run it does not,"
                        + " and why."
                : "Where a sensor detects a drone at some time, this table states for how much of the run it does not,"
                        + " and why.";
        return never + (partly.isEmpty() ? "" : Html.plain("p", words) + partly) + lost();
    }

    private String never() {
        List<List<String>> rows = new ArrayList<>();
        int left = 0;
        for (Map.Entry<String, List<String>> sensor : drones(false).entrySet()) {
            for (DroneGroup group : groups) {
                List<String> members = members(group, sensor.getValue());
                if (members.isEmpty()) {
                    continue;
                }
                if (rows.size() < DetectionTables.MAX_ROWS) {
                    rows.add(row(sensor.getKey(), group, members, why(sensor.getKey(), members)));
                } else {
                    left++;
                }
            }
        }
        return rows.isEmpty()
                ? ""
                : Html.table(List.of("sensor", "kind", "drone", "reason"), rows) + DetectionTables.notShown(left);
    }

    /** Sensors that detect a drone at some time, but not all the time. */
    private String partly() {
        List<List<String>> rows = new ArrayList<>();
        int left = 0;
        for (Map.Entry<String, List<String>> sensor : drones(true).entrySet()) {
            for (DroneGroup group : groups) {
                List<String> members = members(group, sensor.getValue());
                if (members.isEmpty()) {
                    continue;
                }
                if (rows.size() == DetectionTables.MAX_ROWS) {
                    left++;
                    continue;
                }
                reasons.whileUndetected(sensor.getKey(), some(members), intervals)
                        .ifPresent(missed -> {
                            List<String> row = new ArrayList<>(row(sensor.getKey(), group, members, missed.reason()));
                            row.add(3, missed.part());
                            rows.add(row);
                        });
            }
        }
        return rows.isEmpty()
                ? ""
                : Html.table(List.of("sensor", "kind", "drone", "time without detection", "reason"), rows)
                        + DetectionTables.notShown(left);
    }

    /** By sensor, the drones that it detects at some time, or those that it never does. */
    private Map<String, List<String>> drones(boolean isDetected) {
        Map<String, List<String>> drones = new LinkedHashMap<>();
        for (PairResult pair : run.pairs()) {
            if (pair.firstDetected().isPresent() == isDetected) {
                drones.computeIfAbsent(pair.sensor(), name -> new ArrayList<>()).add(pair.drone());
            }
        }
        return drones;
    }

    private static List<String> members(DroneGroup group, List<String> drones) {
        return group.members().stream().filter(drones::contains).toList();
    }

    private String why(String sensor, List<String> members) {
        Optional<BestLook> best = members.stream()
                .flatMap(drone -> looks.best(sensor, drone).stream())
                .max(Comparator.comparingDouble(BestLook::margin));
        return reasons.of(sensor, some(members), best);
    }

    /** Sensors that lost a drone for the rest of the run. */
    private String lost() {
        List<List<String>> rows = new ArrayList<>();
        int left = 0;
        for (String sensor : run.settings().enabledSensors().keySet()) {
            for (DroneGroup group : groups) {
                List<Observation> of = group.members().stream()
                        .flatMap(drone -> intervals.lostForGood(sensor, drone).stream())
                        .toList();
                if (of.isEmpty()) {
                    continue;
                }
                if (rows.size() < DetectionTables.MAX_ROWS) {
                    rows.add(lostRow(sensor, group, of));
                } else {
                    left++;
                }
            }
        }
        return rows.isEmpty()
                ? ""
                : Html.table(
                                List.of(
                                        "sensor",
                                        "kind",
                                        "drone",
                                        "lost at [s]",
                                        "range at loss [m]",
                                        "reason after loss"),
                                rows)
                        + DetectionTables.notShown(left);
    }

    private List<String> lostRow(String sensor, DroneGroup group, List<Observation> lost) {
        List<String> members = lost.stream().map(Observation::drone).toList();
        double last = lost.stream().mapToDouble(Observation::arrival).max().orElseThrow();
        List<String> row = new ArrayList<>(row(sensor, group, members, reasons.afterLoss(sensor, some(members), last)));
        row.add(3, ReadableNumbers.range(lost.stream().mapToDouble(Observation::arrival)));
        row.add(4, ReadableNumbers.range(lost.stream().mapToDouble(Observation::range)));
        return row;
    }

    private List<String> row(String sensor, DroneGroup group, List<String> members, String why) {
        SensorSettings<?> settings = run.settings().sensors().get(sensor);
        String which = group.isSwarm() && members.size() < group.members().size()
                ? format(
                        "%s: %d of %d drones",
                        group.name(), members.size(), group.members().size())
                : group.label();
        return List.of(sensor, settings.kind(), which, why);
    }

    private static List<String> some(List<String> members) {
        if (members.size() <= MAX_MEMBERS) {
            return members;
        }
        List<String> some = new ArrayList<>();
        for (int i = 0; i < MAX_MEMBERS; i++) {
            some.add(members.get(i * (members.size() - 1) / (MAX_MEMBERS - 1)));
        }
        return some;
    }
}
