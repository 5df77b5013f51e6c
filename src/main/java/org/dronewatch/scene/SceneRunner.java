package org.dronewatch.scene;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.dronewatch.fusion.ProtectedArea;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Interrupts;
import org.dronewatch.parallel.Workers;
import org.dronewatch.run.Frame;
import org.dronewatch.run.RunControl;
import org.dronewatch.run.RunInfo;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.SceneListener;
import org.dronewatch.run.SceneResult;
import org.dronewatch.run.Stage;
import org.dronewatch.run.Timing;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.run.store.StorePlace;
import org.dronewatch.run.time.LookTimes;
import org.dronewatch.run.time.Pace;
import org.dronewatch.scenario.InputFiles;
import org.dronewatch.scenario.PlaceForms;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.FormerNames;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.file.Kinds;
import org.dronewatch.world.Places;
import org.dronewatch.world.World;

/**
 * Runs a scene on the caller's thread: once, or once for each value of its sweep. The results depend only on the scene,
 * its settings and the seed, not on threads or pace. A runner completes {@link #run} only once, and is used by one
 * thread.
 */
public final class SceneRunner {
    private static final double NANO = 1e-9;
    private static final Consumer<String> NOBODY = note -> {};

    private final Scene scene;
    private final ConfiguredScene configured;
    private final List<SceneListener> listeners = new ArrayList<>();
    private int threads = Runtime.getRuntime().availableProcessors();
    private Pace pace = Pace.AS_FAST_AS_POSSIBLE;
    private BooleanSupplier cancelled = () -> false;
    private Consumer<String> notes = NOBODY;
    private Pilots pilots;
    private final Set<FormerNames.Renamed> renamed = new HashSet<>();
    private SceneModels models;
    private Optional<InputFiles> inputs = Optional.empty();
    private OptionalInt only = OptionalInt.empty();
    private double until = Double.POSITIVE_INFINITY;

    /** A runner of a scene with its own simulator. */
    public SceneRunner(Scene scene) {
        this.scene = scene;
        this.configured = new ConfiguredScene(scene);
        this.pilots = new Pilots(scene::pilot);
    }

    /** Overrides a setting, by its current or a former name; overriding the swept setting removes the sweep. */
    public SceneRunner set(String path, String value) {
        configured.set(path, value);
        return this;
    }

    /** Overrides the seed. */
    public SceneRunner seed(long seed) {
        return set("run.seed", Long.toString(seed));
    }

    /**
     * Sets the number of worker threads used to evaluate the sensors.
     *
     * @throws IllegalArgumentException when {@code number} is below 1 or above 1024
     */
    public SceneRunner threads(int number) {
        if (number < 1 || number > Workers.MAX_THREADS) {
            throw new IllegalArgumentException("threads " + number + " must be 1 to " + Workers.MAX_THREADS);
        }
        this.threads = number;
        return this;
    }

    /**
     * Sets the directory against which relative model paths are resolved, and which contains the user's catalogue
     * files; the scene's directory unless set.
     */
    public SceneRunner directory(Path path) {
        configured.directory(path);
        return this;
    }

    /**
     * Sets where prepared sites are kept, which never changes results; in the {@link StorePlace#ofProcess store of this
     * process} unless set. To be called before anything is loaded.
     */
    public SceneRunner store(StorePlace place) {
        configured.store(place);
        return this;
    }

    /** Where prepared sites are kept. */
    public StorePlace store() {
        return configured.store();
    }

    /** Sets the pace; as fast as possible unless set. */
    public SceneRunner pace(Pace newPace) {
        this.pace = newPace;
        return this;
    }

    /**
     * Sets the pilot that steers the drones whose flight is {@code steered}, instead of the scene's own.
     *
     * @param source returns a new pilot for each run
     */
    public SceneRunner pilot(Supplier<Pilot> source) {
        this.pilots = new Pilots(source);
        return this;
    }

    /** Adds a listener. */
    public SceneRunner listener(SceneListener listener) {
        listeners.add(listener);
        return this;
    }

    /** Sets a receiver of frames: the drones and observations at each time at which sensors look. */
    public SceneRunner onFrame(Consumer<Frame> target) {
        return listener(new SceneListener() {
            @Override
            public void observed(Frame frame) {
                target.accept(frame);
            }
        });
    }

    /**
     * Sets a condition that ends the run. It is queried before each look; once it is true, the run ends with the
     * results so far. If the running thread is interrupted as well, loading or a long look also ends early.
     */
    public SceneRunner cancelWhen(BooleanSupplier condition) {
        this.cancelled = condition;
        return this;
    }

    /**
     * Runs only one of the scene's runs, with the same random numbers as in the whole sweep.
     *
     * @param run index of the run in the sweep, from 0; checked by {@link #run()}
     */
    public SceneRunner only(int run) {
        this.only = OptionalInt.of(run);
        return this;
    }

    /**
     * Ends each run after the looks at this time; up to then, the results are those of the whole run.
     *
     * @param seconds simulated time since the start of the run, 0 or more; beyond the duration it changes nothing
     * @throws IllegalArgumentException when {@code seconds} is negative or not a number
     */
    public SceneRunner until(double seconds) {
        if (!(seconds >= 0.0)) {
            throw new IllegalArgumentException("a run until " + seconds + " s: the time must be 0 s or later");
        }
        this.until = seconds;
        return this;
    }

    /**
     * Sets a receiver of messages: one line for each file read, each warning, and each setting given under a former
     * name. Names that come from files are shortened, and their control characters escaped, so that a line can safely
     * be printed to a terminal.
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
        SceneSettings settings = configured.settings();
        warnOfFormerNames();
        return settings;
    }

    /** Warns once for each name, as soon as a receiver of notes is set. */
    private void warnOfFormerNames() {
        if (notes != NOBODY) {
            configured.formerNames().forEach((setting, line) -> {
                if (renamed.add(setting)) {
                    notes.accept("warning: " + line);
                }
            });
        }
    }

    /** The settings of each run, in order, with all overrides and the sweep's values. */
    public List<SceneSettings> settingsOfRuns() {
        return configured.settingsOfRuns(settings());
    }

    /**
     * The text of a scene file with these settings, which gives the same results.
     *
     * @param settings settings of the scene, or of one of its runs
     * @param file file that is to hold the text; models must be in its directory or below it
     * @throws InputException when a setting cannot be written
     */
    public String text(SceneSettings settings, Path file) {
        return configured.text(settings, file);
    }

    /**
     * The input of the most recent run, with the models loaded so far; before any run, that of the scene as it is now.
     */
    public InputFiles inputs() {
        InputFiles known = inputs.orElseGet(() -> configured.inputs(settings()));
        return known.withModels(models().cache().files());
    }

    /**
     * The settings with one value changed, as a sweep does. The value of a sensor may be the name of a sensor in the
     * catalogue, which replaces it, but not the name of a system of sensors.
     *
     * @param settings settings of the scene, or of one of its runs
     * @throws InputException when the path leads nowhere or the value does not fit
     */
    public SceneSettings write(SceneSettings settings, String path, String value) {
        return configured.write(settings, path, value);
    }

    /**
     * Shares the models of another runner of a scene in the same directory: what that runner has loaded is not loaded
     * again. Only that runner's receiver of notes gets the lines about the models.
     */
    public SceneRunner share(ModelCache loaded) {
        models = new SceneModels(configured, loaded);
        return this;
    }

    /**
     * Loads the models of one of the scene's runs, for runs by {@link org.dronewatch.run.RunSession}.
     *
     * @return all models loaded so far, for use by any number of threads
     * @throws CancellationException when the thread is interrupted; its interrupt status is kept
     * @throws InputException when a model is invalid
     */
    public ModelCache load(SceneSettings settings) {
        return Interrupts.surfacing(() -> {
            models().load(settings);
            return models().cache();
        });
    }

    private SceneModels models() {
        if (models == null) {
            models = new SceneModels(configured, notes);
        }
        return models;
    }

    /**
     * Warns, once, of weather and light in the settings that no sensor of the scene takes into account, and of
     * implausible settings of sensors; a run gives these warnings without being asked. A picture of the site shows
     * weather and light in any case.
     */
    public void adviseOnConditions() {
        models().adviseOnConditions();
    }

    /**
     * Loads the models and creates the stage of one of the scene's runs, without running it.
     *
     * @param settings one of {@link #settingsOfRuns()}
     * @throws CancellationException when the thread is interrupted; its interrupt status is kept
     * @throws InputException when a model is invalid
     */
    public Stage stage(SceneSettings settings) {
        return Interrupts.surfacing(() -> {
            models().load(settings);
            return new Stage(settings, models().cache(), settings.run().seed());
        });
    }

    /**
     * Loads the site of one of the scene's runs, without its drones.
     *
     * @param settings one of {@link #settingsOfRuns()}
     * @throws CancellationException when the thread is interrupted; its interrupt status is kept
     * @throws InputException when a file is invalid
     */
    public World world(SceneSettings settings) {
        return Interrupts.surfacing(() -> {
            models().loadSite(settings);
            return Stage.worldOf(settings.world(), models().cache());
        });
    }

    /**
     * The position of a place on the site of one of the scene's runs; only what this needs is loaded.
     *
     * @param option name of the option in messages, such as {@code --from}
     * @param text the place as in a scene file, or latitude and longitude in degrees, separated by a comma
     * @param settings one of {@link #settingsOfRuns()}
     * @throws InputException with a one-line message when the text is not a place, or the place has no position
     */
    public Position place(String option, String text, SceneSettings settings) {
        Places places = new Places(settings.world(), () -> world(settings).newGround());
        return PlaceForms.parse(option, text, places, scene.directory().toAbsolutePath(), scene.maps());
    }

    /**
     * An area in plan view on the site of one of the scene's runs, as in a scene file. Arguments as for {@link #place}.
     *
     * @throws InputException with a one-line message when the text is not an area, or the area has no position
     */
    public ProtectedArea area(String option, String text, SceneSettings settings) {
        Places places = new Places(settings.world(), () -> world(settings).newGround());
        return PlaceForms.area(option, text, places, scene.directory().toAbsolutePath(), scene.maps());
    }

    /**
     * The given kinds, extended by the notations in which the scene's file may state positions on the site of one of
     * its runs, such as latitude and longitude.
     *
     * @param kinds the kinds without these notations
     * @param settings one of {@link #settingsOfRuns()}
     */
    public Kinds kinds(Kinds kinds, SceneSettings settings) {
        Places places = new Places(settings.world(), () -> world(settings).newGround());
        return PlaceForms.in(kinds, () -> Optional.of(places), scene.maps());
    }

    /**
     * Runs the scene. An {@link Error} thrown by the scene or a sensor is passed on unchanged. After a run that failed
     * or was interrupted, this runner can run again.
     *
     * @throws CancellationException when the thread is interrupted, before or during the run; its interrupt status is
     *     kept
     * @throws InputException when an override or a model is invalid, or a drone is steered and there is no pilot
     * @throws IllegalArgumentException when the scene has no run with the index given to {@link #only}
     * @throws IllegalStateException when the scene was created for another simulator
     */
    public SceneResult run() {
        return Interrupts.surfacing(this::runAll);
    }

    private SceneResult runAll() {
        if (!(scene.getSimulator() instanceof SceneSimulator simulator)) {
            throw new IllegalStateException("this scene was made for another simulator: start that one");
        }
        SceneSettings settings = settings();
        inputs = Optional.of(configured.inputs(settings));
        List<SceneSettings> all = configured.settingsOfRuns(settings);
        List<RunInfo> runs = RunInfo.of(all, only);
        runs.forEach(info -> checkPilot(info.settings()));
        adviseOnConditions();
        double before = models().seconds();
        LookTimes times = new LookTimes();
        long start = System.nanoTime();
        all.forEach(models()::load);
        RunControl control = new RunControl(until, pace, cancelled, times);
        DrivenRuns driven =
                new DrivenRuns(scene, simulator, models().cache(), List.copyOf(listeners), pilots, notes, control);
        List<RunResult> results;
        try (Workers workers = new Workers(threads)) {
            results = workers.call(() -> driven.run(runs));
        }
        double wall = NANO * (System.nanoTime() - start) - (models().seconds() - before);
        ModelCache cache = models().cache();
        Timing timing = new Timing(cache.loadSeconds(), cache.buildSeconds(), wall, times.seconds());
        boolean complete = !cancelled.getAsBoolean()
                && results.stream()
                        .allMatch(run -> until >= run.settings().run().duration());
        return new SceneResult(scene.name(), settings.run().seed(), threads, complete, results, timing);
    }

    /**
     * Checks that there is a pilot if a drone is steered in one of {@link #settingsOfRuns()}; nothing is loaded.
     *
     * @throws InputException when a drone is steered and there is no pilot
     */
    public void checkPilot(SceneSettings settings) {
        if (pilots.get() == Pilot.NONE) {
            configured.checkUnpiloted(settings);
        }
    }
}
