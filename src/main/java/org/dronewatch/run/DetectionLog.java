package org.dronewatch.run;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Consumer;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Observation;

/** Records when sensors gain and lose detection of drones in one run, and their first and farthest detections. */
public final class DetectionLog {
    private final int run;
    private final Consumer<DetectionEvent> target;
    private final Map<List<String>, Pair> pairs = new LinkedHashMap<>();
    private final List<DetectionEvent> events = new ArrayList<>();
    private final Set<String> birds;

    /**
     * A log for every sensor and every drone of a scene.
     *
     * @param target receives each event at once, including those of birds
     */
    public DetectionLog(int run, SceneSettings settings, Consumer<DetectionEvent> target) {
        this.run = run;
        this.target = target;
        this.birds = settings.birds();
        settings.enabledSensors().forEach((sensor, sensorSettings) -> settings.individualDrones()
                .keySet()
                .forEach(drone -> pairs.put(List.of(sensor, drone), new Pair(sensor, sensorSettings.kind(), drone))));
    }

    /**
     * Adds what all sensors observed at one time. A sensor that observed a drone several times detected it if any of
     * these observations did; false alarms are not detections of any drone.
     */
    public void add(List<Observation> observations) {
        Map<List<String>, Observation> looks = new LinkedHashMap<>();
        for (Observation observation : observations) {
            if (!observation.isFalse()) {
                looks.merge(
                        List.of(observation.sensor(), observation.drone()),
                        observation,
                        (before, next) -> before.isDetected() || !next.isDetected() ? before : next);
            }
        }
        looks.forEach((pair, observation) -> add(pairs.get(pair), observation));
    }

    private void add(Pair pair, Observation observation) {
        boolean detected = observation.isDetected();
        if (detected != pair.detected) {
            pair.detected = detected;
            DetectionEvent event = new DetectionEvent(run, detected, observation);
            if (!observation.isBird()) {
                events.add(event);
            }
            target.accept(event);
        }
        if (detected) {
            pair.add(observation);
        }
    }

    /** The events in which a sensor gained or lost detection of a drone; those of birds are left out. */
    public List<DetectionEvent> events() {
        return List.copyOf(events);
    }

    /** The result for each sensor and each drone; birds are left out. */
    public List<PairResult> pairs() {
        return pairs.values().stream()
                .filter(pair -> !birds.contains(pair.drone))
                .map(pair -> pair.toResult(run))
                .toList();
    }

    private static final class Pair {
        private final String sensor;
        private final String kind;
        private final String drone;
        private boolean detected;
        private OptionalDouble first = OptionalDouble.empty();
        private OptionalDouble range = OptionalDouble.empty();
        private boolean isUnknown;
        private OptionalDouble maxRange = OptionalDouble.empty();

        Pair(String sensor, String kind, String drone) {
            this.sensor = sensor;
            this.kind = kind;
            this.drone = drone;
        }

        public void add(Observation observation) {
            if (first.isEmpty()) {
                first = OptionalDouble.of(observation.arrival());
                range = OptionalDouble.of(observation.range());
                isUnknown = observation.isUnknown();
            }
            maxRange = OptionalDouble.of(Math.max(maxRange.orElse(0.0), observation.range()));
        }

        PairResult toResult(int run) {
            return new PairResult(run, sensor, kind, drone, first, range, isUnknown, maxRange);
        }
    }
}
