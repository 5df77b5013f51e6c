package org.dronewatch.run;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.ThreatLabel;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.fusion.Confirmation;
import org.dronewatch.fusion.FalseAlertRate;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Observation;
import org.dronewatch.setting.Spelling;

/**
 * The result of one run of a scene.
 *
 * @param run number of the run in the sweep, from 0
 * @param settings the settings of the run
 * @param simulated simulated time, s
 * @param events detections gained and lost, in order of time
 * @param pairs the result for each sensor and each drone, in the order of the scene
 * @param alerts the alert for each drone other than birds, with the warning time
 * @param falseAlarms the false alarms and false alerts, which no drone caused
 */
public record RunResult(
        int run,
        SceneSettings settings,
        double simulated,
        List<DetectionEvent> events,
        List<PairResult> pairs,
        List<AlertResult> alerts,
        FalseAlarmResult falseAlarms) {
    /** Copies the lists: later changes by the caller have no effect. */
    public RunResult {
        events = List.copyOf(events);
        pairs = List.copyOf(pairs);
        alerts = List.copyOf(alerts);
    }

    /** The result of a run that was cancelled before it had a stage: nothing was simulated, nothing detected. */
    public static RunResult notBegun(RunInfo info) {
        List<PairResult> pairs = new DetectionLog(info.run(), info.settings(), event -> {}).pairs();
        return new RunResult(info.run(), info.settings(), 0.0, List.of(), pairs, List.of(), FalseAlarmResult.NONE);
    }

    /** The alerts that count: those for attacking drones; if no drone attacks, all. */
    public List<AlertResult> attackAlerts() {
        Map<String, DroneSettings> drones = settings.individualDrones();
        List<AlertResult> attacks = alerts.stream()
                .filter(alert -> drones.get(alert.drone()).label().role() == ThreatLabel.Role.ATTACK)
                .toList();
        return attacks.isEmpty() ? alerts : attacks;
    }

    /** The expected number of false alerts per day under the scene's rule, in closed form. */
    public FalseAlertRate falseAlertRate() {
        return falseAlertRate(settings.alert().confirm());
    }

    /** The expected number of false alerts per day with another confirmation. */
    public FalseAlertRate falseAlertRate(Confirmation confirm) {
        AlertSettings alert = settings.alert();
        AlertSettings changed =
                confirm.equals(alert.confirm()) ? alert : alert.withConfirmation(confirm.hits(), confirm.looks());
        return FalseAlertRate.of(
                changed, settings.enabledSensors(), settings.world().weather());
    }

    /**
     * The observation with which a sensor first detected a drone; empty if never.
     *
     * @throws IllegalArgumentException when the scene has no such sensor, or it is switched off
     */
    public Optional<Observation> firstDetection(String sensor) {
        requireSensor(sensor);
        return events.stream()
                .filter(DetectionEvent::gained)
                .map(DetectionEvent::observation)
                .filter(observation -> observation.sensor().equals(sensor))
                .findFirst();
    }

    /**
     * The greatest distance, over all drones, at which a sensor first detected one, m; empty if it detected none.
     *
     * @throws IllegalArgumentException when the scene has no such sensor, or it is switched off
     */
    public OptionalDouble firstDetectionRange(String sensor) {
        requireSensor(sensor);
        return pairs.stream()
                .filter(pair -> pair.sensor().equals(sensor) && pair.range().isPresent())
                .mapToDouble(pair -> pair.range().getAsDouble())
                .max();
    }

    /** A misspelt name is not taken for a sensor that detects nothing: a test of ranges would pass for ever. */
    private void requireSensor(String name) {
        if (!settings.isEnabled(name)) {
            boolean isOff = settings.sensors().containsKey(name);
            throw new IllegalArgumentException(
                    isOff
                            ? "sensor '" + name + "' is switched off"
                            : Spelling.unknown(
                                    "sensor",
                                    name,
                                    "the scene",
                                    settings.enabledSensors().keySet()));
        }
    }
}
