package org.dronewatch.report.html.run;

import static org.dronewatch.report.html.ReadableNumbers.NONE;
import static org.dronewatch.report.html.ReadableNumbers.format;
import static org.dronewatch.report.html.ReadableNumbers.orElse;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import org.dronewatch.report.html.Html;
import org.dronewatch.report.html.ReadableNumbers;
import org.dronewatch.run.DetectionEvent;
import org.dronewatch.run.PairResult;
import org.dronewatch.run.RunResult;
import org.dronewatch.setting.Counted;

/**
 * Detections of a run by sensor: a row for each sensor with each drone or swarm, and a collapsible section with each
 * swarm's drones.
 */
final class DetectionTables {
    /** Maximum number of rows of a table. */
    static final int MAX_ROWS = 60;

    /** Maximum number of rows of a collapsed table. */
    private static final int MAX_FOLDED_ROWS = 500;

    private static final List<String> HEAD = List.of(
            "sensor",
            "kind",
            "drone",
            "first detected [s]",
            "range at first detection [m]",
            "last detected [s]",
            "maximum detection range [m]",
            "fraction of looks with a detection");

    private final RunResult run;
    private final RunLooks looks;
    private final List<DroneGroup> groups;
    private final Map<List<String>, DetectionEvent> lastEvents = new LinkedHashMap<>();

    DetectionTables(RunResult run, RunLooks looks) {
        this.run = run;
        this.looks = looks;
        this.groups = DroneGroup.of(run.settings());
        for (DetectionEvent event : run.events()) {
            lastEvents.put(
                    List.of(event.observation().sensor(), event.observation().drone()), event);
        }
    }

    /** The table; if it is very long, only the first rows with detections. */
    String detections() {
        Map<String, List<PairResult>> bySensor = run.pairs().stream()
                .collect(Collectors.groupingBy(PairResult::sensor, LinkedHashMap::new, Collectors.toList()));
        List<List<String>> detected = new ArrayList<>();
        List<List<String>> all = new ArrayList<>();
        List<List<String>> members = new ArrayList<>();
        bySensor.values()
                .forEach(pairs -> groups.forEach(group -> {
                    List<PairResult> of = pairs.stream()
                            .filter(pair -> group.members().contains(pair.drone()))
                            .toList();
                    List<String> row = group.isSwarm() ? ofSwarm(group, of) : ofDrone(of.get(0), group.label());
                    all.add(row);
                    if (of.stream().anyMatch(pair -> pair.firstDetected().isPresent())) {
                        detected.add(row);
                    }
                    if (group.isSwarm()) {
                        of.forEach(pair -> members.add(ofDrone(pair, pair.drone())));
                    }
                }));
        return shortened(all, detected) + folded(members);
    }

    private static String shortened(List<List<String>> all, List<List<String>> detected) {
        if (all.size() <= MAX_ROWS) {
            return Html.table(HEAD, all);
        }
        int without = all.size() - detected.size();
        return (without > 0
                        ? Html.plain(
                                "p",
                                Counted.of(
                                        without,
                                        "sensor-drone pair without a detection is not shown.",
                                        "sensor-drone pairs without a detection are not shown."))
                        : "")
                + Html.table(HEAD, detected.subList(0, Math.min(MAX_ROWS, detected.size())))
                + notShown(detected.size() - MAX_ROWS);
    }

    /** States how many rows a table omits; empty if it omits none. */
    static String notShown(int left) {
        return left > 0
                ? Html.plain(
                        "p",
                        Counted.of(
                                left, "more sensor-drone pair is not shown.", "more sensor-drone pairs are not shown."))
                : "";
    }

    private static String folded(List<List<String>> members) {
        if (members.isEmpty()) {
            return "";
        }
        List<List<String>> shown = members.subList(0, Math.min(MAX_FOLDED_ROWS, members.size()));
        String rest = shown.size() == members.size()
                ? ""
                : Html.plain(
                        "p",
                        Counted.of(
                                members.size() - shown.size(), "more row is not shown.", "more rows are not shown."));
        return Html.fold("Individual drones of the swarms", Html.table(HEAD, shown) + rest, false);
    }

    private List<String> ofDrone(PairResult pair, String label) {
        return List.of(
                pair.sensor(),
                pair.kind(),
                label,
                orElse(pair.firstDetected(), "never") + (pair.isUnknown() ? " (over unknown ground)" : ""),
                orElse(pair.range(), NONE),
                last(pair),
                orElse(pair.maxRange(), NONE),
                percent(looks.detecting(pair.sensor(), pair.drone())));
    }

    private List<String> ofSwarm(DroneGroup swarm, List<PairResult> pairs) {
        List<PairResult> detected =
                pairs.stream().filter(pair -> pair.firstDetected().isPresent()).toList();
        String first = detected.isEmpty()
                ? "never"
                : format(
                        "%d of %d: %s",
                        detected.size(),
                        pairs.size(),
                        ReadableNumbers.range(
                                values(detected, pair -> pair.firstDetected().getAsDouble())));
        double[] fractions = pairs.stream()
                .mapToDouble(pair -> looks.detecting(pair.sensor(), pair.drone()))
                .sorted()
                .toArray();
        String least = percent(fractions[0]);
        String most = percent(fractions[fractions.length - 1]);
        return List.of(
                pairs.get(0).sensor(),
                pairs.get(0).kind(),
                swarm.label(),
                first,
                ReadableNumbers.range(values(detected, pair -> pair.range().getAsDouble())),
                lastOf(detected),
                ReadableNumbers.range(values(detected, pair -> pair.maxRange().getAsDouble())),
                least.equals(most) ? least : least + " to " + most);
    }

    private static DoubleStream values(List<PairResult> pairs, ToDoubleFunction<PairResult> value) {
        return pairs.stream().mapToDouble(value);
    }

    private static String percent(double fraction) {
        return format("%.0f %%", 100.0 * fraction);
    }

    /** The time until which a sensor detects a drone: when the sensor loses it for the last time. */
    private String last(PairResult pair) {
        return lastEvents.containsKey(List.of(pair.sensor(), pair.drone())) ? orElse(lost(pair), "to the end") : NONE;
    }

    private OptionalDouble lost(PairResult pair) {
        DetectionEvent last = lastEvents.get(List.of(pair.sensor(), pair.drone()));
        return last.gained()
                ? OptionalDouble.empty()
                : OptionalDouble.of(last.observation().arrival());
    }

    private String lastOf(List<PairResult> detected) {
        if (detected.stream().anyMatch(pair -> lost(pair).isEmpty())) {
            return "to the end";
        }
        OptionalDouble last =
                detected.stream().mapToDouble(pair -> lost(pair).getAsDouble()).max();
        return orElse(last, NONE);
    }
}
