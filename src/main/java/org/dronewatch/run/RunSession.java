package org.dronewatch.run;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.drone.Drone;
import org.dronewatch.parallel.Workers;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Observation;

/**
 * One run of a scene, look by look. The result depends only on settings, seed and models, not on the code that drives
 * the run, the pace, the number of threads, or listeners. For use by one thread; sensors look on the {@link Workers} of
 * that thread.
 *
 * <pre>{@code
 * try (RunSession session = new RunSession(settings, seed, models)) {
 *     while (session.nextTime().isPresent()) {
 *         session.advance();
 *     }
 *     return session.result();
 * }
 * }</pre>
 *
 * <p>Steered drones are commanded between the looks: {@code SteeredFlight.in(session.stage().flight("hunter"))} takes
 * commands with their times. The thread that drives the run gives them; without commands such a drone hovers.
 */
public final class RunSession implements AutoCloseable {
    private final RunInfo info;
    private final RunControl control;
    private final Stage stage;
    private final DetectionLog log;
    private final AlertWatch alerts;
    private final List<SceneListener> listeners = new ArrayList<>();
    private double reached;
    private boolean closed;
    private Optional<RunResult> result = Optional.empty();

    /**
     * Opens a run with the duration in its settings: builds the world, creates drones and sensors.
     *
     * @param settings settings of the run; their sweep is ignored
     * @param seed seed of all random numbers, instead of that of the settings
     * @param models source of the models
     * @throws org.dronewatch.setting.InputException when a model is invalid, or does not fit the rest of the settings
     */
    public RunSession(SceneSettings settings, long seed, ModelCache models) {
        this(
                new RunInfo(0, 1, settings),
                seed,
                models,
                RunControl.until(settings.run().duration()));
    }

    /**
     * Opens one run of several.
     *
     * @param info number and settings of the run
     * @param seed seed of all random numbers, instead of that of the settings
     * @param models source of the models
     * @param control when the run ends, and how it is driven
     * @throws org.dronewatch.setting.InputException when a model is invalid, or does not fit the rest of the settings
     */
    public RunSession(RunInfo info, long seed, ModelCache models, RunControl control) {
        this.info = info;
        this.control = control;
        this.stage = new Stage(info.settings(), models, seed);
        this.log = new DetectionLog(info.run(), info.settings(), this::detectionChanged);
        this.alerts = new AlertWatch(info.run(), info.settings(), stage);
    }

    private void detectionChanged(DetectionEvent event) {
        alerts.add(event);
        listeners.forEach(listener -> listener.detectionChanged(event));
    }

    /**
     * Runs a scene to its end, as fast as possible.
     *
     * @param settings settings of the run; their sweep is ignored
     * @param seed seed of all random numbers, instead of that of the settings
     * @param models source of the models
     * @throws org.dronewatch.setting.InputException when a model is invalid, or does not fit the rest of the settings
     */
    public static RunResult run(SceneSettings settings, long seed, ModelCache models) {
        try (RunSession session = new RunSession(settings, seed, models)) {
            while (session.nextTime().isPresent()) {
                session.advance();
            }
            return session.result();
        }
    }

    /**
     * Adds a listener and notifies it that the run has started; the looks that follow are reported on the thread of the
     * run.
     */
    public void listen(SceneListener listener) {
        listeners.add(listener);
        listener.runStarted(info, stage);
    }

    /** The run's number and settings. */
    public RunInfo info() {
        return info;
    }

    /** The run's world, drones and sensors. */
    public Stage stage() {
        return stage;
    }

    /**
     * The time at which the next sensors look, seconds since the start of the run; empty when the run has ended or is
     * cancelled.
     */
    public OptionalDouble nextTime() {
        double next = stage.nextLook();
        boolean over = isEnded() || isPastEnd(next) || control.cancelled().getAsBoolean();
        return over ? OptionalDouble.empty() : OptionalDouble.of(next);
    }

    /** The time at which sensors last looked, seconds since the start of the run; 0 before the first look. */
    public double reached() {
        return reached;
    }

    private boolean isPastEnd(double next) {
        return next > control.until() || Double.isInfinite(next);
    }

    private boolean isEnded() {
        return closed || result.isPresent();
    }

    /**
     * Runs the next looks that are due, at their time and at the run's pace, and notifies the listeners.
     *
     * @return the drones at that time, and the observations
     * @throws IllegalStateException when there are no more looks
     * @throws java.util.concurrent.CancellationException when the thread is interrupted; its interrupt status is kept
     */
    public Frame advance() {
        double time = stage.nextLook();
        if (isEnded() || isPastEnd(time)) {
            throw new IllegalStateException("run " + info.run() + " has no more looks");
        }
        control.pace().await(time);
        Workers.checkInterrupted();
        stage.flyTo(time);
        List<Drone> drones = stage.dronesAt(time);
        List<Observation> observations = stage.look(time, drones, control.times());
        Frame frame = new Frame(info.run(), time, drones, observations, stage.pointings());
        reached = time;
        alerts.add(frame, stage);
        log.add(observations);
        listeners.forEach(listener -> listener.observed(frame));
        return frame;
    }

    /**
     * Ends the run and returns its result, which extends to the last look if more looks were to come, otherwise to the
     * end of the run. The listeners are notified once.
     *
     * @throws IllegalStateException when the run was closed without a result
     */
    public RunResult result() {
        if (result.isEmpty()) {
            if (closed) {
                throw new IllegalStateException("run " + info.run() + " was closed before it had a result");
            }
            result = Optional.of(summed());
            listeners.forEach(listener -> listener.runEnded(result.get()));
        }
        return result.get();
    }

    private RunResult summed() {
        boolean whole = Double.isFinite(control.until())
                && isPastEnd(stage.nextLook())
                && !control.cancelled().getAsBoolean();
        double simulated = whole ? control.until() : reached;
        stage.flyTo(simulated);
        return new RunResult(
                info.run(),
                info.settings(),
                simulated,
                log.events(),
                log.pairs(),
                alerts.results(stage, simulated),
                alerts.falseAlarms());
    }

    /** Ends the run and releases its sensors. A result that was returned before remains valid. */
    @Override
    public void close() {
        closed = true;
        stage.release();
    }
}
