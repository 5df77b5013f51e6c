package org.dronewatch.report.html.run;

import static org.dronewatch.report.html.ReadableNumbers.NONE;
import static org.dronewatch.report.html.ReadableNumbers.format;
import static org.dronewatch.report.html.ReadableNumbers.orElse;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.Collectors;
import org.dronewatch.report.html.Html;
import org.dronewatch.run.AlertResult;
import org.dronewatch.run.PairResult;
import org.dronewatch.run.RunResult;

/** All runs of a sweep, with a row for each: drones detected, alerts, warning time, and whether alerts were in time. */
final class RunsTable {
    private final List<RunResult> runs;
    private final boolean zone;

    RunsTable(List<RunResult> runs) {
        this.runs = List.copyOf(runs);
        this.zone = runs.stream().anyMatch(run -> run.settings().alert().isProtecting());
    }

    String html() {
        List<String> head = new ArrayList<>(List.of(
                "run",
                "swept value",
                "drones detected",
                "first detected by",
                "first detected [s]",
                "range at first detection [m]",
                "alerts",
                "first alert [s]"));
        if (zone) {
            head.addAll(List.of("shortest warning time [s]", "in time"));
        }
        return Html.table(head, runs.stream().map(this::row).toList());
    }

    private List<String> row(RunResult run) {
        List<AlertResult> alerts = run.attackAlerts();
        Set<String> drones = alerts.stream().map(AlertResult::drone).collect(Collectors.toSet());
        List<PairResult> pairs = run.pairs().stream()
                .filter(pair -> drones.contains(pair.drone()))
                .toList();
        Optional<PairResult> first = pairs.stream()
                .filter(pair -> pair.firstDetected().isPresent())
                .min(Comparator.comparingDouble(pair -> pair.firstDetected().getAsDouble()));
        List<String> row = new ArrayList<>(List.of(
                Integer.toString(run.run()),
                SweepVerdict.value(run),
                of(
                        pairs.stream()
                                .filter(pair -> pair.firstDetected().isPresent())
                                .map(PairResult::drone)
                                .distinct()
                                .count(),
                        drones.size()),
                first.map(PairResult::sensor).orElse(NONE),
                orElse(first.map(PairResult::firstDetected).orElse(OptionalDouble.empty()), "never"),
                orElse(first.map(PairResult::range).orElse(OptionalDouble.empty()), NONE),
                of(alerts.stream().filter(alert -> alert.time().isPresent()).count(), alerts.size()),
                orElse(
                        alerts.stream()
                                .filter(alert -> alert.time().isPresent())
                                .mapToDouble(alert -> alert.time().getAsDouble())
                                .min(),
                        "never")));
        if (zone) {
            row.addAll(List.of(warning(alerts), inTime(alerts)));
        }
        return row;
    }

    private static String warning(List<AlertResult> alerts) {
        boolean missing = alerts.stream().anyMatch(alert -> alert.warning().isEmpty());
        OptionalDouble least = alerts.stream()
                .filter(alert -> alert.warning().isPresent())
                .mapToDouble(alert -> alert.warning().getAsDouble())
                .min();
        return missing ? "none" : orElse(least, "none");
    }

    private static String inTime(List<AlertResult> alerts) {
        if (alerts.stream().noneMatch(alert -> alert.inTime().isPresent())) {
            return "not required";
        }
        long late = alerts.stream().filter(RunRank::isLate).count();
        return late == 0 ? "yes" : alerts.size() == 1 ? "NO" : format("NO: %d of %d late", late, alerts.size());
    }

    private static String of(long count, int all) {
        return count + " of " + all;
    }
}
