package org.dronewatch.viewer.run;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.render.RunHistory;
import org.dronewatch.run.DetectionEvent;
import org.dronewatch.run.Frame;
import org.dronewatch.run.RunInfo;
import org.dronewatch.run.Stage;
import org.dronewatch.sensor.Observation;

/**
 * One run, as far as it has been simulated. Times are in seconds since the start of the run. Written by the thread that
 * simulates, read by any.
 */
public final class RecordedRun {
    private final RunInfo info;
    private final Stage stage;
    private final Map<List<String>, Readings> readings = new HashMap<>();
    private final RunHistory history = new RunHistory();
    private final List<DetectionEvent> events = new ArrayList<>();
    private double reached;
    private boolean finished;

    public RecordedRun(RunInfo info, Stage stage) {
        this.info = info;
        this.stage = stage;
    }

    synchronized void add(Frame frame) {
        for (Observation observation : frame.ofDrones()) {
            readings.computeIfAbsent(List.of(observation.sensor(), observation.drone()), pair -> new Readings())
                    .add(observation);
        }
        history.observed(frame);
        reached = frame.time();
    }

    synchronized void add(DetectionEvent event) {
        events.add(event);
        history.detectionChanged(event);
    }

    synchronized void finish() {
        finished = true;
        reached = info.settings().run().duration();
    }

    public RunInfo info() {
        return info;
    }

    /** Its site. */
    Stage stage() {
        return stage;
    }

    /** The duration of the run, s. */
    public double duration() {
        return info.settings().run().duration();
    }

    /** The time up to which the run has been simulated, s. */
    public synchronized double reached() {
        return reached;
    }

    /** Whether all of the run has been simulated. */
    public synchronized boolean isFinished() {
        return finished;
    }

    /** The detections gained and lost, from an index on, in order of time. */
    public synchronized List<DetectionEvent> eventsFrom(int number) {
        return number >= events.size() ? List.of() : List.copyOf(events.subList(number, events.size()));
    }

    /** A sensor's last measurement of a drone up to a time; empty if there is none. */
    public synchronized Optional<PairReading> reading(String sensor, String drone, double time) {
        Readings known = readings.get(List.of(sensor, drone));
        return known == null ? Optional.empty() : known.at(time);
    }

    /** Where the positioner of a sensor points at a time; empty for a fixed sensor. */
    public synchronized Optional<Pointing> pointing(String sensor, double time) {
        return history.pointing(sensor, time);
    }

    /** Whether a sensor detects a drone at a time. */
    public synchronized boolean isDetected(String sensor, String drone, double time) {
        return history.isDetected(sensor, drone, time);
    }
}
