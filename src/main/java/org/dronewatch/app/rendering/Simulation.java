package org.dronewatch.app.rendering;

import java.util.function.BooleanSupplier;
import org.dronewatch.app.console.Progress;
import org.dronewatch.flight.Steered;
import org.dronewatch.render.RunHistory;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;

/** Simulates as much of one run of a scene as pictures of the run require, with a progress bar. */
public final class Simulation {
    private final Scene scene;
    private final SceneRunner runner;
    private final int run;
    private final int threads;
    private final boolean bars;

    /**
     * A simulation that has not begun.
     *
     * @param runner runner with the overrides and the seed of the run
     * @param run index of the run in a sweep
     * @param bars whether progress is shown
     */
    public Simulation(Scene scene, SceneRunner runner, int run, int threads, boolean bars) {
        this.scene = scene;
        this.runner = runner;
        this.run = run;
        this.threads = threads;
        this.bars = bars;
    }

    /** Whether progress is shown. */
    boolean hasBars() {
        return bars;
    }

    /**
     * The site of the run: the one that was simulated or, if nothing was simulated, one made for the pictures.
     *
     * @param history history of the run
     * @param settings settings of the run
     */
    Stage stage(RunHistory history, SceneSettings settings) {
        return history.stage().orElseGet(() -> runner.stage(settings));
    }

    /** Whether any drone is steered, so that its position is known only once the run is simulated. */
    static boolean isSteered(SceneSettings settings) {
        return settings.drones().values().stream().anyMatch(drone -> drone.flight() instanceof Steered);
    }

    /**
     * Simulates the run from its start.
     *
     * @param until time of the last looks, s
     * @param cancelled queried before each look: once it is true, the rest is left out
     */
    RunHistory until(double until, BooleanSupplier cancelled) {
        RunHistory history = new RunHistory();
        try (Progress progress = new Progress("simulating " + scene.name(), run, until)) {
            runner.only(run).until(until).threads(threads).cancelWhen(cancelled).listener(history);
            if (bars) {
                runner.listener(progress);
            }
            runner.run();
        }
        return history;
    }
}
