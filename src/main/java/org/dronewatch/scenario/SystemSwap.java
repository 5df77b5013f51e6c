package org.dronewatch.scenario;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.SettingsForm;

/**
 * Replaces a system of sensors by another system or by a single sensor, or a single sensor by a system. Position and
 * aim are kept; each part has the positioner that its system specifies, if any.
 *
 * @param id what the scene calls the system, whose parts it calls {@code ID-radar} and so on, or the sensor
 * @param name name of the system or the sensor that is put there
 */
record SystemSwap(Catalog catalog, String id, String name) {
    private static final String POSITION = "position";
    private static final String AIM = "aim";

    /** Whether the scene has such a system, or such a sensor whose place a system is to take. */
    boolean applies(SceneSettings scene) {
        return scene.sensors().containsKey(id) ? isSystem() : !system(scene).isEmpty();
    }

    private boolean isSystem() {
        return !catalog.partsOf(name).isEmpty();
    }

    /**
     * The names in the scene of a system's parts; of several systems whose parts are all in the scene, the one with the
     * most parts is meant.
     */
    private List<String> system(SceneSettings scene) {
        List<String> most = List.of();
        if (scene.sensors().keySet().stream().noneMatch(sensor -> sensor.startsWith(id + "-"))) {
            // As for nearly every setting that is overridden: no system needs to be read.
            return most;
        }
        for (String system : Catalog.systemNames()) {
            List<String> parts = Catalog.system(system).orElseThrow().sensors().keySet().stream()
                    .map(part -> id + "-" + part)
                    .toList();
            if (parts.size() > most.size() && scene.sensors().keySet().containsAll(parts)) {
                most = parts;
            }
        }
        return most;
    }

    /**
     * The scene with the other system or sensor.
     *
     * @throws IllegalArgumentException when the scene refers to a part that is no longer there
     * @throws InputException when there is no such system or sensor, or a name is taken
     */
    SceneSettings of(SceneSettings scene) {
        Map<String, SensorSettings<?>> old = new LinkedHashMap<>(scene.sensors());
        old.keySet().retainAll(scene.sensors().containsKey(id) ? List.of(id) : system(scene));
        Position place = old.values().iterator().next().position();
        Map<String, SensorSettings<?>> fresh = new LinkedHashMap<>();
        if (isSystem()) {
            fresh.putAll(catalog.settingsOfSystem(id, name, place));
        } else {
            fresh.put(id, catalog.settings(name, Map.of(POSITION, place)));
        }
        fresh.replaceAll((part, sensor) -> mounted(sensor, part, old));
        Map<String, SensorSettings<?>> all = new LinkedHashMap<>();
        scene.sensors().forEach((other, sensor) -> {
            if (!old.containsKey(other)) {
                add(all, other, sensor);
            } else if (other.equals(old.keySet().iterator().next())) {
                fresh.forEach((part, one) -> add(all, part, one));
            }
        });
        Set<String> off = new LinkedHashSet<>(scene.disabled());
        off.retainAll(all.keySet());
        return SettingsForm.with(scene, Map.of("sensors", all, "disabled", off));
    }

    private static void add(Map<String, SensorSettings<?>> all, String id, SensorSettings<?> sensor) {
        if (all.putIfAbsent(id, sensor) != null) {
            throw new InputException("the scene already has a sensor '" + id + "'");
        }
    }

    /** A sensor with position and aim of the part that had its name, or else of the first that had them. */
    private static SensorSettings<?> mounted(SensorSettings<?> sensor, String id, Map<String, SensorSettings<?>> old) {
        SensorSettings<?> mounted = sensor;
        for (String part : List.of(POSITION, AIM)) {
            Optional<Object> kept = Optional.ofNullable(old.get(id))
                    .flatMap(same -> value(same, part))
                    .or(() -> old.values().stream()
                            .flatMap(other -> value(other, part).stream())
                            .findFirst());
            if (kept.isPresent() && value(sensor, part).isPresent()) {
                mounted = (SensorSettings<?>) SettingsForm.with((Record) mounted, part, kept.get());
            }
        }
        return mounted;
    }

    private static Optional<Object> value(SensorSettings<?> sensor, String part) {
        return sensor instanceof Record settings
                ? SettingsForm.of(settings.getClass()).part(part).map(known -> SettingsForm.get(settings, known))
                : Optional.empty();
    }
}
