package org.dronewatch.report.html.run;

import static org.dronewatch.report.html.ReadableNumbers.NONE;
import static org.dronewatch.report.html.ReadableNumbers.format;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.dronewatch.fusion.AlertRule;
import org.dronewatch.fusion.Confirmation;
import org.dronewatch.fusion.FalseAlertRate;
import org.dronewatch.report.html.Html;
import org.dronewatch.report.html.ReadableNumbers;
import org.dronewatch.run.AlertResult;
import org.dronewatch.run.ConfirmationTrial;
import org.dronewatch.run.FalseAlarmResult;
import org.dronewatch.run.RunResult;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.alarm.FalseAlarmRate;
import org.dronewatch.sensor.alarm.FalseAlarming;
import org.dronewatch.setting.Counted;
import org.dronewatch.world.Weather;

/** What the alert rule of a run costs in false alerts, and what another confirmation would gain or lose. */
final class FalseAlarmTables {
    private final RunResult run;
    private final FalseAlarmResult counted;
    private final FalseAlertRate rate;

    FalseAlarmTables(RunResult run) {
        this.run = run;
        this.counted = run.falseAlarms();
        this.rate = run.falseAlertRate();
    }

    String html() {
        String price = Html.plain("p", "False alerts with this rule: " + rate.inWords() + "." + inThisRun() + birds());
        if (rate.isUnknown()) {
            return price
                    + (counted.count() == 0
                            ? Html.plain(
                                    "p",
                                    "No sensor of this scene states a rate of false alarms"
                                            + " ('falseAlarms'): the rate of false alerts is unknown, not zero.")
                            : "");
        }
        return price + assumptions() + trials() + sensors();
    }

    private String inThisRun() {
        return counted.count() == 0 && rate.isUnknown()
                ? ""
                : format(
                        " In this run: %s, %s.",
                        number(counted.count(), "false alarm"), number(counted.alertCount(), "false alert"));
    }

    /** Which of the false alerts were caused by birds. */
    private String birds() {
        return counted.birds().entrySet().stream()
                .map(one -> format(
                        " The alert at %.1f s, raised by %s, was caused by a bird: '%s'.",
                        one.getValue().time(), String.join(", ", one.getValue().sensors()), one.getKey()))
                .collect(Collectors.joining());
    }

    private static String number(long count, String what) {
        return Counted.of(count, what);
    }

    private static String assumptions() {
        return Html.plain(
                "p",
                "False alarms are assumed to be independent between looks, cells and sensors; those of"
                        + " one sensor confirm each other only in the same cell of its field of view.");
    }

    /** What each confirmation gains in time and costs in false alerts. */
    private String trials() {
        if (counted.trials().isEmpty()) {
            return "";
        }
        List<List<String>> rows = new ArrayList<>();
        for (ConfirmationTrial trial : counted.trials()) {
            rows.add(List.of(
                    inWords(trial.confirm())
                            + (trial.confirm().equals(run.settings().alert().confirm()) ? " (this rule)" : ""),
                    alerts(trial),
                    timeWon(trial),
                    run.falseAlertRate(trial.confirm()).inWords()));
        }
        return Html.table(List.of("confirmation (M of N looks)", "alert [s]", "time gained [s]", "false alerts"), rows);
    }

    private static String inWords(Confirmation confirm) {
        return confirm.looks() == 1 ? "1 of 1" : confirm.hits() + " of " + confirm.looks();
    }

    private List<String> drones() {
        return run.attackAlerts().stream().map(AlertResult::drone).toList();
    }

    private String alerts(ConfirmationTrial trial) {
        List<OptionalDouble> times =
                drones().stream().map(drone -> trial.alerts().get(drone)).toList();
        long raised = times.stream().filter(OptionalDouble::isPresent).count();
        String range = ReadableNumbers.range(times.stream().flatMapToDouble(OptionalDouble::stream));
        return raised == 0
                ? "never"
                : raised == times.size() ? range : format("%d of %d: %s", raised, times.size(), range);
    }

    /** How much earlier its alerts are than those of the scene's own rule, for drones with both. */
    private String timeWon(ConfirmationTrial trial) {
        Map<String, OptionalDouble> own = counted.trials().stream()
                .filter(other -> other.confirm().equals(run.settings().alert().confirm()))
                .findFirst()
                .orElseThrow()
                .alerts();
        return ReadableNumbers.range(drones().stream()
                .filter(drone ->
                        own.get(drone).isPresent() && trial.alerts().get(drone).isPresent())
                .mapToDouble(drone ->
                        own.get(drone).getAsDouble() - trial.alerts().get(drone).getAsDouble()));
    }

    /**
     * How often each sensor raises a false alarm, and how many false alerts that causes if one sensor is enough for an
     * alert.
     */
    private String sensors() {
        boolean isAlone = run.settings().alert().rule() instanceof AlertRule.AnySensor;
        List<String> head = new ArrayList<>(
                List.of("sensor", "false alarms per hour", "per look", "cells", "duration [looks]", "in this run"));
        if (isAlone) {
            head.add("false alerts per day");
        }
        List<List<String>> rows = new ArrayList<>();
        run.settings().enabledSensors().forEach((id, sensor) -> {
            Optional<FalseAlarmRate> known = rate(sensor, run.settings().world().weather());
            List<String> row = new ArrayList<>(List.of(
                    id,
                    known.map(one -> FalseAlertRate.brief(one.perHour())).orElse("unknown"),
                    known.map(one -> FalseAlertRate.brief(one.perLook())).orElse(NONE),
                    known.map(one -> Long.toString(one.cells())).orElse(NONE),
                    known.map(one -> Integer.toString(one.looks())).orElse(NONE),
                    Long.toString(counted.counted().getOrDefault(id, 0L))));
            if (isAlone) {
                FalseAlertRate alone = FalseAlertRate.of(
                        run.settings().alert(),
                        Map.of(id, sensor),
                        run.settings().world().weather());
                row.add(known.isPresent() ? FalseAlertRate.brief(alone.perDay()) : "unknown");
            }
            rows.add(row);
        });
        return Html.table(head, rows);
    }

    private static Optional<FalseAlarmRate> rate(SensorSettings<?> sensor, Weather weather) {
        return sensor.as(FalseAlarming.class).flatMap(capability -> capability.falseAlarmRate(weather));
    }
}
