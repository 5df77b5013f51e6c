package org.dronewatch.render;

import java.util.Optional;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.run.DetectionEvent;
import org.dronewatch.run.DetectionIntervals;
import org.dronewatch.run.Frame;
import org.dronewatch.run.Pointings;
import org.dronewatch.run.RunInfo;
import org.dronewatch.run.SceneListener;
import org.dronewatch.run.Stage;

/**
 * The history of one run for rendering: its site, and the pointings and detections at any time so far. It listens to a
 * single run. Not thread-safe.
 */
public final class RunHistory implements SceneListener {
    private Optional<Stage> stage = Optional.empty();
    private final Pointings pointings = new Pointings();
    private final DetectionIntervals intervals = new DetectionIntervals();

    @Override
    public void runStarted(RunInfo run, Stage itsStage) {
        stage = Optional.of(itsStage);
    }

    /** The site of the run; empty before it has started. */
    public Optional<Stage> stage() {
        return stage;
    }

    @Override
    public void observed(Frame frame) {
        pointings.add(frame);
    }

    @Override
    public void detectionChanged(DetectionEvent event) {
        intervals.add(event);
    }

    /**
     * The pointing of a sensor's positioner at the sensor's last look at or before a time; empty for a sensor on a
     * fixed mount, and before the first look.
     *
     * @param time seconds since the start of the run
     */
    public Optional<Pointing> pointing(String sensor, double time) {
        return pointings.at(sensor, time);
    }

    /**
     * Whether a sensor detects a drone at a time; sound counts from its arrival.
     *
     * @param time seconds since the start of the run
     */
    public boolean isDetected(String sensor, String drone, double time) {
        return intervals.isDetected(sensor, drone, time);
    }
}
