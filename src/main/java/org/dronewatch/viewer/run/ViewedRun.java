package org.dronewatch.viewer.run;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.render.RecordedRays;
import org.dronewatch.render.SitePicture;
import org.dronewatch.render.SiteState;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;

/** A recorded run with its site, ready to be shown at any time, in seconds since the start of the run. Thread-safe. */
public final class ViewedRun {
    private final String title;
    private final RecordedRun run;
    private final SitePicture picture;
    private final Set<String> drones;

    public ViewedRun(String title, RecordedRun run) {
        this.title = title;
        this.run = run;
        this.drones = settings().individualDrones().keySet();
        this.picture = new SitePicture(settings(), run.stage());
    }

    /** The title above the site. */
    public String title() {
        return title;
    }

    public RecordedRun run() {
        return run;
    }

    public SceneSettings settings() {
        return run.info().settings();
    }

    public Stage stage() {
        return run.stage();
    }

    public SitePicture picture() {
        return picture;
    }

    /** The state of the site at a time. */
    public SiteState state(double time, Optional<String> selected, Optional<RecordedRays> rays) {
        return picture.state(
                title,
                time,
                (sensor, drone) -> run.isDetected(sensor, drone, time),
                sensor -> run.pointing(sensor, time),
                selected,
                rays);
    }

    /** Whether a sensor detects any drone at a time. */
    public boolean isDetecting(String sensor, double time) {
        return drones.stream().anyMatch(drone -> run.isDetected(sensor, drone, time));
    }

    /**
     * A sensor's last measurement of each drone up to a time, by the drone's name; drones not measured yet are left
     * out.
     */
    public Map<String, PairReading> readings(String sensor, double time) {
        Map<String, PairReading> last = new HashMap<>();
        for (String drone : drones) {
            run.reading(sensor, drone, time).ifPresent(reading -> last.put(drone, reading));
        }
        return last;
    }

    /**
     * Where the sensor or drone with a given name is at a time, m; empty if there is none.
     *
     * @param layout the settings with the sensors where they are now
     */
    public Optional<Position> positionOf(String id, SceneSettings layout, double time) {
        if (layout.sensors().containsKey(id)) {
            return Optional.of(layout.sensors().get(id).position());
        }
        return stage().dronesAt(time).stream()
                .filter(drone -> drone.id().equals(id))
                .map(Drone::origin)
                .findFirst();
    }
}
