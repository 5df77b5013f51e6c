package org.dronewatch.scene;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.parallel.Workers;
import org.dronewatch.sensor.Sample;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.SettingsPath;

/**
 * Runs a scene on the caller's thread: once, or once for each value of its sweep. The results depend on the scene, its
 * settings and the seed only, not on threads or pace. One use by one thread.
 */
public final class SceneRunner {
    private static final double NANO = 1e-9;

    private final Scene scene;
    private final Map<String, String> overrides = new LinkedHashMap<>();
    private final List<SceneListener> listeners = new ArrayList<>();
    private int threads = Runtime.getRuntime().availableProcessors();
    private Path directory;
    private Pace pace = Pace.AS_FAST_AS_POSSIBLE;
    private BooleanSupplier cancelled = () -> false;
    private Consumer<String> notes = note -> {};
    private ModelCache models;

    /** A runner of a scene that has a simulator of its own. */
    public SceneRunner(Scene scene) {
        this.scene = scene;
        this.directory = scene.directory();
    }

    /** Overrides a setting; setting what the scene sweeps ends the sweep. */
    public SceneRunner set(String path, String value) {
        overrides.put(path, value);
        return this;
    }

    /** Overrides the seed. */
    public SceneRunner seed(long seed) {
        return set("run.seed", Long.toString(seed));
    }

    /**
     * Sets how many threads let sensors look.
     *
     * @throws IllegalArgumentException when below 1 or above 1024
     */
    public SceneRunner threads(int number) {
        if (number < 1 || number > Workers.MAX_THREADS) {
            throw new IllegalArgumentException("threads " + number + " must be 1 to " + Workers.MAX_THREADS);
        }
        this.threads = number;
        return this;
    }

    /** Sets where relative model paths start, and the user's own sensors lie; the scene's directory unless set. */
    public SceneRunner directory(Path path) {
        this.directory = path;
        return this;
    }

    /** Sets the pace; as fast as possible unless set. */
    public SceneRunner pace(Pace newPace) {
        this.pace = newPace;
        return this;
    }

    /** Adds a listener. */
    public SceneRunner listener(SceneListener listener) {
        listeners.add(listener);
        return this;
    }

    /** Is given each frame: every sampling time with its drones and observations. */
    public SceneRunner onFrame(Consumer<Frame> target) {
        return listener(new SceneListener() {
            @Override
            public void observed(Frame frame) {
                target.accept(frame);
            }
        });
    }

    /** Asked before each look: once it says true, the run ends with what it has. */
    public SceneRunner cancelWhen(BooleanSupplier condition) {
        this.cancelled = condition;
        return this;
    }

    /** Is told in a line each what was read and what looked odd. */
    public SceneRunner notes(Consumer<String> target) {
        this.notes = target;
        return this;
    }

    /**
     * The scene's settings with all overrides, checked; nothing is loaded.
     *
     * @throws InputException when an override does not fit
     */
    public SceneSettings settings() {
        SceneSettings settings = described();
        for (Map.Entry<String, String> override : overrides.entrySet()) {
            boolean sweptPath = settings.sweep()
                    .map(sweep -> sweep.parameter().equals(override.getKey()))
                    .orElse(false);
            settings = overrides().write(settings, override.getKey(), override.getValue());
            settings = sweptPath ? settings.withoutSweep() : settings;
        }
        settingsOfRuns(settings);
        return settings;
    }

    private Overrides overrides() {
        return new Overrides(Catalog.beside(directory));
    }

    private SceneSettings described() {
        try {
            return scene.describe();
        } catch (IllegalArgumentException e) {
            throw new InputException("scene " + scene.name() + ": " + e.getMessage(), e);
        }
    }

    /** The settings of each run, in order, with all overrides and the sweep's values. */
    public List<SceneSettings> settingsOfRuns() {
        return settingsOfRuns(settings());
    }

    /** The settings of each run; reads every value of the sweep, so that the last cannot fail after the first has run. */
    private List<SceneSettings> settingsOfRuns(SceneSettings settings) {
        Optional<SweepSettings> sweep = settings.sweep();
        if (sweep.isEmpty()) {
            return List.of(settings);
        }
        SettingsPath path = new SettingsPath(sweep.get().parameter());
        try {
            return sweep.get().values(path.quantity(settings)).stream()
                    .map(value -> overrides().write(settings.asRunWith(value), path.toString(), value))
                    .toList();
        } catch (IllegalArgumentException e) {
            throw new InputException("sweep of " + path + ": " + e.getMessage(), e);
        }
    }

    /**
     * Loads the models and creates what one of the scene's runs shows, without running it.
     *
     * @param settings one of {@link #settingsOfRuns()}
     * @throws InputException when a model is wrong
     */
    public Stage stage(SceneSettings settings) {
        return new Stage(settings, models(), runSeed(settings, 0, 0));
    }

    /**
     * Runs the scene.
     *
     * @throws InputException when an override or a model is wrong
     * @throws IllegalStateException when the scene was made for a simulator of the user's
     */
    public SceneResult run() {
        if (!(scene.getSimulator() instanceof SceneSimulator simulator)) {
            throw new IllegalStateException("this scene was made for another simulator: start that one");
        }
        SceneSettings settings = settings();
        List<SceneSettings> settingsOfRuns = settingsOfRuns(settings);
        ModelCache loaded = models();
        double before = loaded.loadSeconds() + loaded.buildSeconds();
        List<RunResult> results = new ArrayList<>();
        LookTimes times = new LookTimes();
        boolean complete = true;
        long start = System.nanoTime();
        try (Workers workers = new Workers(threads)) {
            for (int run = 0; run < settingsOfRuns.size() && complete; run++) {
                RunInfo info = new RunInfo(run, settingsOfRuns.size(), settingsOfRuns.get(run));
                results.add(workers.call(() -> runOnce(simulator, info, loaded, times)));
                complete = !cancelled.getAsBoolean();
            }
        } finally {
            scene.prepare(null);
        }
        double all = NANO * (System.nanoTime() - start);
        double wall = all - (loaded.loadSeconds() + loaded.buildSeconds() - before);
        Timing timing = new Timing(loaded.loadSeconds(), loaded.buildSeconds(), wall, times.seconds());
        return new SceneResult(scene.name(), settings.run().seed(), threads, complete, results, timing);
    }

    private ModelCache models() {
        if (models == null) {
            models = new ModelCache(directory, notes);
        }
        return models;
    }

    /** The seed of all random numbers of one run, in one replication of an experiment. */
    static long runSeed(SceneSettings settings, int run, int replication) {
        return Sample.mix(Sample.mix(settings.run().seed(), run), replication);
    }

    private RunResult runOnce(SceneSimulator simulator, RunInfo info, ModelCache models, LookTimes times) {
        DetectionLog log = new DetectionLog(
                info.run(), info.settings(), event -> listeners.forEach(listener -> listener.detectionChanged(event)));
        RunProgress progress = new RunProgress();
        scene.prepare(new RunPlan(
                info,
                models,
                frame -> {
                    progress.add(frame, info, scene.stage());
                    frame.observations().forEach(log::add);
                    listeners.forEach(listener -> listener.observed(frame));
                },
                pace,
                times,
                cancelled));
        listeners.forEach(listener -> listener.runStarted(info));
        double duration = info.settings().run().duration();
        simulator.run(scene, new SceneReplication(scene.name(), duration));
        double simulated = cancelled.getAsBoolean() ? progress.time : duration;
        List<AlertResult> alerts = progress.alerts(info, scene.stage()).results(scene.stage(), simulated);
        return new RunResult(info.run(), info.settings(), simulated, log.events(), log.pairs(), alerts);
    }

    /** When the last frame was, and what alerts there were. The stage is there from the first frame on. */
    private static final class RunProgress {
        private double time;
        private Optional<AlertWatch> watch = Optional.empty();

        AlertWatch alerts(RunInfo info, Stage stage) {
            if (watch.isEmpty()) {
                watch = Optional.of(new AlertWatch(info.run(), info.settings(), stage.world()));
            }
            return watch.get();
        }

        void add(Frame frame, RunInfo info, Stage stage) {
            time = frame.time();
            alerts(info, stage).add(frame);
        }
    }
}
