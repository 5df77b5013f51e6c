package org.dronewatch.fusion;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.sensor.Observation;

/** Follows the observations of one run, in order of time, and notices the first moment of alert for each drone. */
public final class AlertLog {
    private final AlertSettings settings;
    private final Map<String, Map<String, SensorTrack>> tracks = new LinkedHashMap<>();
    private final Map<String, Alert> alerts = new LinkedHashMap<>();

    /** A log of a run that begins. */
    public AlertLog(AlertSettings settings) {
        this.settings = settings;
    }

    /** Takes what the sensors observed at one time. */
    public void add(List<Observation> observations) {
        for (Observation observation : observations) {
            if (!alerts.containsKey(observation.drone())) {
                Map<String, SensorTrack> ofDrone =
                        tracks.computeIfAbsent(observation.drone(), drone -> new LinkedHashMap<>());
                ofDrone.computeIfAbsent(observation.sensor(), sensor -> new SensorTrack(sensor, settings.confirm()))
                        .add(observation);
            }
        }
        for (Observation observation : observations) {
            if (!alerts.containsKey(observation.drone())) {
                decide(observation.drone(), observation.arrival());
            }
        }
    }

    private void decide(String drone, double time) {
        List<String> sensors = settings.rule().carriers(tracks.get(drone).values(), time).stream()
                .map(SensorTrack::sensor)
                .toList();
        if (!sensors.isEmpty()) {
            alerts.put(drone, new Alert(drone, time, sensors));
            tracks.remove(drone);
        }
    }

    /** The alert to a drone, if there was one so far. */
    public Optional<Alert> alert(String drone) {
        return Optional.ofNullable(alerts.get(drone));
    }
}
