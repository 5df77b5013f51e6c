package org.dronewatch.run.advice;

import java.util.Locale;
import org.dronewatch.geometry.AABB;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.scenario.SceneSettings;

/** Warns of drones so large that their models were probably made in millimetres, but are read as metres. */
public record DroneSizeAdvice(SceneSettings settings) {
    /** No drone has a span greater than this, m. */
    private static final double LARGEST = 100.0;

    /** Reports a warning for each such drone. */
    public void giveTo(ModelCache models) {
        settings.drones().forEach((id, drone) -> {
            AABB box = models.index(drone.model(), settings.world().tracing())
                    .tree()
                    .bounds();
            double across = Math.max(box.maxX() - box.minX(), box.maxY() - box.minY());
            if (across > LARGEST) {
                models.warn(String.format(
                        Locale.ROOT,
                        "drone '%s': its model is %,.0f m across: unless its unit is the metre, set drones.%s.model.scale, as"
                                + " in scale: 0.001 for millimetres",
                        id,
                        across,
                        id));
            }
        });
    }
}
