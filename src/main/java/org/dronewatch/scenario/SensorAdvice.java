package org.dronewatch.scenario;

import java.util.List;

/** Warns of sensors whose settings are implausible, although they are valid. */
public final class SensorAdvice {
    private SensorAdvice() {}

    /**
     * One line for each implausible setting of each sensor that is used; the same line only once.
     *
     * @param runs the settings of all runs of a scene
     */
    public static List<String> of(List<SceneSettings> runs) {
        return runs.stream()
                .flatMap(scene -> scene.enabledSensors().entrySet().stream())
                .flatMap(sensor ->
                        sensor.getValue().advice().stream().map(line -> "sensor '" + sensor.getKey() + "': " + line))
                .distinct()
                .toList();
    }
}
