package org.dronewatch.scenario;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.fusion.AlertRule;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.fusion.FalseAlertRate;
import org.dronewatch.sensor.DirectionFinding;
import org.dronewatch.sensor.Draws;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.Check;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.setting.Spelling;
import org.dronewatch.setting.Switchable;
import org.dronewatch.world.WorldSettings;

/**
 * A complete scene. Java scenes, scene files, overrides and sweeps build it; only then are meshes
 * loaded and sensors created from it. The order of drones and sensors is kept.
 *
 * @param world the site
 * @param drones drones by id; at most 1000, including those of their swarms
 * @param sensors sensors by id, including those that are switched off ({@code enabled: false}), which observe nothing,
 *     cost nothing and are validated like the others
 * @param disabled ids of the sensors that are switched off
 * @param alert when an alert is raised, and what is to be protected
 * @param prices what the sensors cost
 * @param run duration and seed; a sensor may take at most 100,000,000 looks in a run
 * @param sweep a setting that changes from run to run; omit it for a single run
 */
public record SceneSettings(
        WorldSettings world,
        Map<String, DroneSettings> drones,
        @Switchable("disabled") Map<String, SensorSettings<?>> sensors,
        Set<String> disabled,
        AlertSettings alert,
        PriceSettings prices,
        RunSettings run,
        Optional<SweepSettings> sweep) {
    /** Maximum number of looks of one sensor in a run: ten per second for more than a hundred days. */
    public static final int MOST_LOOKS = 100_000_000;

    /** Checks ids and copies the maps. */
    public SceneSettings {
        checkSite(Check.present("world", world));
        Check.present("alert", alert);
        Check.present("prices", prices);
        Check.present("run", run);
        Check.present("sweep", sweep);
        drones = Collections.unmodifiableMap(new LinkedHashMap<>(Check.present("drones", drones)));
        sensors = Collections.unmodifiableMap(new LinkedHashMap<>(Check.present("sensors", sensors)));
        disabled = Collections.unmodifiableSet(new LinkedHashSet<>(Check.present("disabled", disabled)));
        drones.keySet().forEach(SceneSettings::checkId);
        SwarmExpansion.of(drones);
        sensors.keySet().forEach(SceneSettings::checkId);
        Map<String, SensorSettings<?>> all = sensors;
        if (alert.response() > 0.0 && !alert.isProtecting()) {
            throw new IllegalArgumentException("alert.response " + alert.response()
                    + " s needs alert.protect or alert.zones, the area that the drone must not reach");
        }
        if (!sensors.isEmpty()) {
            // Without sensors it may be a scene that is still being read.
            prices.sensors().keySet().forEach(id -> checkPriced(id, all));
            disabled.forEach(id -> checkDisabled(id, all));
            checkRule(alert.rule(), sensors.size());
        }
        double duration = run.duration();
        sensors.forEach((id, sensor) -> checkLooks(id, sensor.rate(), duration));
        FalseAlertRate.check(alert, sensors, world.weather());
        sensors.forEach((id, sensor) -> Mounted.positioner(sensor)
                .ifPresent(positioner -> positioner.cues().forEach(cue -> checkCue(id, cue, all))));
    }

    private static void checkSite(WorldSettings world) {
        if (world.models().isEmpty()
                && world.terrain().isEmpty()
                && world.buildings().isEmpty()) {
            throw new IllegalArgumentException(
                    "world.models is empty: a world needs at least one, or a terrain, or buildings");
        }
        for (int i = 0; i < world.models().size(); i++) {
            if (world.models().get(i).crs().isPresent() && world.origin().isEmpty()) {
                throw new IllegalArgumentException(
                        "world.models." + i + ".crs needs a world.origin, the latitude and longitude of x = y = 0");
            }
        }
        world.terrain().ifPresent(terrain -> {
            if (terrain.allFiles().isEmpty()) {
                throw new IllegalArgumentException("world.terrain needs a 'file' of elevations, or several 'files'");
            }
            if (world.origin().isEmpty()) {
                throw new IllegalArgumentException(
                        "world.terrain needs a world.origin, the latitude and longitude of x = y = 0");
            }
        });
        world.buildings().ifPresent(buildings -> {
            if (buildings.file().isEmpty()) {
                throw new IllegalArgumentException("world.buildings needs a 'file', a map with buildings");
            }
            if (world.origin().isEmpty()) {
                throw new IllegalArgumentException(
                        "world.buildings needs a world.origin, the latitude and longitude of x = y = 0");
            }
            if (buildings.landCover() && world.terrain().isEmpty()) {
                throw new IllegalArgumentException(
                        "world.buildings.landCover is true, but there is no world.terrain that it could cover");
            }
        });
    }

    /** With more looks, a run would take days even for the fastest sensor. */
    private static void checkLooks(String id, double rate, double duration) {
        // The library's own kinds have tighter limits; those of other jars may have none.
        if (!(rate > 0.0)) {
            throw new IllegalArgumentException("sensors." + id + ".rate " + rate + " Hz must be above 0");
        }
        double looks = rate * duration;
        if (looks > MOST_LOOKS) {
            throw new IllegalArgumentException("sensors." + id + ".rate " + rate + " Hz for run.duration " + duration
                    + " s makes " + (float) looks + " looks; there must be at most " + MOST_LOOKS);
        }
    }

    private static void checkRule(AlertRule rule, int sensors) {
        if (rule instanceof AlertRule.SeveralSensors several && several.count() > sensors) {
            throw new IllegalArgumentException(
                    "alert.rule.count " + several.count() + " must be at most " + sensors + ", the number of sensors");
        }
    }

    private static void checkDisabled(String id, Map<String, SensorSettings<?>> sensors) {
        if (!sensors.containsKey(id)) {
            throw new IllegalArgumentException(
                    "disabled '" + id + "': there is no such sensor; " + Spelling.closestMatches(id, sensors.keySet()));
        }
    }

    private static void checkPriced(String id, Map<String, SensorSettings<?>> sensors) {
        if (!sensors.containsKey(id)) {
            throw new IllegalArgumentException("prices.sensors." + id + ": there is no such sensor; "
                    + Spelling.closestMatches(id, sensors.keySet()));
        }
    }

    private static void checkCue(String id, String cue, Map<String, SensorSettings<?>> sensors) {
        String cued = "sensors." + id + ".positioner.cues: sensor '" + id + "' is cued by ";
        if (cue.equals(id)) {
            throw new IllegalArgumentException(cued + "itself: it follows its own detections anyway");
        }
        String listens = cued + "'" + cue + "'";
        if (!sensors.containsKey(cue)) {
            throw new IllegalArgumentException(
                    listens + ": there is no such sensor; " + Spelling.closestMatches(cue, sensors.keySet()));
        }
        if (sensors.get(cue).as(DirectionFinding.class).isEmpty()) {
            throw new IllegalArgumentException(listens + ", of kind "
                    + sensors.get(cue).kind() + ", which does not measure the position or direction of a drone");
        }
    }

    private static void checkId(String id) {
        if (!id.matches("[A-Za-z0-9_-]{1,64}")) {
            throw new IllegalArgumentException(
                    "id '" + id + "' must be 1 to 64 letters, digits, '-' or '_': it is part of settings' paths");
        }
    }

    /**
     * The individual drones by id: a swarm {@code x} is expanded into {@code x-1}, {@code x-2} and so on. Detections
     * refer to these ids; overrides and sweeps refer to {@link #drones()}.
     */
    public Map<String, DroneSettings> individualDrones() {
        return SwarmExpansion.of(drones);
    }

    /** The ids of the {@linkplain #individualDrones() individual drones} that are birds. */
    public Set<String> birds() {
        Set<String> birds = new LinkedHashSet<>();
        individualDrones().forEach((id, drone) -> {
            if (drone.isBird()) {
                birds.add(id);
            }
        });
        return Collections.unmodifiableSet(birds);
    }

    /** A scene in this world, without drones or sensors, that runs for a minute. */
    @Defaults("world")
    public static SceneSettings of(WorldSettings world) {
        return new SceneSettings(
                world,
                Map.of(),
                Map.of(),
                Set.of(),
                AlertSettings.DEFAULT,
                PriceSettings.DEFAULT,
                RunSettings.DEFAULT,
                Optional.empty());
    }

    /** The sensors that are not switched off, by id: those that observe. */
    public Map<String, SensorSettings<?>> enabledSensors() {
        if (disabled.isEmpty()) {
            return sensors;
        }
        Map<String, SensorSettings<?>> enabled = new LinkedHashMap<>(sensors);
        enabled.keySet().removeAll(disabled);
        return Collections.unmodifiableMap(enabled);
    }

    /** Whether the scene has this sensor, and it is not switched off. */
    public boolean isEnabled(String sensor) {
        return sensors.containsKey(sensor) && !disabled.contains(sensor);
    }

    /**
     * These settings with a sensor switched on or off.
     *
     * @throws IllegalArgumentException when there is no such sensor
     */
    public SceneSettings withEnabled(String sensor, boolean enabled) {
        if (!sensors.containsKey(sensor)) {
            throw new IllegalArgumentException("sensor '" + sensor + "' cannot be switched " + (enabled ? "on" : "off")
                    + ": the scene has "
                    + (sensors.isEmpty() ? "no sensors" : String.join(", ", sensors.keySet())));
        }
        Set<String> off = new LinkedHashSet<>(disabled);
        if (enabled) {
            off.remove(sensor);
        } else {
            off.add(sensor);
        }
        return SettingsForm.with(this, "disabled", off);
    }

    /** These settings with the sensor of this id replaced or added. */
    public SceneSettings withSensor(String id, SensorSettings<?> sensor) {
        Map<String, SensorSettings<?>> others = new LinkedHashMap<>(sensors);
        others.put(id, sensor);
        return SettingsForm.with(this, "sensors", others);
    }

    /** These settings with the drone of this id replaced or added. */
    public SceneSettings withDrone(String id, DroneSettings drone) {
        Map<String, DroneSettings> others = new LinkedHashMap<>(drones);
        others.put(id, drone);
        return SettingsForm.with(this, "drones", others);
    }

    /**
     * These settings as one run of a sweep: the swept setting has only this value, and the seed is derived from the
     * number of the run; the first run keeps the seed of these settings.
     *
     * @param number number of the run in the sweep, from 0
     * @param value value of the swept setting, as text
     */
    public SceneSettings asRunWith(int number, String value) {
        Optional<SweepSettings> one = sweep.map(all -> new SweepSettings.Values(all.parameter(), List.of(value)));
        RunSettings own = run.withSeed(Draws.derivedSeed(run.seed(), "run", number));
        return new SceneSettings(world, drones, sensors, disabled, alert, prices, own, one);
    }

    /** These settings without a sweep. */
    public SceneSettings withoutSweep() {
        return new SceneSettings(world, drones, sensors, disabled, alert, prices, run, Optional.empty());
    }
}
