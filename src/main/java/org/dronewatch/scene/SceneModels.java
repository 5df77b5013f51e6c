package org.dronewatch.scene;

import java.util.function.Consumer;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightsFile;
import org.dronewatch.flight.Recorded;
import org.dronewatch.flight.file.FlightFromFile;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scenario.advice.ConditionAdvice;
import org.dronewatch.scenario.advice.OriginAdvice;
import org.dronewatch.scenario.advice.SensorAdvice;
import org.dronewatch.setting.InputException;

/** The models of a scene's runs, each read once. */
final class SceneModels {
    private final ConfiguredScene scene;
    private final ModelCache models;

    /**
     * No models yet.
     *
     * @param notes receives one line for each file read and for each warning
     */
    SceneModels(ConfiguredScene scene, Consumer<String> notes) {
        this.scene = scene;
        this.models = scene.models(notes);
    }

    /** Models that others may have read already. */
    SceneModels(ConfiguredScene scene, ModelCache models) {
        this.scene = scene;
        this.models = models;
    }

    /**
     * Warns about weather and light that have no effect on what is detected, and about implausible settings of sensors.
     */
    void adviseOnConditions() {
        ConditionAdvice.of(scene.settingsOfRuns(scene.settings())).forEach(models::warn);
        SensorAdvice.of(scene.settingsOfRuns(scene.settings())).forEach(models::warn);
    }

    ModelCache cache() {
        return models;
    }

    /** The time taken so far to read models and build trees, s. */
    double seconds() {
        return models.loadSeconds() + models.buildSeconds();
    }

    /** Reads the models of a run, so that an error in one names the setting that refers to it. */
    void load(SceneSettings settings) {
        loadSite(settings);
        settings.drones().forEach((id, drone) -> {
            load("drones." + id + ".model", drone.model());
            if (drone.flight() instanceof Recorded recorded) {
                placing("drones." + id + ".flight", () -> checkFlight(recorded, id, drone));
            }
            if (drone.flight() instanceof FlightFromFile source) {
                placing("drones." + id + ".flight." + source.fileSetting(), () -> models.flight(source));
            }
        });
    }

    /** Reads only the models of the site, in the same way. */
    void loadSite(SceneSettings settings) {
        // First, because a site whose origin is wrong lies outside its files, and fails to load.
        settings.world().origin().ifPresent(origin -> new OriginAdvice(origin).giveTo(models::warn));
        placing("world.terrain", () -> models.readTerrain(settings.world()));
        placing("world.buildings", () -> models.readBuildings(settings.world()));
        for (int i = 0; i < settings.world().models().size(); i++) {
            int number = i;
            placing("world.models." + i, () -> models.readModel(settings.world(), number));
        }
    }

    private void load(String path, ModelSettings model) {
        placing(path, () -> models.read(model));
    }

    /** Each drone of a swarm finds its own flight later. */
    private void checkFlight(Recorded recorded, String id, DroneSettings drone) {
        FlightsFile file = models.flights(recorded.file());
        if (drone.swarm().isEmpty()) {
            file.flight(recorded.run(), recorded.drone().orElse(id));
        }
    }

    private void placing(String path, Runnable reading) {
        try {
            reading.run();
        } catch (InputException e) {
            throw new InputException(scene.placeOfFile(path) + path + ": " + e.getMessage(), e);
        }
    }
}
