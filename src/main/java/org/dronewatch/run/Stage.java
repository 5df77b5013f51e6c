package org.dronewatch.run;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.dronewatch.buildings.LoadedBuildings;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.FlightLimits;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.flight.SteeredFlight;
import org.dronewatch.flight.SteeringClock;
import org.dronewatch.fusion.Alert;
import org.dronewatch.fusion.AlertLog;
import org.dronewatch.fusion.Protection;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.run.advice.DroneSizeAdvice;
import org.dronewatch.run.advice.FlightAdvice;
import org.dronewatch.run.advice.PathAdvice;
import org.dronewatch.run.advice.SiteAdvice;
import org.dronewatch.run.advice.TerrainAdvice;
import org.dronewatch.run.model.FlightPaths;
import org.dronewatch.run.model.GroundOffsets;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.run.time.ActiveSensor;
import org.dronewatch.run.time.EmissionTime;
import org.dronewatch.run.time.LookTimes;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Curve;
import org.dronewatch.sensor.CurveSensor;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.RaySensor;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.Spelling;
import org.dronewatch.terrain.TerrainSettings;
import org.dronewatch.tracking.ContactLook;
import org.dronewatch.tracking.PerfectAssociation;
import org.dronewatch.world.Places;
import org.dronewatch.world.World;
import org.dronewatch.world.WorldSettings;

/**
 * The stage of a run, created from its settings: the world, the drones with their paths, and the sensors with their
 * next looks. Only the looks of the run and {@link #steerHere} change it, both on the thread that runs the scene;
 * everything else may be queried by any thread, during the run and after it.
 */
public final class Stage {
    private final World world;
    private final List<String> siteNotes;
    private final List<String> credits;
    private final Optional<LoadedBuildings> buildings;
    private final Protection protection;
    private final Map<String, Integer> colours;
    private final Map<String, Map<String, Integer>> droneColours = new LinkedHashMap<>();
    private final List<Airborne> airborne = new ArrayList<>();
    private final Map<String, SensorSettings<?>> sensors;
    private final List<String> raySensors;
    private final List<ActiveSensor> active = new ArrayList<>();
    private final Map<String, Pointing> pointings = new LinkedHashMap<>();
    private final SteeringClock clock;
    private final PerfectAssociation association;
    private final ContactDispatch dispatch;
    private List<ContactLook> contactLooks = List.of();
    private List<Alert> raised = List.of();
    private final long runSeed;

    /**
     * A stage with a perfect association of measurements.
     *
     * @param runSeed seed of all random numbers of this run
     * @throws org.dronewatch.setting.InputException when something cannot be loaded, or does not fit together
     */
    public Stage(SceneSettings settings, ModelCache models, long runSeed) {
        this(
                settings,
                models,
                runSeed,
                new PerfectAssociation(settings.alert().confirm().looks()));
    }

    Stage(SceneSettings settings, ModelCache models, long runSeed, PerfectAssociation association) {
        PictureMemory.check(settings, Runtime.getRuntime().maxMemory());
        WorldSettings site = settings.world();
        this.world = worldOf(site, models);
        this.siteNotes = models.siteNotes(site);
        this.buildings = models.buildings(site);
        this.credits = Stream.of(
                        buildings.flatMap(LoadedBuildings::credit),
                        site.terrain().flatMap(TerrainSettings::credit))
                .flatMap(Optional::stream)
                .toList();
        this.colours = Map.copyOf(models.colours(site));
        this.protection = Protection.of(settings.alert(), world);
        new SiteAdvice(settings, world).giveTo(models::warn);
        if (models.claimExamination(world.tree())) {
            new GroundOffsets(settings, world, models.firstTriangles(site)).giveTo(models::warn);
        }
        this.runSeed = runSeed;
        this.association = association;
        this.dispatch = new ContactDispatch(new AlertLog(settings.alert(), association::matcher));
        FlightPaths paths = new FlightPaths(
                new Places(site, world::newGround), settings.run().duration(), models);
        settings.individualDrones().forEach((id, drone) -> {
            Drone created = new Drone(id, drone, models.index(drone.model(), site.tracing()));
            airborne.add(new Airborne(created, paths.of(id, drone)));
            droneColours.put(id, Map.copyOf(models.colours(drone.model())));
        });
        this.clock = SteeringClock.of(airborne.stream().map(Airborne::path).toList());
        if (site.terrain().isPresent()) {
            new TerrainAdvice(settings, world.newGround()).giveTo(flights(), models::warn);
        }
        new DroneSizeAdvice(settings).giveTo(models);
        adviseOnFlights(settings, models);
        this.sensors = settings.enabledSensors();
        sensors.forEach((id, sensor) -> {
            active.add(new ActiveSensor(id, sensor, settings.world().weather()));
            sensor.as(Mounted.class)
                    .flatMap(Mounted::createPositioner)
                    .ifPresent(positioner -> dispatch.add(id, positioner));
        });
        this.raySensors = active.stream()
                .filter(ActiveSensor::tracesRays)
                .map(ActiveSensor::id)
                .toList();
    }

    /**
     * Flights must stay above the ground and outside of walls, and within the performance of their drones where it is
     * stated; steered ones are not known yet.
     */
    private void adviseOnFlights(SceneSettings settings, ModelCache models) {
        double duration = settings.run().duration();
        settings.individualDrones().forEach((id, drone) -> {
            FlightPath path = flights().get(id);
            if (SteeredFlight.in(path).isEmpty()) {
                new PathAdvice(id, world, world.newGround(), duration).giveTo(path, models::warn);
            }
            if (drone.performance().isPresent() && SteeredFlight.in(path).isEmpty()) {
                FlightLimits limits = drone.flightLimits();
                boolean isInstant = drone.flight().turnsInstantly();
                new FlightAdvice(id, isInstant ? limits.turningInstantly() : limits, world.newGround(), duration)
                        .giveTo(path, models::warn);
            }
        });
    }

    /** The world of a scene: its site in its weather and light. */
    public static World worldOf(WorldSettings site, ModelCache models) {
        World everywhere = new World(models.index(site), site.noise(), site.surfaces(), site.atmosphere())
                .withRain(site.rain())
                .withLight(site.light())
                .withNoiseSources(site.noiseSources())
                .withModels(models.firstTriangles(site));
        World world = models.remembering(
                models.knownGround(site).map(everywhere::withKnownGround).orElse(everywhere));
        return models.buildings(site)
                .flatMap(LoadedBuildings::landCover)
                .map(cover -> world.withLandCover(cover, site.surfaces()))
                .orElse(world);
    }

    /**
     * Releases the sensors, some of which keep large depth buffers: no more looks are possible. Everything else can
     * still be queried.
     */
    void release() {
        active.clear();
        clock.end();
    }

    /**
     * The credits that the data of the site require wherever the site is shown: first those of its map, then those of
     * its elevations.
     */
    public List<String> credits() {
        return credits;
    }

    /** Notes on the data of a real place, one line each, with the attribution that a map requires; none for models. */
    public List<String> siteNotes() {
        return siteNotes;
    }

    /** The buildings of the site's map, if it has one. */
    public Optional<LoadedBuildings> buildings() {
        return buildings;
    }

    /** The protected zones, placed on the site. */
    public Protection protection() {
        return protection;
    }

    /** The world. */
    public World world() {
        return world;
    }

    /** The colours of the world's materials in daylight, by name: red, green and blue in the lowest 24 bits. */
    public Map<String, Integer> colours() {
        return colours;
    }

    /** The colours of each drone's materials in daylight, by id of the drone and name of the material. */
    public Map<String, Map<String, Integer>> droneColours() {
        return Collections.unmodifiableMap(droneColours);
    }

    /**
     * The drones at a time, seconds since the start of the run.
     *
     * @throws IllegalStateException when one of them is steered, and the time is after {@link #known()}
     */
    public List<Drone> dronesAt(double time) {
        return airborne.stream().map(one -> one.drone.at(one.path.at(time))).toList();
    }

    /**
     * The position of a drone at a time, m.
     *
     * @param time seconds since the start of the run
     * @throws IllegalArgumentException when there is no such drone
     * @throws IllegalStateException when the drone is steered, and the time is after {@link #known()}
     */
    public Position positionOf(String drone, double time) {
        return flight(drone).at(time).position();
    }

    /**
     * The flight of a drone; {@link org.dronewatch.flight.SteeredFlight#in} returns the steered flight in it.
     *
     * @throws IllegalArgumentException when there is no such drone
     */
    public FlightPath flight(String drone) {
        FlightPath path = flights().get(drone);
        if (path == null) {
            throw new IllegalArgumentException(
                    Spelling.unknown("drone", drone, "the scene", flights().keySet()));
        }
        return path;
    }

    /** The flights by id of the drone, in the order of the scene. */
    public Map<String, FlightPath> flights() {
        Map<String, FlightPath> paths = new LinkedHashMap<>();
        airborne.forEach(one -> paths.put(one.drone.id(), one.path));
        return paths;
    }

    /** The time up to which the positions of all drones are known, s: infinity unless one is steered. */
    public double known() {
        return clock.known();
    }

    /** Makes the calling thread the one that runs the scene: only it may steer the drones. */
    public void steerHere() {
        clock.steerHere();
    }

    /** Advances steered drones to a time, s; the calling thread steers them from then on. */
    void flyTo(double time) {
        steerHere();
        clock.advance(time);
    }

    /**
     * Reports all rays traced by every ray-tracing sensor in its first look, without early termination.
     *
     * @param time time at which the positions of the drones are taken, seconds since the start of the run
     * @param target returns the recorder for the rays of the sensor and the drone with these names
     */
    public void traceRays(double time, BiFunction<String, String, RayRecorder> target) {
        for (String sensor : raySensors) {
            for (Drone drone : dronesAt(time)) {
                trace(sensor, drone, time, target.apply(sensor, drone.id()));
            }
        }
    }

    /** Whether there are rays to trace: a sensor that traces rays, and a drone. */
    public boolean tracesRays() {
        return !airborne.isEmpty() && !raySensors.isEmpty();
    }

    /**
     * Reports all rays traced from one drone to one sensor in its first look, without early termination.
     *
     * @param time time at which the position of the drone is taken, seconds since the start of the run
     * @return whether the sensor and the drone exist, and the sensor traces rays
     */
    public boolean traceRays(double time, String sensor, String drone, RayRecorder target) {
        for (Drone one : dronesAt(time)) {
            if (one.id().equals(drone) && raySensors.contains(sensor)) {
                trace(sensor, one, time, target);
                return true;
            }
        }
        return false;
    }

    /** The sensor is a new one: the run may continue meanwhile on another thread. */
    private void trace(String sensor, Drone drone, double time, RayRecorder target) {
        Look look = Look.of(runSeed, sensor, 0, time);
        RaySensor fresh = (RaySensor) sensors.get(sensor).create();
        fresh.traceRays(world, drone, look.random(drone.id(), RaySensor.RAYS), target);
    }

    /** Names of the sensors that trace rays. */
    public List<String> raySensors() {
        return raySensors;
    }

    /**
     * Computes the {@linkplain CurveSensor#curves curves}, such as spectra, of every sensor for each drone.
     *
     * @param time time at which the positions of the drones are taken, seconds since the start of the run
     * @param target receives the name of a sensor with each of its curves
     */
    public void draw(double time, BiConsumer<String, Curve> target) {
        sensors.forEach((id, settings) -> {
            if (settings.create() instanceof CurveSensor sensor) {
                for (Drone drone : dronesAt(time)) {
                    Look look = Look.of(runSeed, id, 0, time);
                    sensor.curves(world, drone, look.random(drone.id(), CurveSensor.CURVES))
                            .forEach(curve -> target.accept(id + "-" + drone.id(), curve));
                }
            }
        });
    }

    /** The earliest time at which a sensor looks next; infinity when there is no sensor. */
    double nextLook() {
        return active.stream().mapToDouble(ActiveSensor::nextTime).min().orElse(Double.POSITIVE_INFINITY);
    }

    /** Runs the looks of every sensor that is due at a time. */
    List<Observation> look(double time, List<Drone> drones, LookTimes times) {
        clock.look(time);
        pointings.clear();
        List<Supplier<List<Observation>>> looks = new ArrayList<>();
        List<String> looked = new ArrayList<>();
        for (ActiveSensor one : active) {
            if (one.nextTime() == time) {
                looked.add(one.id());
                Look look = one.nextLook(runSeed, time, dispatch.moveTo(one.id(), time));
                look.pointing().ifPresent(where -> pointings.put(one.id(), where));
                double speed = one.settings().signalSpeed(world);
                List<Drone> reaching =
                        Double.isFinite(speed) ? dronesReaching(one.settings().position(), speed, time) : drones;
                looks.add(() -> one.look(world, reaching, look, times));
            }
        }
        List<List<Observation>> seen = new ArrayList<>(Collections.nCopies(looks.size(), List.of()));
        Workers.forEach(looks.size(), i -> seen.set(i, looks.get(i).get()));
        List<Observation> observations = seen.stream().flatMap(List::stream).toList();
        contactLooks = association.associate(observations, looked, time);
        raised = dispatch.pass(contactLooks);
        return observations;
    }

    /** The most recent looks by contact, as received by alert rules and positioners. */
    List<ContactLook> contactLooks() {
        return contactLooks;
    }

    /** The alerts that the most recent looks raised. */
    List<Alert> raised() {
        return raised;
    }

    /** The alerts for contacts. */
    AlertLog alerts() {
        return dispatch.alerts();
    }

    /** Which contact is which drone, for scoring. */
    PerfectAssociation association() {
        return association;
    }

    /** Where the positioners of the sensors that looked last pointed, by name of the sensor. */
    Map<String, Pointing> pointings() {
        return pointings;
    }

    /**
     * The drones as they were when the signal that reaches a position now left them; without those whose signal has not
     * arrived yet.
     */
    private List<Drone> dronesReaching(Position position, double speed, double time) {
        List<Drone> reaching = new ArrayList<>();
        for (Airborne one : airborne) {
            EmissionTime.of(one.path, position, speed, time)
                    .ifPresent(emission -> reaching.add(one.drone.at(one.path.at(emission))));
        }
        return reaching;
    }

    private record Airborne(Drone drone, FlightPath path) {}
}
