package org.dronewatch.scene;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.parallel.Interrupts;
import org.dronewatch.parallel.Workers;
import org.dronewatch.run.AlertResult;
import org.dronewatch.run.AlertWatch;
import org.dronewatch.run.DetectionLog;
import org.dronewatch.run.Frame;
import org.dronewatch.run.LookTimes;
import org.dronewatch.run.ModelCache;
import org.dronewatch.run.Pace;
import org.dronewatch.run.RunInfo;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.SceneListener;
import org.dronewatch.run.SceneResult;
import org.dronewatch.run.Stage;
import org.dronewatch.run.Timing;
import org.dronewatch.scenario.ConditionAdvice;
import org.dronewatch.scenario.InputFiles;
import org.dronewatch.scenario.Overrides;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scenario.SweepSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
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
    private Catalog catalog;
    private Optional<InputFiles> inputs = Optional.empty();
    private OptionalInt only = OptionalInt.empty();
    private double until = Double.POSITIVE_INFINITY;

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

    /** Sets where relative model paths start, and the user's catalogue files lie; the scene's directory unless set. */
    public SceneRunner directory(Path path) {
        this.directory = path;
        this.catalog = null;
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

    /**
     * Asked before each look: once it is true, the run ends with what it has. Interrupt the running thread as well, and loading
     * or a long look ends early, too.
     */
    public SceneRunner cancelWhen(BooleanSupplier condition) {
        this.cancelled = condition;
        return this;
    }

    /**
     * Runs one of the scene's runs alone, with the random numbers that it has among the others.
     *
     * @param run its index in the sweep, from 0; {@link #run()} checks it
     */
    public SceneRunner only(int run) {
        this.only = OptionalInt.of(run);
        return this;
    }

    /**
     * Ends each run after this time, looks at it included; up to there nothing differs from the whole run.
     *
     * @param seconds simulated time since the start of the run, 0 or more; beyond the duration it changes nothing
     * @throws IllegalArgumentException when negative or not a number
     */
    public SceneRunner until(double seconds) {
        if (!(seconds >= 0.0)) {
            throw new IllegalArgumentException("a run until " + seconds + " s: must be 0 or more");
        }
        this.until = seconds;
        return this;
    }

    /**
     * Is given what was read and what looked odd, a line each. Names in it that come from files are shortened, and their
     * control characters made visible, so that a line can go to a terminal as it is.
     */
    public SceneRunner notes(Consumer<String> target) {
        this.notes = note -> target.accept(PlainText.line(note));
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
            try {
                settings = overrides().write(settings, override.getKey(), override.getValue());
            } catch (InputException e) {
                throw new InputException("--set " + e.getMessage(), e);
            }
            settings = sweptPath ? settings.withoutSweep() : settings;
        }
        settingsOfRuns(settings);
        return settings;
    }

    private Overrides overrides() {
        return new Overrides(catalog());
    }

    private Catalog catalog() {
        if (catalog == null) {
            catalog = Catalog.beside(directory);
        }
        return catalog;
    }

    /** What the last run was made from, with the models that are loaded so far; before any run, the scene as it is now. */
    public InputFiles inputs() {
        InputFiles known = inputs.orElseGet(() -> described(settings()));
        return known.withModels(models().files());
    }

    private InputFiles described(SceneSettings settings) {
        return InputFiles.of(settings).withScene(scene.files(), catalog().filesRead());
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
        List<SceneSettings> runs = new ArrayList<>();
        String here = "sweep.parameter";
        try {
            path.read(settings);
            here = "sweep.from";
            List<String> values = sweep.get().values(path.quantity(settings));
            for (int i = 0; i < values.size(); i++) {
                here = "sweep.values." + i;
                runs.add(overrides().write(settings.asRunWith(i, values.get(i)), path.toString(), values.get(i)));
            }
        } catch (IllegalArgumentException | InputException e) {
            throw new InputException(placed(here) + "sweep of " + path + ": " + e.getMessage(), e);
        }
        return runs;
    }

    /** What a message about a setting begins with: the option that set it or what it is part of, or its line in a file. */
    private String placed(String path) {
        return placed(path, set -> path.equals(set) || path.startsWith(set + "."));
    }

    private String placed(String path, Predicate<String> isBehind) {
        for (Map.Entry<String, String> override : overrides.entrySet()) {
            if (isBehind.test(override.getKey())) {
                return "--set " + override.getKey() + "=" + override.getValue() + ": ";
            }
        }
        return scene.placeOf(path).map(place -> place + ": ").orElse("");
    }

    /** Reads the models of a run, so that what is wrong with one names the setting that asks for it. */
    private void load(SceneSettings settings) {
        List<ModelSettings> world = settings.world().models();
        for (int i = 0; i < world.size(); i++) {
            load("world.models." + i, world.get(i));
        }
        settings.drones().forEach((id, drone) -> load("drones." + id + ".model", drone.model()));
    }

    private void load(String path, ModelSettings model) {
        try {
            models().read(model);
        } catch (InputException e) {
            // What is wrong with a file is not the fault of an override of its scale or position.
            String place = placed(path, set -> set.equals(path) || set.equals(path + ".file"));
            throw new InputException(place + path + ": " + e.getMessage(), e);
        }
    }

    /**
     * Loads the models and creates what one of the scene's runs shows, without running it.
     *
     * @param settings one of {@link #settingsOfRuns()}
     * @throws CancellationException when the thread is interrupted; it stays so
     * @throws InputException when a model is wrong
     */
    public Stage stage(SceneSettings settings) {
        return Interrupts.surfacing(() -> {
            load(settings);
            return new Stage(settings, models(), settings.run().seed());
        });
    }

    /**
     * Runs the scene. An {@link Error} of the scene or of a sensor passes unchanged. After a run that failed or was interrupted
     * this runner can run again.
     *
     * @throws CancellationException when the thread is interrupted, before the run or at any moment of it; it stays so
     * @throws InputException when an override or a model is wrong
     * @throws IllegalArgumentException when the scene has no run of the index given to {@link #only}
     * @throws IllegalStateException when the scene was made for a simulator of the user's
     */
    public SceneResult run() {
        return Interrupts.surfacing(this::runAll);
    }

    private SceneResult runAll() {
        if (!(scene.getSimulator() instanceof SceneSimulator simulator)) {
            throw new IllegalStateException("this scene was made for another simulator: start that one");
        }
        SceneSettings settings = settings();
        inputs = Optional.of(described(settings));
        List<SceneSettings> settingsOfRuns = settingsOfRuns(settings);
        int first = only.orElse(0);
        int end = only.isPresent() ? first + 1 : settingsOfRuns.size();
        if (first < 0 || end > settingsOfRuns.size()) {
            throw new IllegalArgumentException("run " + first + " must be 0 to " + (settingsOfRuns.size() - 1));
        }
        ModelCache loaded = models();
        double before = loaded.loadSeconds() + loaded.buildSeconds();
        List<RunResult> results = new ArrayList<>();
        LookTimes times = new LookTimes();
        boolean complete = true;
        long start = System.nanoTime();
        settingsOfRuns.forEach(this::load);
        try (Workers workers = new Workers(threads)) {
            for (int run = first; run < end && complete; run++) {
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
        complete &=
                results.stream().allMatch(run -> until >= run.settings().run().duration());
        return new SceneResult(scene.name(), settings.run().seed(), threads, complete, results, timing);
    }

    private ModelCache models() {
        if (models == null) {
            models = new ModelCache(directory, notes);
            ConditionAdvice.of(settingsOfRuns()).forEach(models::warn);
        }
        return models;
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
                    log.add(frame.observations());
                    listeners.forEach(listener -> listener.observed(frame));
                },
                pace,
                times,
                cancelled));
        listeners.forEach(listener -> listener.runStarted(info));
        double duration = Math.min(until, info.settings().run().duration());
        simulate(simulator, new SceneReplication(scene.name(), duration));
        double simulated = cancelled.getAsBoolean() ? progress.time : duration;
        Stage stage = scene.stage();
        List<AlertResult> alerts =
                stage == null ? List.of() : progress.alerts(info, stage).results(stage, simulated);
        RunResult result = new RunResult(info.run(), info.settings(), simulated, log.events(), log.pairs(), alerts);
        listeners.forEach(listener -> listener.runEnded(result));
        return result;
    }

    /** Runs to the end, or until the run is cancelled: an interrupt then only brings that about sooner. */
    private void simulate(SceneSimulator simulator, SceneReplication replication) {
        try {
            Interrupts.surfacing(() -> {
                simulator.run(scene, replication);
                return null;
            });
        } catch (CancellationException e) {
            if (!cancelled.getAsBoolean()) {
                throw e;
            }
        }
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
            alerts(info, stage).add(frame, stage);
        }
    }
}
