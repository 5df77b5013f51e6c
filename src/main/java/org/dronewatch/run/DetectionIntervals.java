package org.dronewatch.run;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.sensor.Observation;

/**
 * The intervals during which each sensor detects a drone in one run, from the event in which the sensor gains detection
 * of the drone to the event in which it loses detection. Times are times of reception: sound counts from its arrival at
 * the sensor. Events are added in order of time. Not thread-safe.
 */
public final class DetectionIntervals {
    private final Map<List<String>, List<DetectionEvent>> ofPairs = new HashMap<>();
    private final Map<String, Held> ofSensors = new HashMap<>();

    /**
     * An interval during which a sensor detects at least one drone.
     *
     * @param from seconds since the start of the run
     * @param to seconds since the start of the run, not before {@code from}
     */
    public record Interval(double from, double to) {}

    /** The intervals of a run's events, given in order of time. */
    public static DetectionIntervals of(List<DetectionEvent> events) {
        DetectionIntervals intervals = new DetectionIntervals();
        events.forEach(intervals::add);
        return intervals;
    }

    /** Adds an event. */
    public void add(DetectionEvent event) {
        Observation o = event.observation();
        ofPairs.computeIfAbsent(List.of(o.sensor(), o.drone()), pair -> new ArrayList<>())
                .add(event);
        ofSensors.computeIfAbsent(o.sensor(), sensor -> new Held()).add(event);
    }

    /**
     * Whether a sensor detects a drone at a time: true from the moment at which the sensor gains detection, false from
     * the moment at which it loses it.
     *
     * @param time seconds since the start of the run
     */
    public boolean isDetected(String sensor, String drone, double time) {
        boolean detected = false;
        for (DetectionEvent event : ofPairs.getOrDefault(List.of(sensor, drone), List.of())) {
            if (event.observation().arrival() > time) {
                break;
            }
            detected = event.gained();
        }
        return detected;
    }

    /**
     * The total time for which a sensor detects a drone, s.
     *
     * @param end the time up to which detections count, seconds since the start of the run
     */
    public double detectedFor(String sensor, String drone, double end) {
        double all = 0.0;
        double from = end;
        for (DetectionEvent event : ofPairs.getOrDefault(List.of(sensor, drone), List.of())) {
            double time = Math.min(end, event.observation().arrival());
            if (event.gained()) {
                from = time;
            } else {
                all += time - from;
                from = end;
            }
        }
        return all + end - from;
    }

    /**
     * The intervals during which a sensor detects at least one drone.
     *
     * @param end when an interval that is still open is taken to end, seconds since the start of the run
     */
    public List<Interval> ofSensor(String sensor, double end) {
        Held held = ofSensors.get(sensor);
        return held == null ? List.of() : held.until(end);
    }

    /**
     * The observation at which a sensor lost detection of a drone for good; empty if the sensor never detected the
     * drone or still detects it.
     */
    public Optional<Observation> lostForGood(String sensor, String drone) {
        List<DetectionEvent> events = ofPairs.getOrDefault(List.of(sensor, drone), List.of());
        return events.isEmpty() || events.get(events.size() - 1).gained()
                ? Optional.empty()
                : Optional.of(events.get(events.size() - 1).observation());
    }

    /** The detections of one sensor. */
    private static final class Held {
        private final List<Interval> closed = new ArrayList<>();
        private final Set<String> drones = new HashSet<>();
        private double from;

        void add(DetectionEvent event) {
            double time = event.observation().arrival();
            String drone = event.observation().drone();
            if (event.gained()) {
                from = drones.isEmpty() ? time : from;
                drones.add(drone);
            } else if (drones.remove(drone) && drones.isEmpty()) {
                closed.add(new Interval(from, time));
            }
        }

        List<Interval> until(double end) {
            List<Interval> all = new ArrayList<>(closed);
            if (!drones.isEmpty()) {
                all.add(new Interval(from, end));
            }
            return all;
        }
    }
}
