package org.dronewatch.render;

import java.util.List;
import java.util.Optional;

/**
 * The state of the site at one time, for a view.
 *
 * @param title of the picture
 * @param time seconds since the start of the run
 * @param sensors the sensors
 * @param drones the drones
 * @param selected the selected sensor or drone
 * @param rays rays of sound
 */
public record SiteState(
        String title,
        double time,
        List<SensorMark> sensors,
        List<DroneMark> drones,
        Optional<String> selected,
        Optional<RecordedRays> rays) {
    /** Copies the lists: later changes by the caller have no effect. */
    public SiteState {
        sensors = List.copyOf(sensors);
        drones = List.copyOf(drones);
    }
}
