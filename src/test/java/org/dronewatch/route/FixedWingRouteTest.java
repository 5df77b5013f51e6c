package org.dronewatch.route;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.drone.FlightPerformance;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The route of a drone at 12 m/s that cannot hover. */
class FixedWingRouteTest {
    private static final int EAST = 2;

    private static final String ZONE = "alert: {protect: {centre: [0, 0, 10], radius: 25}}\n";

    /** Far in the south, above all boxes. */
    private static final String FAR =
            FieldSite.ROUND.replace("maxRange: 150", "maxRange: 900").replace("[0, 0, 4]", "[0, -450, 60]");

    private static final FlightPerformance CANNOT_HOVER =
            FlightPerformance.TYPICAL.withHover(false).withTurnRate(0.6);

    @TempDir
    private Path directory;

    private SectorRoute weakest(String sensors, FieldGrid grid) throws IOException {
        SceneSettings plain = FieldSite.in(directory, sensors + ZONE).settings();
        SceneSettings settings = plain.withDrone(
                FieldSite.DRONE, plain.drones().get(FieldSite.DRONE).withPerformance(CANNOT_HOVER));
        FieldSite site =
                new FieldSite(settings, new SceneRunner(new SceneFile(directory.resolve("site.yaml"))).stage(settings));
        SiteRoutes routes = SiteRoutes.of(site.field(grid, 2), settings, site.stage(), FieldSite.DRONE);
        return routes.describe(EAST, routes.from(EAST).orElseThrow());
    }

    /** The radar rejects radial speeds below 1 m/s: a band of headings that is 9.6 degrees wide. */
    @Test
    void aNarrowBandOfHeadingsIsFound() throws IOException {
        FieldGrid grid = new FieldGrid(0, 0, 500, 25, List.of(30.0));
        SectorRoute crossing = weakest(FAR.replace("minSpeed: 3 m/s", "minSpeed: 1 m/s"), grid);
        SectorRoute straight = weakest(FAR.replace("minSpeed: 3 m/s", "minSpeed: 0 m/s"), grid);

        assertThat(crossing.profile().exposure())
                .isLessThan(0.15 * straight.profile().exposure());
    }
}
