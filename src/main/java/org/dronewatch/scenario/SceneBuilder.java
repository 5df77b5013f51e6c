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

    public void setAll(SceneSettings settings) {
        whole = settings;
    }

    public void addToWorld(ModelSettings model) {
        world = world == null ? WorldSettings.of(model) : world.withModel(model);
    }

    public void setBuildings(BuildingSettings buildings) {
        world = (world == null ? WorldSettings.EMPTY : world).withBuildings(buildings);
    }

    public void setTerrain(TerrainSettings terrain) {
        world = (world == null ? WorldSettings.EMPTY : world).withTerrain(terrain);
    }

    public void nameSurface(String ofTheModel, String ofTheTable) {
        surfaces = surfaces.with(ofTheModel, ofTheTable);
    }

    public void setAtmosphere(Atmosphere air) {
        atmosphere = air;
    }

    public void setBackgroundNoise(BackgroundNoise noise) {
        backgroundNoise = noise;
    }

    public void setRain(double millimetresPerHour) {
        rain = millimetresPerHour;
    }

    public void setLight(Light other) {
        light = other;
    }

    public void setOrigin(Origin other) {
        origin = Optional.of(other);
    }

    public void addDrone(String id, DroneSettings settings) {
        if (drones.putIfAbsent(id, settings) != null) {
            throw new IllegalArgumentException("drone '" + id + "' already exists: every drone needs its own id");
        }
    }

    public void addSensor(String id, SensorSettings<?> settings) {
        if (sensors.putIfAbsent(id, settings) != null) {
            throw new IllegalArgumentException("sensor '" + id + "' already exists: every sensor needs its own id");
        }
    }

    public void disableSensor(String id) {
        disabled.add(id);
    }

    public void setRun(RunSettings settings) {
        run = settings;
    }

    public void setAlert(AlertSettings settings) {
        alert = settings;
    }

    public void setPrices(PriceSettings settings) {
        prices = settings;
    }

    public void setSweep(SweepSettings settings) {
        sweep = Optional.of(settings);
    }

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
