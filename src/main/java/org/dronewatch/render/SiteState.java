package org.dronewatch.render;

import java.util.List;
import java.util.Optional;
import org.dronewatch.render.canvas.DroneMark;
import org.dronewatch.render.canvas.FlightStretch;
import org.dronewatch.render.canvas.SensorMark;

/**
 * The state of the site at one time, for a view.
 *
 * @param title title of the picture
 * @param time seconds since the start of the run
 * @param sensors the sensors
 * @param drones the drones
 * @param selected name of the selected sensor or drone; empty if none is selected
 * @param rays sound rays to be drawn; empty if there are none
 * @param stretches flights that are coloured by which sensors detect the drone, instead of being drawn as past and
 *     future
 */
public record SiteState(
        String title,
        double time,
        List<SensorMark> sensors,
        List<DroneMark> drones,
        Optional<String> selected,
        Optional<RecordedRays> rays,
        List<FlightStretch> stretches) {
    /** Copies the lists: later changes by the caller have no effect. */
    public SiteState {
        sensors = List.copyOf(sensors);
        drones = List.copyOf(drones);
        stretches = List.copyOf(stretches);
    }

    /** A state whose flights are drawn as past and future. */
    public SiteState(
            String title,
            double time,
            List<SensorMark> sensors,
            List<DroneMark> drones,
            Optional<String> selected,
            Optional<RecordedRays> rays) {
        this(title, time, sensors, drones, selected, rays, List.of());
    }

    /** This state with flights that are coloured by which sensors detect the drone. */
    public SiteState withStretches(List<FlightStretch> others) {
        return new SiteState(title, time, sensors, drones, selected, rays, others);
    }

    /** This state with some of its sensors moved or turned, and a title that says so. */
    public SiteState withSensors(List<SensorMark> others, String otherTitle) {
        return new SiteState(otherTitle, time, others, drones, selected, rays, stretches);
    }
}
