package org.dronewatch.report.html.run;

import static org.dronewatch.report.html.ReadableNumbers.NONE;
import static org.dronewatch.report.html.ReadableNumbers.format;
import static org.dronewatch.report.html.ReadableNumbers.orElse;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.stream.DoubleStream;
import org.dronewatch.report.html.Html;
import org.dronewatch.report.html.ReadableNumbers;
import org.dronewatch.run.AlertResult;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.Sightline;

/**
 * A table of when the alert for each drone of a run was raised, and how early that was: a row for each drone or swarm.
 */
final class AlertTable {
    private static final int MAX_SENSORS = 4;

    private final RunResult run;
    private final boolean zone;
    private final boolean named;

    AlertTable(RunResult run) {
        this.run = run;
        this.named = !run.settings().alert().zones().isEmpty();
        this.zone = run.settings().alert().isProtecting();
    }

    /** The table, and a collapsible section with each swarm's drones. */
    String html() {
        List<List<String>> rows = new ArrayList<>();
        List<List<String>> members = new ArrayList<>();
        for (DroneGroup group : DroneGroup.of(run.settings())) {
            List<AlertResult> alerts = run.alerts().stream()
                    .filter(alert -> group.members().contains(alert.drone()))
                    .toList();
            if (group.isSwarm()) {
                rows.add(ofSwarm(group, alerts));
                alerts.forEach(alert -> members.add(ofDrone(alert, alert.drone())));
            } else {
                rows.add(ofDrone(alerts.get(0), group.label()));
            }
        }
        return Html.table(head(), rows)
                + (members.isEmpty()
                        ? ""
                        : Html.fold("Individual drones of the swarms", Html.table(head(), members), false));
    }

    private List<String> head() {
        List<String> head = new ArrayList<>(List.of(
                "drone",
                "first in any sensor's view [s]",
                "alert [s]",
                "delay from first view to alert [s]",
                "raised by"));
        if (zone) {
            head.addAll(List.of("distance to zone at alert [m]", "warning time [s]", "reaches zone [s]", "in time"));
        }
        return head;
    }

    private List<String> ofDrone(AlertResult alert, String label) {
        List<String> row = new ArrayList<>(List.of(
                label,
                orElse(alert.firstSight(), views() ? "never" : NONE),
                orElse(alert.time(), "never"),
                orElse(delay(alert), NONE),
                alert.sensors().isEmpty() ? NONE : String.join(", ", alert.sensors())));
        if (zone) {
            row.addAll(List.of(
                    orElse(alert.zoneDistance(), NONE),
                    orElse(alert.warning(), "none"),
                    orElse(alert.entered(), "not in this run")
                            + (named
                                    ? alert.zone()
                                            .map(name -> " (" + name + ")")
                                            .orElse("")
                                    : ""),
                    alert.inTime().map(enough -> enough ? "yes" : "NO").orElse("not required")));
        }
        return row;
    }

    private List<String> ofSwarm(DroneGroup swarm, List<AlertResult> alerts) {
        List<String> sensors = alerts.stream()
                .flatMap(alert -> alert.sensors().stream())
                .distinct()
                .toList();
        String names = String.join(", ", sensors.subList(0, Math.min(MAX_SENSORS, sensors.size())));
        int more = sensors.size() - MAX_SENSORS;
        List<String> row = new ArrayList<>(List.of(
                swarm.label(),
                counted(alerts, AlertResult::firstSight, views() ? "never" : NONE),
                counted(alerts, AlertResult::time, "never"),
                ReadableNumbers.range(values(alerts, AlertTable.this::delay)),
                sensors.isEmpty() ? NONE : more > 0 ? names + " and " + more + " more" : names));
        if (zone) {
            long asked =
                    alerts.stream().filter(alert -> alert.inTime().isPresent()).count();
            long inTime = alerts.stream()
                    .filter(alert -> alert.inTime().orElse(false))
                    .count();
            row.addAll(List.of(
                    ReadableNumbers.range(values(alerts, AlertResult::zoneDistance)),
                    counted(alerts, AlertResult::warning, "none"),
                    counted(alerts, AlertResult::entered, "not in this run"),
                    asked == 0 ? "not required" : inTime + " of " + alerts.size()));
        }
        return row;
    }

    /** How many of the alerts have a value, and the range of these values. */
    private static String counted(List<AlertResult> alerts, Function<AlertResult, OptionalDouble> value, String none) {
        long count = values(alerts, value).count();
        String range = ReadableNumbers.range(values(alerts, value));
        return count == 0 ? none : count == alerts.size() ? range : format("%d of %d: %s", count, alerts.size(), range);
    }

    private static DoubleStream values(List<AlertResult> alerts, Function<AlertResult, OptionalDouble> value) {
        return alerts.stream().map(value).filter(OptionalDouble::isPresent).mapToDouble(OptionalDouble::getAsDouble);
    }

    /**
     * The delay from the time at which the drone comes into view to the alert; empty for an earlier alert, and for one
     * raised only by sensors without a field of view.
     */
    private OptionalDouble delay(AlertResult alert) {
        boolean byView = alert.sensors().stream()
                .anyMatch(sensor ->
                        Sightline.hasFieldOfView(run.settings().sensors().get(sensor)));
        boolean before = alert.time().orElse(0.0) < alert.firstSight().orElse(Double.POSITIVE_INFINITY);
        return byView && !before ? alert.timeToAlert() : OptionalDouble.empty();
    }

    /** Whether any sensor has a field of view. */
    private boolean views() {
        return run.settings().enabledSensors().values().stream().anyMatch(Sightline::hasFieldOfView);
    }
}
