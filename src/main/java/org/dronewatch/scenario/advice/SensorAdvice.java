package org.dronewatch.scenario.advice;

import java.util.List;
import java.util.stream.Stream;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.alarm.FalseAlarming;

/** Warns about sensors whose settings are implausible, although they are valid. */
public final class SensorAdvice {
    private SensorAdvice() {}

    /**
     * One line for each implausible setting of each sensor that is used; each line only once.
     *
     * @param runs the settings of all runs of a scene
     */
    public static List<String> of(List<SceneSettings> runs) {
        return runs.stream()
                .flatMap(scene -> scene.enabledSensors().entrySet().stream())
                .flatMap(sensor -> on(sensor.getValue()).map(line -> "sensor '" + sensor.getKey() + "': " + line))
                .distinct()
                .toList();
    }

    private static Stream<String> on(SensorSettings<?> sensor) {
        Stream<String> falseAlarms =
                sensor.as(FalseAlarming.Stated.class).flatMap(FalseAlarming.Stated::falseAlarms).stream()
                        .flatMap(stated -> stated.advice().stream());
        return Stream.concat(sensor.advice().stream(), falseAlarms);
    }
}
