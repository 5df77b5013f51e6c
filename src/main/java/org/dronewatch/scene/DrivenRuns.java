package org.dronewatch.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.Supplier;
import org.dronewatch.parallel.Interrupts;
import org.dronewatch.run.ModelCache;
import org.dronewatch.run.RunControl;
import org.dronewatch.run.RunInfo;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.RunSession;
import org.dronewatch.run.SceneListener;

/**
 * The runs of a scene, one after the other on the caller's thread, driven by the scene's own simulator.
 *
 * @param scene the scene to run
 * @param simulator the scene's own simulator
 * @param models where models come from
 * @param listeners are notified of each run
 * @param pilots gives the pilot of each run
 * @param control of each run, which ends no later than its settings state
 */
record DrivenRuns(
        Scene scene,
        SceneSimulator simulator,
        ModelCache models,
        List<SceneListener> listeners,
        Supplier<Pilot> pilots,
        RunControl control) {

    /**
     * Runs them.
     *
     * @return a result for each, up to the one that was cut short
     * @throws CancellationException when the thread is interrupted, unless the runs are cancelled as well
     */
    List<RunResult> run(List<RunInfo> infos) {
        List<RunResult> results = new ArrayList<>();
        for (RunInfo info : infos) {
            results.add(run(info));
            if (isCancelled()) {
                break;
            }
        }
        return results;
    }

    private RunResult run(RunInfo info) {
        double until = Math.min(control.until(), info.settings().run().duration());
        try (RunSession session =
                new RunSession(info, info.settings().run().seed(), models, control.withUntil(until))) {
            listeners.forEach(session::listen);
            simulate(session, until);
            return session.result();
        } catch (CancellationException e) {
            if (isCancelled()) {
                return RunResult.notBegun(info);
            }
            throw e;
        }
    }

    private boolean isCancelled() {
        return control.cancelled().getAsBoolean();
    }

    /** Runs to the end, or until the run is cancelled: an interrupt then only brings that about sooner. */
    private void simulate(RunSession session, double until) {
        try {
            Interrupts.surfacing(() -> {
                simulator.run(scene, new SceneReplication(scene.name(), until), session, pilots.get());
                return null;
            });
        } catch (CancellationException e) {
            if (!isCancelled()) {
                throw e;
            }
        } finally {
            scene.forgetSession();
        }
    }
}
