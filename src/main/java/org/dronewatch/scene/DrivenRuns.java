package org.dronewatch.scene;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.dronewatch.parallel.Interrupts;
import org.dronewatch.run.RunControl;
import org.dronewatch.run.RunInfo;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.RunSession;
import org.dronewatch.run.SceneListener;
import org.dronewatch.run.model.ModelCache;

/**
 * The runs of a scene, one after the other on the caller's thread, driven by the scene's own simulator.
 *
 * @param scene the scene to run
 * @param simulator the scene's own simulator
 * @param models source of the models
 * @param listeners are notified of each run
 * @param pilots returns the pilot of each run
 * @param notes receives warnings about what pilots do
 * @param control control of each run; a run ends no later than its settings state
 */
record DrivenRuns(
        Scene scene,
        SceneSimulator simulator,
        ModelCache models,
        List<SceneListener> listeners,
        Supplier<Pilot> pilots,
        Consumer<String> notes,
        RunControl control) {

    /**
     * Runs the scene once for each of the given runs.
     *
     * @return a result for each, up to the one that was cut short
     * @throws CancellationException when the thread is interrupted, unless the runs are cancelled as well
     */
    List<RunResult> run(List<RunInfo> infos) {
        List<RunResult> results = new ArrayList<>();
        // The pilots of a sweep mostly do the same in each run.
        Set<String> said = new HashSet<>();
        for (RunInfo info : infos) {
            results.add(run(info, note -> once(note, said)));
            if (isCancelled()) {
                break;
            }
        }
        return results;
    }

    private void once(String note, Set<String> said) {
        if (said.add(note)) {
            notes.accept(note);
        }
    }

    private RunResult run(RunInfo info, Consumer<String> warnings) {
        double until = Math.min(control.until(), info.settings().run().duration());
        try (RunSession session =
                new RunSession(info, info.settings().run().seed(), models, control.withUntil(until))) {
            listeners.forEach(session::listen);
            simulate(session, until, warnings);
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

    /** Runs to the end, or until the run is cancelled; an interrupt then merely ends it sooner. */
    private void simulate(RunSession session, double until, Consumer<String> warnings) {
        try {
            Interrupts.surfacing(() -> {
                simulator.run(scene, new SceneReplication(scene.name(), until), session, pilots.get(), warnings);
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
