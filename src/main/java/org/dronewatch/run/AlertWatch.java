package org.dronewatch.run;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import org.dronewatch.drone.Drone;
import org.dronewatch.fusion.Alert;
import org.dronewatch.fusion.AlertLog;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.fusion.ForecastLog;
import org.dronewatch.fusion.Protection;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.alarm.FalseAlarmSource;
import org.dronewatch.tracking.ContactLook;
import org.dronewatch.tracking.PerfectAssociation;

/**
 * Scores the alerts that the scene's rule raises or forecasts in one run: the time at which each drone could first have
 * been seen, the time of its alert, and the warning time.
 */
public final class AlertWatch {
    private final int run;
    private final SceneSettings settings;
    private final Sightline sightline;
    private final Protection protection;
    private final PerfectAssociation association;
    private final AlertLog log;
    private final Optional<ForecastLog> forecast;
    private final ConfirmationTrials trials;
    private final Map<String, Long> falseAlarms = new LinkedHashMap<>();
    private final Map<String, Long> falseAlarmsOfBirds = new LinkedHashMap<>();
    private final List<Alert> falseAlerts = new ArrayList<>();
    private final Map<String, Double> firstSights = new HashMap<>();
    private final Map<String, Position> placesAtAlert = new HashMap<>();
    private final Map<String, Alert> birdAlerts = new LinkedHashMap<>();
    private final Set<String> birds;
    private long falseAlertCount;

    /**
     * A watch over a run at its start.
     *
     * @param stage stage of the run
     */
    AlertWatch(int run, SceneSettings settings, Stage stage) {
        this.run = run;
        this.settings = settings;
        this.birds = settings.birds();
        this.sightline = new Sightline(stage.world());
        this.protection = stage.protection();
        this.association = stage.association();
        this.log = stage.alerts();
        this.forecast = ForecastLog.of(settings.alert());
        this.trials = new ConfirmationTrials(settings, association);
    }

    /**
     * Adds the looks of one time.
     *
     * @param stage the run's stage, whose sensors have just looked
     */
    public void add(Frame frame, Stage stage) {
        addFirstSights(frame);
        frame.observations().stream()
                .filter(FalseAlarmSource::isNew)
                .filter(Observation::isDetected)
                .forEach(alarm -> falseAlarms.merge(alarm.sensor(), 1L, Long::sum));
        forecast.map(alerts -> alerts.add(association.assessed()))
                .orElse(stage.raised())
                .forEach(this::count);
        trials.add(stage.contactLooks());
        if (placesAtAlert.size() < frame.drones().size()) {
            addPlaces(frame, stage.contactLooks());
        }
        log.forget(association.ended());
        forecast.ifPresent(alerts -> alerts.forget(association.ended()));
    }

    /** Counts a bird that a sensor begins to detect as a false alarm. */
    void add(DetectionEvent event) {
        if (event.gained() && event.observation().isBird()) {
            falseAlarms.merge(event.observation().sensor(), 1L, Long::sum);
            falseAlarmsOfBirds.merge(event.observation().sensor(), 1L, Long::sum);
        }
    }

    private Optional<Alert> alert(int contact) {
        return forecast.map(alerts -> alerts.alert(contact)).orElseGet(() -> log.alert(contact));
    }

    /** Counts an alert for something that is not a drone. */
    private void count(Alert alert) {
        Optional<String> drone = association.droneOf(alert.contact());
        drone.filter(birds::contains).ifPresent(bird -> birdAlerts.put(bird, alert));
        if (drone.isEmpty() || birds.contains(drone.get())) {
            falseAlertCount++;
            if (falseAlerts.size() < FalseAlarmResult.MOST_ALERTS) {
                falseAlerts.add(alert);
            }
        }
    }

    private void addFirstSights(Frame frame) {
        if (firstSights.size() == frame.drones().size()) {
            return;
        }
        Map<String, Drone> drones = byName(frame);
        for (Observation observation : frame.observations()) {
            if (!observation.isFalse() && !firstSights.containsKey(observation.drone())) {
                SensorSettings<?> sensor = settings.sensors().get(observation.sensor());
                Position position = drones.get(observation.drone()).origin();
                if (Sightline.hasFieldOfView(sensor) && sightline.isPossible(sensor, position)) {
                    firstSights.put(observation.drone(), frame.time());
                }
            }
        }
    }

    private void addPlaces(Frame frame, List<ContactLook> looks) {
        Map<String, Drone> drones = byName(frame);
        for (ContactLook look : looks) {
            if (alert(look.contact()).isPresent()) {
                association
                        .droneOf(look.contact())
                        .ifPresent(drone -> placesAtAlert.computeIfAbsent(
                                drone, id -> drones.get(id).origin()));
            }
        }
    }

    private static Map<String, Drone> byName(Frame frame) {
        Map<String, Drone> drones = new HashMap<>();
        frame.drones().forEach(drone -> drones.put(drone.id(), drone));
        return drones;
    }

    /** The false alarms and the false alerts of the run, which no drone caused. */
    FalseAlarmResult falseAlarms() {
        List<String> drones = settings.individualDrones().keySet().stream()
                .filter(id -> !birds.contains(id))
                .toList();
        return new FalseAlarmResult(
                falseAlarms, falseAlarmsOfBirds, falseAlertCount, falseAlerts, birdAlerts, trials.results(drones));
    }

    /**
     * The alerts of the run, one for each drone, excluding birds.
     *
     * @param simulated duration of the run, s
     */
    public List<AlertResult> results(Stage stage, double simulated) {
        List<AlertResult> results = new ArrayList<>();
        for (Drone drone : stage.dronesAt(0.0)) {
            if (!drone.settings().isBird()) {
                results.add(result(drone, stage, simulated));
            }
        }
        return results;
    }

    private AlertResult result(Drone drone, Stage stage, double simulated) {
        OptionalInt contact = association.contactOf(drone.id());
        Optional<Alert> alert = contact.isPresent() ? alert(contact.getAsInt()) : Optional.empty();
        AlertSettings wanted = settings.alert();
        Optional<Position> position = Optional.ofNullable(placesAtAlert.get(drone.id()));
        OptionalDouble distance = OptionalDouble.empty();
        OptionalDouble warning = OptionalDouble.empty();
        OptionalDouble entered = OptionalDouble.empty();
        Optional<Boolean> inTime = Optional.empty();
        Optional<String> zone = Optional.empty();
        if (wanted.isProtecting()) {
            entered = new ZoneApproach(stage.flight(drone.id()), protection, simulated).entered();
            zone = zone(drone.id(), entered, position, stage);
            if (position.isPresent()) {
                distance = OptionalDouble.of(protection.distance(position.get()));
                boolean late = alert.orElseThrow().time() >= entered.orElse(Double.POSITIVE_INFINITY);
                warning = OptionalDouble.of(
                        late ? 0.0 : distance.getAsDouble() / drone.settings().speed());
            }
            if (wanted.response() > 0.0) {
                boolean before = alert.isPresent() && alert.get().time() <= entered.orElse(Double.POSITIVE_INFINITY);
                inTime = Optional.of(before && warning.orElse(0.0) >= wanted.response());
            }
        }
        Double sight = firstSights.get(drone.id());
        OptionalDouble firstSight = sight == null ? OptionalDouble.empty() : OptionalDouble.of(sight);
        return new AlertResult(run, drone.id(), firstSight, alert, distance, warning, entered, zone, inTime);
    }

    /**
     * The name of the zone that a drone enters first or, if it enters none, to which it is nearest at its alert; only
     * zones with names are distinguished.
     */
    private Optional<String> zone(String drone, OptionalDouble entered, Optional<Position> atAlert, Stage stage) {
        if (protection.areas().isEmpty()) {
            return Optional.empty();
        }
        return entered.isPresent()
                ? protection.nearest(stage.positionOf(drone, entered.getAsDouble()))
                : atAlert.flatMap(protection::nearest);
    }
}
