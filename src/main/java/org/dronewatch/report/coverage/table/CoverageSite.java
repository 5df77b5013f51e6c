package org.dronewatch.report.coverage.table;

import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;

/**
 * The site whose coverage was assessed.
 *
 * @param settings settings of the scene
 * @param stage the site's world, its protected zones and the credits of its data
 */
public record CoverageSite(SceneSettings settings, Stage stage) {
    /** The positions of the enabled sensors, m. */
    public List<Position> sensors() {
        return settings.enabledSensors().values().stream()
                .map(sensor -> sensor.position())
                .toList();
    }
}
