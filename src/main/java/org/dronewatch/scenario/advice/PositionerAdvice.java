package org.dronewatch.scenario.advice;

import java.util.Locale;
import java.util.function.Consumer;
import org.dronewatch.positioner.PositionerSettings;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Outline;
import org.dronewatch.sensor.Outlined;
import org.dronewatch.sensor.SensorSettings;

/**
 * Warns about a sensor's positioner if its settings are implausible, although they are valid.
 *
 * @param scene the scene to which the sensor belongs
 * @param id name of the sensor
 * @param positioner settings of the sensor's positioner
 */
public record PositionerAdvice(SceneSettings scene, String id, PositionerSettings positioner) {

    /** Gives one line for each implausible setting. */
    public void giveTo(Consumer<String> target) {
        for (String cue : positioner.cues()) {
            double interval = 1.0 / scene.sensors().get(cue).rate();
            if (positioner.hold() < interval) {
                target.accept(String.format(
                        Locale.ROOT,
                        "sensors.%s.positioner.hold %.2g s is less than the %.2g s between looks of '%s', which cues"
                                + " this positioner: it stops following the drone between cues",
                        id,
                        positioner.hold(),
                        interval,
                        cue));
            }
        }
        SensorSettings<?> sensor = scene.sensors().get(id);
        Outlined.outline(sensor).ifPresent(outline -> {
            if (outline instanceof Outline.Frustum frustum) {
                double elevation =
                        Math.asin(Math.max(-1.0, Math.min(1.0, frustum.forward().z())));
                if (elevation < positioner.minTilt() - 1e-9 || elevation > positioner.maxTilt() + 1e-9) {
                    target.accept(String.format(
                            Locale.ROOT,
                            "sensor '%s' aims at an elevation of %.1f degrees, but its positioner"
                                    + " tilts only from %.1f to %.1f degrees",
                            id,
                            Math.toDegrees(elevation),
                            Math.toDegrees(positioner.minTilt()),
                            Math.toDegrees(positioner.maxTilt())));
                }
            }
        });
    }
}
