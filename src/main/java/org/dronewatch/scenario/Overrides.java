package org.dronewatch.scenario;

import java.lang.reflect.RecordComponent;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.catalog.CatalogEntry;
import org.dronewatch.catalog.SensorKinds;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.setting.SettingsPath;

/**
 * Changes individual settings of a scene: a value by its path, or a whole sensor, or system of sensors, by its name in
 * the catalogue.
 */
public final class Overrides {
    private static final String SENSORS = "sensors.";
    private static final String KIND = ".kind";

    /** What a sensor takes over from the one that it replaces. */
    private static final List<String> POSE = List.of("position", "aim", "positioner");

    private final Catalog catalog;

    /** Overrides that find sensors and systems in a catalogue. */
    public Overrides(Catalog catalog) {
        this.catalog = catalog;
    }

    /**
     * The scene with one more setting changed, which may put a system in place of a sensor, or vice versa.
     *
     * @throws InputException when the path leads nowhere or the value does not fit
     */
    public SceneSettings override(SceneSettings scene, String path, String value) {
        String id = path.startsWith(SENSORS) ? path.substring(SENSORS.length()) : "";
        SystemSwap swap = new SystemSwap(catalog, id, value.strip());
        if (!swap.applies(scene)) {
            return write(scene, path, value);
        }
        try {
            return swap.of(scene);
        } catch (IllegalArgumentException | InputException e) {
            throw new InputException(path + "=" + PlainText.value(value) + ": " + e.getMessage(), e);
        }
    }

    /**
     * The scene with one more setting changed. The names of the sensors stay the same, as a sweep requires.
     *
     * @throws InputException when the path leads nowhere or the value does not fit
     */
    public SceneSettings write(SceneSettings scene, String path, String value) {
        String id = path.startsWith(SENSORS) ? path.substring(SENSORS.length()) : "";
        SensorSettings<?> old = scene.sensors().get(id);
        if (old == null) {
            checkNotKind(scene, path);
            return new SettingsPath(path).write(scene, value);
        }
        try {
            return scene.withSensor(id, catalog.settings(value.strip(), poseOf(old, value.strip())));
        } catch (InputException e) {
            throw new InputException(path + "=" + PlainText.value(value) + ": " + e.getMessage(), e);
        }
    }

    /** The kind of a sensor cannot be set on its own: the sensor is replaced as a whole, by a name. */
    private static void checkNotKind(SceneSettings scene, String path) {
        String sensor = path.endsWith(KIND) ? path.substring(0, path.length() - KIND.length()) : "";
        if (sensor.startsWith(SENSORS) && scene.sensors().containsKey(sensor.substring(SENSORS.length()))) {
            throw new InputException("setting '" + path + "': set '" + sensor
                    + "' itself to the name of a kind or of an entry of the catalogue");
        }
    }

    private Map<String, Object> poseOf(SensorSettings<?> old, String name) {
        Map<String, Object> pose = new LinkedHashMap<>();
        // Names in the catalogue take precedence over kinds.
        String kind = catalog.entry(name).map(CatalogEntry::kind).orElse(name);
        Optional<Class<?>> next = Optional.ofNullable(SensorKinds.all().get(kind));
        if (next.isPresent() && old instanceof Record settings) {
            SettingsForm mine = SettingsForm.of(settings.getClass());
            SettingsForm its = SettingsForm.of(next.get());
            for (String part : POSE) {
                Optional<RecordComponent> component = mine.part(part);
                if (component.isPresent() && its.part(part).isPresent()) {
                    pose.put(part, SettingsForm.get(settings, component.get()));
                }
            }
        }
        return pose;
    }
}
