package org.dronewatch.report;

import java.util.Optional;
import org.dronewatch.fusion.FalseAlertRate;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.run.FalseAlarmResult;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.SceneResult;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.alarm.FalseAlarmRate;
import org.dronewatch.sensor.alarm.FalseAlarming;
import org.dronewatch.world.Weather;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * The key {@code false_alarms} of {@code result.json}: what the alert rule costs, run by run. Left out if nothing is
 * known of false alarms, and none was raised.
 */
final class FalseAlarmsKey {
    private final SceneResult result;

    FalseAlarmsKey(SceneResult result) {
        this.result = result;
    }

    /** Whether some sensor states a rate, or raised a false alarm. */
    boolean isKnown() {
        return result.runs().stream()
                .anyMatch(run ->
                        run.falseAlarms().count() > 0 || !run.falseAlertRate().isUnknown());
    }

    void addTo(ArrayNode runs) {
        result.runs().forEach(run -> add(runs.addObject(), run));
    }

    private static void add(ObjectNode node, RunResult run) {
        FalseAlarmResult counted = run.falseAlarms();
        node.put("run", run.run());
        add(node, run.falseAlertRate());
        node.put("alerts", counted.alertCount());
        ArrayNode times = node.putArray("alerts_s");
        counted.alerts().forEach(alert -> times.add(Numbers.rounded(alert.time())));
        if (!run.settings().birds().isEmpty()) {
            ArrayNode birds = node.putArray("birds");
            counted.birds().forEach((bird, alert) -> {
                ObjectNode one = birds.addObject();
                one.put("bird", bird);
                one.put("alert_s", Numbers.rounded(alert.time()));
                ArrayNode raisedBy = one.putArray("sensors");
                alert.sensors().forEach(raisedBy::add);
            });
        }
        ArrayNode sensors = node.putArray("sensors");
        run.settings().enabledSensors().forEach((id, sensor) -> {
            ObjectNode one = sensors.addObject();
            one.put("sensor", id);
            rate(sensor, run.settings().world().weather())
                    .ifPresentOrElse(
                            rate -> {
                                one.put("per_hour", rate.perHour());
                                one.put("per_look", rate.perLook());
                                one.put("cells", rate.cells());
                                one.put("looks", rate.looks());
                            },
                            () -> one.putNull("per_hour"));
            one.put("counted", counted.counted().getOrDefault(id, 0L));
        });
        if (!counted.trials().isEmpty()) {
            ArrayNode trials = node.putArray("confirmations");
            counted.trials().forEach(trial -> {
                ObjectNode one = trials.addObject();
                one.put("hits", trial.confirm().hits());
                one.put("looks", trial.confirm().looks());
                add(one, run.falseAlertRate(trial.confirm()));
                ObjectNode alerts = one.putObject("drone_alerts_s");
                trial.alerts().forEach((drone, time) -> ResultFile.put(alerts, drone, time));
            });
        }
    }

    private static void add(ObjectNode node, FalseAlertRate rate) {
        if (rate.isUnknown()) {
            node.putNull("per_day");
        } else {
            node.put("per_day", rate.perDay());
            node.put("upper_bound", rate.isUpperBound());
        }
        ArrayNode unknown = node.putArray("unknown");
        rate.unknown().forEach(unknown::add);
        ArrayNode merging = node.putArray("merging");
        rate.merging().forEach(merging::add);
    }

    private static Optional<FalseAlarmRate> rate(SensorSettings<?> sensor, Weather weather) {
        return sensor.as(FalseAlarming.class).flatMap(capability -> capability.falseAlarmRate(weather));
    }
}
