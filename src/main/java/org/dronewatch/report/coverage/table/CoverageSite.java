package org.dronewatch.report.coverage.table;

import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;

/**
 * The site whose coverage was assessed.
 *
 * @param settings of the scene
 * @param stage the site's world, its protected zones and the credits of its data
 */
public record CoverageSite(SceneSettings settings, Stage stage) {
    /** Where the enabled sensors are, m. */
    public List<Position> sensors() {
        return settings.enabledSensors().values().stream()
                .map(sensor -> sensor.position())
                .toList();
    }
}
