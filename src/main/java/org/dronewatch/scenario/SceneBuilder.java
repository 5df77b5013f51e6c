package org.dronewatch.scenario;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.buildings.BuildingSettings;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.geo.Origin;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.Limits;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.terrain.TerrainSettings;
import org.dronewatch.world.Light;
import org.dronewatch.world.SurfaceSettings;
import org.dronewatch.world.WorldSettings;

/** Collects what a scene's {@code build()} describes. */
public final class SceneBuilder {
    private SceneSettings whole;
    private WorldSettings world;
    private BackgroundNoise backgroundNoise = BackgroundNoise.of(WorldSettings.QUIET);
    private SurfaceSettings surfaces = SurfaceSettings.DEFAULT;
    private Atmosphere atmosphere = Atmosphere.STANDARD;
    private double rain;
    private Light light = Light.DAY;
    private Optional<Origin> origin = Optional.empty();
    private final Map<String, DroneSettings> drones = new LinkedHashMap<>();
    private final Map<String, SensorSettings<?>> sensors = new LinkedHashMap<>();
    private final Set<String> disabled = new LinkedHashSet<>();
    private AlertSettings alert = AlertSettings.DEFAULT;
    private PriceSettings prices = PriceSettings.DEFAULT;
    private RunSettings run = RunSettings.DEFAULT;
    private Optional<SweepSettings> sweep = Optional.empty();

    /** Uses a complete description; anything else is then ignored. */
    public void setAll(SceneSettings settings) {
        whole = settings;
    }

    /** Adds a model to the site. */
    public void addToWorld(ModelSettings model) {
        world = world == null ? WorldSettings.of(model) : world.withModel(model);
    }

    /** Sets the buildings of a map. */
    public void setBuildings(BuildingSettings buildings) {
        world = (world == null ? WorldSettings.EMPTY : world).withBuildings(buildings);
    }

    /** Sets the terrain. */
    public void setTerrain(TerrainSettings terrain) {
        world = (world == null ? WorldSettings.EMPTY : world).withTerrain(terrain);
    }

    /** Assigns an acoustic surface of the library, by its name, to a material of the models. */
    public void nameSurface(String material, String surface) {
        surfaces = surfaces.with(material, surface);
    }

    /** Sets the air. */
    public void setAtmosphere(Atmosphere air) {
        atmosphere = air;
    }

    /** Sets the background noise. */
    public void setBackgroundNoise(BackgroundNoise noise) {
        backgroundNoise = noise;
    }

    /** Sets the rain rate, mm/h. */
    public void setRain(double millimetresPerHour) {
        rain = millimetresPerHour;
    }

    /** Sets the light. */
    public void setLight(Light other) {
        light = other;
    }

    /** Sets the geographic position of the origin. */
    public void setOrigin(Origin other) {
        origin = Optional.of(other);
    }

    /**
     * Adds a drone.
     *
     * @throws IllegalArgumentException if there is one with this id
     */
    public void addDrone(String id, DroneSettings settings) {
        if (drones.putIfAbsent(id, settings) != null) {
            throw new IllegalArgumentException("drone '" + id + "' already exists: every drone needs its own id");
        }
    }

    /**
     * Adds a sensor.
     *
     * @throws IllegalArgumentException if there is one with this id
     */
    public void addSensor(String id, SensorSettings<?> settings) {
        if (sensors.putIfAbsent(id, settings) != null) {
            throw new IllegalArgumentException("sensor '" + id + "' already exists: every sensor needs its own id");
        }
    }

    /** Disables a sensor, which may be added later. */
    public void disableSensor(String id) {
        disabled.add(id);
    }

    /** Sets the settings of the run, such as its duration. */
    public void setRun(RunSettings settings) {
        run = settings;
    }

    /** Sets the alert rule and what is protected. */
    public void setAlert(AlertSettings settings) {
        alert = settings;
    }

    /** Sets the prices. */
    public void setPrices(PriceSettings settings) {
        prices = settings;
    }

    /** Sets the sweep. */
    public void setSweep(SweepSettings settings) {
        sweep = Optional.of(settings);
    }

    /**
     * The description.
     *
     * @throws IllegalArgumentException if the scene has no world, or parts of it do not fit together
     */
    public SceneSettings toSettings() {
        if (whole != null) {
            return whole;
        }
        if (world == null) {
            throw new IllegalArgumentException(
                    "the scene has no world: its build() must call loadWorld, loadTerrain or loadBuildings");
        }
        WorldSettings anywhere = world.withBackgroundNoise(backgroundNoise)
                .withSurfaces(surfaces)
                .withAtmosphere(atmosphere)
                .withRain(rain)
                .withLight(light);
        WorldSettings site = origin.map(anywhere::withOrigin).orElse(anywhere);
        SceneSettings settings = new SceneSettings(site, drones, sensors, disabled, alert, prices, run, sweep);
        // What is read from a file has been checked there, where messages have lines.
        Limits.checkAll(settings);
        return settings;
    }
}
