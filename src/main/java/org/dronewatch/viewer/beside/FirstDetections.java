package org.dronewatch.viewer.beside;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.run.DetectionEvent;
import org.dronewatch.sensor.Observation;
import org.dronewatch.viewer.run.RecordedRun;

/** When each sensor first detects each drone in a run, as far as it has been simulated. For use by one thread. */
final class FirstDetections {
    private final RecordedRun run;
    private final Set<String> drones;
    private final Set<String> sensors;
    private final Map<List<String>, Observation> ofPairs = new HashMap<>();
    private final Map<String, Observation> ofDrones = new HashMap<>();
    private int seen;

    FirstDetections(RecordedRun run) {
        this.run = run;
        this.drones = run.info().settings().individualDrones().keySet();
        this.sensors = run.info().settings().enabledSensors().keySet();
    }

    /** Takes what has been simulated since. */
    void update() {
        List<DetectionEvent> next = run.eventsFrom(seen);
        seen += next.size();
        for (DetectionEvent event : next) {
            if (event.gained()) {
                Observation first = event.observation();
                ofPairs.putIfAbsent(List.of(first.sensor(), first.drone()), first);
                ofDrones.merge(first.drone(), first, (a, b) -> b.arrival() < a.arrival() ? b : a);
            }
        }
    }

    RecordedRun run() {
        return run;
    }

    /** The names of its drones. */
    Set<String> drones() {
        return drones;
    }

    /** The names of its sensors that are switched on. */
    Set<String> sensors() {
        return sensors;
    }

    /** The observation with which a sensor first detects a drone; empty if it has not done so. */
    Optional<Observation> of(String sensor, String drone) {
        return Optional.ofNullable(ofPairs.get(List.of(sensor, drone)));
    }

    /** The observation with which any sensor first detects a drone; empty if none has done so. */
    Optional<Observation> ofAny(String drone) {
        return Optional.ofNullable(ofDrones.get(drone));
    }
}
