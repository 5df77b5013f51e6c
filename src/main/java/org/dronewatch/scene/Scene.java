package org.dronewatch.scene;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import java.util.function.Function;
import nl.tudelft.simulation.dsol.experiment.ExperimentReplication;
import nl.tudelft.simulation.dsol.formalisms.eventscheduling.SimEventInterface;
import nl.tudelft.simulation.dsol.model.AbstractDsolModel;
import nl.tudelft.simulation.dsol.simulators.DevsSimulatorInterface;
import org.djutils.event.EventType;
import org.djutils.metadata.MetaData;
import org.djutils.metadata.ObjectDescriptor;
import org.dronewatch.buildings.BuildingSettings;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.geo.Origin;
import org.dronewatch.geo.features.Features;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.run.RunControl;
import org.dronewatch.run.RunInfo;
import org.dronewatch.run.RunSession;
import org.dronewatch.run.SceneResult;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.run.store.StorePlace;
import org.dronewatch.scenario.PriceSettings;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.scenario.SceneBuilder;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scenario.SweepAxis;
import org.dronewatch.scenario.SweepSettings;
import org.dronewatch.sensor.Draws;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.FormerNames;
import org.dronewatch.setting.input.FileHash;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.terrain.TerrainSettings;
import org.dronewatch.world.Light;

/**
 * A site, the drones that fly over it and the sensors that watch it. To describe one, extend this class and override
 * {@link #build()}, in which {@code load...} names models and {@code add} adds drones and sensors; nothing is loaded or
 * created there. {@link #run()} runs it on the calling thread; {@link SceneRunner} runs it with other settings, threads
 * or pace.
 *
 * <p>A scene is a DSOL model: with your own DSOL simulator, it runs alongside other DSOL models and in DSOL
 * experiments, whose replications each have their own seed. It then fires {@link #OBSERVATION} to its listeners. Sweeps
 * are run by {@link SceneRunner}; under another simulator the scene runs with its settings as they are. Drones whose
 * flight is {@code steered} are steered by the scene's {@link #pilot()}, or by another model through {@link #drone}.
 */
public abstract class Scene extends AbstractDsolModel<Double, DevsSimulatorInterface<Double>> {
    /** Fired when one sensor has looked at one drone, with the {@link Observation}. */
    public static final EventType OBSERVATION = new EventType(
            "OBSERVATION",
            new MetaData(
                    "OBSERVATION",
                    "a sensor looked at a drone",
                    new ObjectDescriptor("observation", "the measured value", Observation.class)));

    private static final long serialVersionUID = 1L;

    private transient SceneBuilder builder;
    private transient ModelCache models;
    private transient RunSession session;
    private transient RunThread thread;

    /** A scene with its own simulator, for {@link #run()} and {@link SceneRunner}. */
    protected Scene() {
        this(SceneSimulator.create("dronewatch"));
    }

    /** A scene as a model for a DSOL simulator. */
    protected Scene(DevsSimulatorInterface<Double> simulator) {
        super(simulator);
    }

    /** Describes the scene: calls {@code loadWorld}, {@code add}, {@code setRun}. Called once for each description. */
    protected abstract void build();

    /**
     * The scene's name in results: the class's name in lower case with hyphens, {@code camera-range} for {@code
     * CameraRange}.
     */
    public String name() {
        return getClass()
                .getSimpleName()
                .replaceAll("(?<=[a-z0-9])(?=[A-Z])", "-")
                .toLowerCase(Locale.ROOT);
    }

    /**
     * The directory against which relative file names are resolved: the working directory, unless the scene is a file.
     */
    public Path directory() {
        return Path.of("");
    }

    /** The files that describe the scene, as last read; none unless the scene itself is a file. */
    public List<FileHash> files() {
        return List.of();
    }

    /**
     * The range at which, according to a simple analytic model, a sensor should first detect the drone, m; plotted for
     * comparison with the results of a sweep. Empty unless overridden.
     *
     * @param settings settings of one run
     * @param sensor name of the sensor
     */
    public OptionalDouble expectedRange(SceneSettings settings, String sensor) {
        return OptionalDouble.empty();
    }

    /** The horizontal axis of the plot of this scene's sweep: the swept setting unless overridden. */
    public Optional<SweepAxis> sweepAxis() {
        return Optional.empty();
    }

    /** Names a model file, with y up and in metres unless changed by the settings' {@code with...} methods. */
    protected final ModelSettings load(String file) {
        return ModelSettings.of(file);
    }

    /** Names a model that is included in the library, such as {@code quadrotor.obj}. */
    protected final ModelSettings loadPackaged(String name) {
        return ModelSettings.packaged(name);
    }

    /** Adds a model, such as a hill, to the world. May be called again, as for a house on that hill. */
    protected final void loadWorld(ModelSettings model) {
        building().addToWorld(model);
    }

    /** Sets the ground of a real place, from elevation files; requires {@link #setOrigin}. */
    protected final void loadTerrain(TerrainSettings terrain) {
        building().setTerrain(terrain);
    }

    /** Sets the buildings of a real place, from a map; requires {@link #setOrigin}. */
    protected final void loadBuildings(BuildingSettings buildings) {
        building().setBuildings(buildings);
    }

    /** Sets the sound pressure level of the background, A-weighted, dB re 20 uPa; 30 dB unless set. */
    protected final void setBackgroundNoise(double level) {
        setBackgroundNoise(BackgroundNoise.of(level));
    }

    /** Sets level and spectrum of the background, as in {@code BackgroundNoise.of(BandLevels.of(45, 41, ...))}. */
    protected final void setBackgroundNoise(BackgroundNoise noise) {
        building().setBackgroundNoise(noise);
    }

    /** Sets temperature, humidity and pressure of the air; 20 degrees Celsius, 70 % and one atmosphere unless set. */
    protected final void setAtmosphere(Atmosphere air) {
        building().setAtmosphere(air);
    }

    /** Sets the rain rate, mm/h; 0 unless set. */
    protected final void setRain(double millimetresPerHour) {
        building().setRain(millimetresPerHour);
    }

    /** Sets visibility and daylight; a day of good visibility under high cloud unless set. */
    protected final void setLight(Light light) {
        building().setLight(light);
    }

    /** Sets the geographic position of the scene's origin; unknown unless set. If it is set, a run writes maps. */
    protected final void setOrigin(Origin origin) {
        building().setOrigin(origin);
    }

    /**
     * Assigns an acoustic surface to a material of the models.
     *
     * @param material name in the model's MTL file
     * @param surface name of a surface of the library, such as {@code brick_rough}
     */
    protected final void surface(String material, String surface) {
        building().nameSurface(material, surface);
    }

    /** Adds a drone. */
    protected final void add(String id, DroneSettings drone) {
        building().addDrone(id, drone);
    }

    /** Adds a sensor of any kind. */
    protected final void add(String id, SensorSettings<?> sensor) {
        building().addSensor(id, sensor);
    }

    /**
     * Switches a sensor off, as {@code enabled: false} does in a scene file: it stays in the scene, observes nothing
     * and costs nothing. {@code --set sensors.ID.enabled=true} switches it on again.
     *
     * @param sensor id of a sensor, added before or after this call
     */
    protected final void disable(String sensor) {
        building().disableSensor(sensor);
    }

    /**
     * Sets when an alert is raised, and what is to be protected. Unless set, any detection by any sensor is an alert.
     */
    protected final void setAlert(AlertSettings alert) {
        building().setAlert(alert);
    }

    /** Sets the prices of the sensors, for the report. */
    protected final void setPrices(PriceSettings prices) {
        building().setPrices(prices);
    }

    /** Sets duration and seed of a run. */
    protected final void setRun(RunSettings run) {
        building().setRun(run);
    }

    /**
     * Sweeps a setting over values, with one run for each.
     *
     * @param parameter path of the setting, such as {@code sensors.camera.fov}
     * @param values numbers in the setting's unit
     */
    protected final void sweep(String parameter, double... values) {
        List<String> texts = Arrays.stream(values).mapToObj(Double::toString).toList();
        building().setSweep(new SweepSettings.Values(parameter, texts));
    }

    /** Uses settings that are already complete. */
    final void set(SceneSettings settings) {
        building().setAll(settings);
    }

    private SceneBuilder building() {
        if (builder == null) {
            throw new IllegalStateException("a scene is described in its build() method only");
        }
        return builder;
    }

    /** The settings that {@link #build()} describes, before any override. */
    public final SceneSettings describe() {
        builder = new SceneBuilder();
        try {
            build();
            return builder.toSettings();
        } finally {
            builder = null;
        }
    }

    /**
     * The location of the setting that a message refers to.
     *
     * @param path path of the setting
     * @return file, line and column, as {@code site.yaml:3:12}; empty for a scene in Java
     */
    Optional<String> placeOf(String path) {
        return Optional.empty();
    }

    /** The settings given under a former name in the files in which the scene is described. */
    FormerNames formerNames() {
        return new FormerNames();
    }

    /**
     * Hands over, before the scene is described, what will change it: positions of places depend on the site.
     *
     * @param overrides values by path
     * @param names directory of relative file names
     * @param store where prepared sites are kept
     */
    void prepare(Map<String, String> overrides, Path names, StorePlace store) {}

    /** The maps to which the scene may refer: none unless the scene itself is a file. */
    Function<Optional<String>, Features> maps() {
        return file -> {
            throw new IllegalArgumentException("only a scene file has a map next to it");
        };
    }

    /** The models of the scene's runs, some of which may have been loaded when it was described. */
    ModelCache models(Path names, StorePlace store, Consumer<String> notes) {
        return new ModelCache(names, store, notes);
    }

    /**
     * Runs the scene to its end on this thread, as fast as possible, with as many worker threads as there are cores.
     */
    public final SceneResult run() {
        return new SceneRunner(this).run();
    }

    /**
     * Creates the pilot that steers the drones whose flight is {@code steered}: a new one for each call, since each run
     * has its own. No drone is steered unless this is overridden.
     */
    protected Pilot pilot() {
        return Pilot.NONE;
    }

    /**
     * A drone of the current run, at the simulator's time: for DSOL models that use this scene.
     *
     * @param id name of the drone in the scene
     * @throws org.dronewatch.setting.InputException when the scene has no such drone
     * @throws IllegalStateException when the scene is not running
     */
    public final DroneInFlight drone(String id) {
        return running("drone '" + id + "' does not fly").drone(id);
    }

    /**
     * Writes the flights of all drones so far in the current run, in the format of {@code flights.csv}: for DSOL models
     * that use this scene. Flights of the kind {@code recorded} repeat them.
     *
     * @param file the file to be written; an existing file is replaced
     * @throws org.dronewatch.setting.InputException when the file cannot be written
     * @throws IllegalStateException when the scene is not running
     */
    public final void writeFlights(Path file) {
        running("no flights to write").writeFlights(file);
    }

    private PilotedRun running(String complaint) {
        if (session == null) {
            throw new IllegalStateException(complaint + ": the scene is not running");
        }
        return new PilotedRun(session, getSimulator(), getClass());
    }

    /** Opens a run, lets its pilot begin and schedules its first look; DSOL calls this for each replication. */
    @Override
    public final void constructModel() {
        Optional<SceneSimulator> own =
                getSimulator() instanceof SceneSimulator simulator ? Optional.of(simulator) : Optional.empty();
        session = own.flatMap(SceneSimulator::session).orElseGet(this::openSession);
        Pilot steering = own.flatMap(SceneSimulator::pilot).orElseGet(this::pilot);
        PilotedRun run = new PilotedRun(session, getSimulator(), steering.getClass());
        if (thread == null) {
            thread = new RunThread(() -> Optional.ofNullable(session).map(RunSession::stage));
        }
        thread.begin(getSimulator());
        run.begin(steering::begin).ifPresent(warning -> own.ifPresent(simulator -> simulator.warn(warning)));
        scheduleNextLook();
    }

    /**
     * A run under the user's own simulator, which determines how long it lasts. All replications have the same
     * settings.
     */
    private RunSession openSession() {
        RunInfo info = session == null ? new RunInfo(0, 1, describe().withoutSweep()) : session.info();
        if (models == null) {
            models = models(directory(), StorePlace.ofProcess(), note -> {});
        }
        if (session != null) {
            session.close();
        }
        int replication = getSimulator().getReplication() instanceof ExperimentReplication<?, ?> numbered
                ? numbered.getReplicationNr()
                : 0;
        long seed = Draws.derivedSeed(info.settings().run().seed(), "replication", replication);
        return new RunSession(info, seed, models, RunControl.until(Double.POSITIVE_INFINITY));
    }

    /** Releases the last run, which its owner closes. */
    final void forgetSession() {
        session = null;
    }

    /** Looks have the lowest priority: what other models do at the same time comes before. */
    private void scheduleNextLook() {
        OptionalDouble next = session.nextTime();
        if (next.isPresent()) {
            double time = getSimulator().getReplication().getStartTime() + next.getAsDouble();
            if (time <= getSimulator().getReplication().getEndTime()) {
                getSimulator().scheduleEventAbs(time, SimEventInterface.MIN_PRIORITY, this::look);
            }
        }
    }

    private void look() {
        if (getSimulator() instanceof SceneSimulator own) {
            own.look(this::observe);
        } else {
            observe();
        }
    }

    private void observe() {
        if (session.nextTime().isPresent()) {
            double now = getSimulator().getSimulatorTime();
            for (Observation observation : session.advance().observations()) {
                fireTimedEvent(OBSERVATION, observation, now);
            }
            scheduleNextLook();
        }
    }
}
