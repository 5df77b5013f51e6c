package org.dronewatch.report.html.run;

import static org.dronewatch.report.html.ReadableNumbers.format;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiPredicate;
import java.util.stream.Collectors;
import org.dronewatch.report.html.Html;
import org.dronewatch.report.html.ReadableNumbers;
import org.dronewatch.run.DetectionIntervals;
import org.dronewatch.run.RunResult;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.SensorSettings;

/**
 * Tables of the drones that sensors of a run never detected, did not detect for part of the time, or lost and did not
 * regain, with the reasons: a row for each sensor with each drone or swarm.
 */
final class Misses {
    /** In a larger swarm, reasons are determined for this number of drones, evenly spaced in the list. */
    private static final int MAX_MEMBERS = 20;

    /** A sensor that misses a drone for less than this fraction of the run detects it throughout. */
    private static final double LEAST_MISSED = 0.01;

    private final RunResult run;
    private final RunLooks looks;
    private final Reasons reasons;
    private final List<DroneGroup> groups;
    private final DetectionIntervals intervals;

    /** The pairs of sensor and drone, by whether the sensor detects the drone at any time. */
    private final Map<Boolean, Set<List<String>>> pairs;

    Misses(RunResult run, RunLooks looks, Reasons reasons) {
        this.run = run;
        this.looks = looks;
        this.reasons = reasons;
        this.groups = DroneGroup.of(run.settings());
        this.intervals = DetectionIntervals.of(run.events());
        this.pairs = run.pairs().stream()
                .collect(Collectors.partitioningBy(
                        pair -> pair.firstDetected().isPresent(),
                        Collectors.mapping(pair -> List.of(pair.sensor(), pair.drone()), Collectors.toSet())));
    }

    String tables() {
        if (run.pairs().isEmpty()) {
            return Html.plain("p", "The scene has no drone, or no sensor that is switched on.");
        }
        String never = table(
                List.of("sensor", "kind", "drone", "reason"),
                (sensor, drone) -> pairs.get(false).contains(List.of(sensor, drone)),
                (sensor, group, members) -> row(sensor, group, members, why(sensor, members)));
        String partly = table(
                List.of("sensor", "kind", "drone", "time without detection", "reason"),
                this::isPartly,
                this::partlyRow);
        String lost = table(
                List.of("sensor", "kind", "drone", "lost at [s]", "range at loss [m]", "reason after loss"),
                (sensor, drone) -> intervals.lostForGood(sensor, drone).isPresent(),
                this::lostRow);
        if (never.isEmpty() && partly.isEmpty()) {
            return lost.isEmpty()
                    ? Html.plain("p", "None: every sensor detects every drone for at least 99 % of the time.")
                    : Html.plain(
                                    "p",
                                    "Every sensor detects every drone for at least 99 % of the time, but some lose a"
                                            + " drone and do not detect it again.")
                            + lost;
        }
        String which = never.isEmpty()
                ? "Every sensor detects every drone at some time."
                : "Some sensors detect a drone, but not all the time.";
        String introduction = Html.plain(
                "p",
                which + " The table below states for what part of the run a sensor does not detect a drone, and why.");
        return never + (partly.isEmpty() ? "" : introduction + partly) + lost;
    }

    /** Makes the row of a sensor with some drones of a group. */
    @FunctionalInterface
    private interface Row {
        List<String> of(String sensor, DroneGroup group, List<String> members);
    }

    /** A row for each sensor and group with the pairs that a table is about; empty without such pairs. */
    private String table(List<String> head, BiPredicate<String, String> isShown, Row row) {
        List<List<String>> rows = new ArrayList<>();
        int left = 0;
        for (String sensor : run.settings().enabledSensors().keySet()) {
            for (DroneGroup group : groups) {
                List<String> members = group.members().stream()
                        .filter(drone -> isShown.test(sensor, drone))
                        .toList();
                if (members.isEmpty()) {
                    continue;
                }
                if (rows.size() < DetectionTables.MAX_ROWS) {
                    rows.add(row.of(sensor, group, members));
                } else {
                    left++;
                }
            }
        }
        return rows.isEmpty() ? "" : Html.table(head, rows) + DetectionTables.notShown(left);
    }

    /** Whether a sensor detects a drone at some time, but not all the time. */
    private boolean isPartly(String sensor, String drone) {
        return pairs.get(true).contains(List.of(sensor, drone))
                && reasons.missedPart(sensor, drone, intervals) >= LEAST_MISSED;
    }

    private List<String> partlyRow(String sensor, DroneGroup group, List<String> members) {
        DoubleSummaryStatistics parts = members.stream()
                .mapToDouble(drone -> reasons.missedPart(sensor, drone, intervals))
                .summaryStatistics();
        String least = Reasons.percentOfSome(parts.getMin());
        String most = Reasons.percentOfSome(parts.getMax());
        String why = reasons.whileUndetected(sensor, some(members), intervals, looks);
        List<String> row = new ArrayList<>(row(sensor, group, members, why));
        row.add(3, least.equals(most) ? most : least + " to " + most);
        return row;
    }

    private String why(String sensor, List<String> members) {
        Optional<BestLook> best = members.stream()
                .flatMap(drone -> looks.best(sensor, drone).stream())
                .max(Comparator.comparingDouble(BestLook::margin));
        return reasons.of(sensor, some(members), best);
    }

    /** A sensor that lost drones for the rest of the run. */
    private List<String> lostRow(String sensor, DroneGroup group, List<String> members) {
        List<Observation> lost = members.stream()
                .map(drone -> intervals.lostForGood(sensor, drone).orElseThrow())
                .toList();
        double last = lost.stream().mapToDouble(Observation::arrival).max().orElseThrow();
        List<String> row =
                new ArrayList<>(row(sensor, group, members, reasons.afterLoss(sensor, some(members), last, looks)));
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
