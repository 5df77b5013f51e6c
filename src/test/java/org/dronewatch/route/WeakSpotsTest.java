package org.dronewatch.route;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldAssessment;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.FlightPerformance;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.search.RoutePath;
import org.dronewatch.route.search.TimeToGo;
import org.dronewatch.route.search.WeakestRoute;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.Cause;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Four boxes on a plain, and sensors with a weak spot: it is used where it pays, and not where it does not. */
class WeakSpotsTest {
    private static final int NORTH = 0;
    private static final int EAST = 2;
    private static final int SOUTH_EAST = 3;
    private static final int WEST = 6;

    private static final String ZONE = "alert: {protect: {centre: [0, 0, 10], radius: 25}}\n";

    private static final String HIGH_ZONE = ZONE.replace("25", "55");

    /** Sees everything, however it moves, as far as the rim. */
    private static final String FAR =
            FieldSite.ROUND.replace("minSpeed: 3 m/s", "minSpeed: 0 m/s").replace("maxRange: 150", "maxRange: 900");

    private static final String NEAR = FieldSite.ROUND.replace("minSpeed: 3 m/s", "minSpeed: 0 m/s");

    private static final String EAR =
            "  ear: {kind: acoustic, position: [0, 0, 4], propagation: {kind: level-model, initialRays: 2, maxOrder: 1}}\n";

    private static final String NOTCHED =
            """
              notched: {kind: radar, position: [40, 0, 4], minRange: 1, maxRange: 400, elevationWidth: 90 deg,
                budget: {range: 110, crossSection: 0.01}, notch: {kind: high-pass, halfPowerSpeed: 4 m/s},
                detection: {kind: chance, pulses: 8}}
            """;

    @TempDir
    private Path directory;

    private static FieldGrid cells(double... heights) {
        List<Double> above = new ArrayList<>();
        for (double height : heights) {
            above.add(height);
        }
        return new FieldGrid(0, 0, 500, 25, above);
    }

    private SiteRoutes powered(String sensors, FieldGrid grid) throws IOException {
        FieldSite site = FieldSite.in(directory, sensors + (sensors.contains("alert:") ? "" : ZONE));
        return SiteRoutes.of(site.field(grid, 2), site.settings(), site.stage(), FieldSite.DRONE);
    }

    private static SectorRoute weakest(SiteRoutes routes, int sector) {
        return routes.describe(sector, routes.from(sector).orElseThrow());
    }

    private static double hidden(SectorRoute route, Cause cause) {
        return route.causes().dominant().seconds().getOrDefault(cause, 0.0);
    }

    /** Behind the building in the north, nothing is seen; from the south-east, the detour takes too long. */
    @Test
    void aWallHidesThoseWhoComeFromBehindIt() throws IOException {
        SiteRoutes routes = powered(FAR, cells(10));
        SectorRoute north = weakest(routes, NORTH);
        SectorRoute southEast = weakest(routes, SOUTH_EAST);

        assertThat(hidden(north, Cause.HIDDEN_BY_BUILDING)).isGreaterThan(10.0);
        assertThat(hidden(southEast, Cause.HIDDEN_BY_BUILDING)).isZero();
        assertThat(north.profile().exposure())
                .isLessThan(0.75 * southEast.profile().exposure());
    }

    /** A receiver that nothing is loud enough for comes nearest to a detection where a wall hides the drone. */
    @Test
    void theCausesOfEachSensorAreKept() throws IOException {
        String deaf = FAR + "  deaf: {kind: rf, position: [0, 5, 4], threshold: 100}\n";
        RouteCauses causes = weakest(powered(deaf, cells(10)), NORTH).causes();

        assertThat(causes.dominant().seconds()).doesNotContainKey(Cause.HIDDEN_BY_BUILDING);
        assertThat(causes.bySensor()).containsOnlyKeys("round", "deaf");
        assertThat(causes.bySensor().get("deaf").share(Cause.TOO_WEAK)).isEqualTo(1.0);
        assertThat(causes.bySensor().get("round").seconds().get(Cause.HIDDEN_BY_BUILDING))
                .isGreaterThan(10.0);
    }

    /** Behind the flat box in the west, only low flight is hidden. */
    @Test
    void lowGroundHidesThoseWhoFlyLow() throws IOException {
        SectorRoute low = weakest(powered(FAR + HIGH_ZONE, cells(10, 60)), WEST);
        SectorRoute high = weakest(powered(FAR + HIGH_ZONE, cells(60)), WEST);

        assertThat(hidden(low, Cause.HIDDEN_BY_TERRAIN)).isGreaterThan(8.0);
        assertThat(low.profile().medianHeight()).isLessThan(35.0);
        assertThat(hidden(high, Cause.HIDDEN_BY_TERRAIN)).isZero();
        assertThat(low.profile().exposure()).isLessThan(0.6 * high.profile().exposure());
    }

    /** A radar far in the south, above all boxes, misses what flies round it; otherwise, straight flight is best. */
    @Test
    void aRadarThatMissesCrossingFlightIsCrossed() throws IOException {
        String blind = FieldSite.ROUND.replace("maxRange: 150", "maxRange: 900").replace("[0, 0, 4]", "[0, -450, 60]");
        String seeing = blind.replace("minSpeed: 3 m/s", "minSpeed: 0 m/s");
        SectorRoute crossing = weakest(powered(blind, cells(30)), EAST);
        SectorRoute straight = weakest(powered(seeing, cells(30)), EAST);

        assertThat(crossing.profile().exposure())
                .isLessThan(0.1 * straight.profile().exposure());
        Position start = straight.profile().points().get(0).position();
        Position end = straight.profile().end().position();
        assertThat(straight.route().path().length()).isLessThan(1.02 * start.distance(end));
    }

    /** A radar sees nothing that is more than 60° above it: only the nodes right above it are inside this cone. */
    @Test
    void aNarrowConeAboveARadarIsDescendedVertically() throws IOException {
        String cone = NEAR.replace("elevationWidth: 90 deg", "elevationWidth: 120 deg");
        FieldGrid grid = new FieldGrid(0, 0, 475, 25, List.of(10.0, 30.0, 45.0, 60.0, 80.0, 100.0, 130.0, 160.0));
        SectorRoute above = weakest(powered(cone, grid), EAST);
        SectorRoute all =
                weakest(powered(NEAR.replace("elevationWidth: 90 deg", "elevationWidth: 180 deg"), grid), EAST);

        assertThat(above.profile().exposure()).isLessThan(1e-6);
        assertThat(all.profile().exposure()).isGreaterThan(10.0);
    }

    private SiteRoutes gliding(String sensors, FieldGrid grid) throws IOException {
        SceneSettings plain = FieldSite.in(directory, sensors + ZONE).settings();
        FlightPerformance performance = FlightPerformance.TYPICAL.withGlide(8.0, 10.0);
        SceneSettings settings = plain.withDrone(
                FieldSite.DRONE, plain.drones().get(FieldSite.DRONE).withPerformance(performance));
        FieldSite site =
                new FieldSite(settings, new SceneRunner(new SceneFile(directory.resolve("site.yaml"))).stage(settings));
        Drone drone = DetectionField.droneOf(site.stage(), FieldSite.DRONE);
        DetectionField quiet = FieldAssessment.of(
                settings,
                site.stage(),
                FieldSite.DRONE,
                grid,
                Course.gliding(settings.enabledSensors(), drone),
                done -> {});
        return SiteRoutes.of(
                List.of(
                        ModeField.powered(site.field(grid, 2), drone.settings()),
                        ModeField.gliding(quiet, drone.settings())),
                settings,
                site.stage(),
                FieldSite.DRONE,
                Optional.empty());
    }

    /** A microphone does not hear a glider, which cannot climb again; to a radar, a slow glide is only longer. */
    @Test
    void motorsAreStoppedWhereTheyAreHeard() throws IOException {
        FieldGrid grid = cells(10, 20, 30, 45);
        SectorRoute powered = weakest(powered(EAR, grid), SOUTH_EAST);
        SiteRoutes both = gliding(EAR, grid);
        SectorRoute glide = weakest(both, SOUTH_EAST);
        SectorRoute radar = weakest(gliding(NEAR, grid), SOUTH_EAST);

        assertThat(powered.profile().exposure()).isGreaterThan(1.0);
        assertThat(glide.profile().exposure()).isLessThan(0.01);
        List<Integer> modes = glide.route().path().modes();
        assertThat(modes).isSorted().startsWith(0).endsWith(1);
        assertSinks(glide.route().path());
        assertThat(both.flight(glide.route()).orElseThrow().duration(12.0))
                .isCloseTo(glide.route().seconds(), within(1e-6));
        assertThat(radar.route().path().modes()).containsOnly(0);
    }

    /** 225 m to the zone at 12 m/s. */
    @Test
    void nobodyFliesForLongerThanTheEndurance() throws IOException {
        FieldSite plain = FieldSite.in(directory, NEAR + ZONE);
        for (double endurance : new double[] {15.0, 30.0}) {
            FlightPerformance performance = FlightPerformance.TYPICAL.withEndurance(endurance);
            SceneSettings settings = plain.settings()
                    .withDrone(
                            FieldSite.DRONE,
                            plain.settings().drones().get(FieldSite.DRONE).withPerformance(performance));
            FieldSite site = new FieldSite(
                    settings, new SceneRunner(new SceneFile(directory.resolve("site.yaml"))).stage(settings));
            Optional<WeakestRoute> route = SiteRoutes.of(
                            site.field(cells(30), 1), settings, site.stage(), FieldSite.DRONE)
                    .from(EAST);

            assertThat(route.isPresent()).isEqualTo(endurance > 16.0);
            assertThat(route.map(WeakestRoute::seconds).orElse(0.0)).isLessThanOrEqualTo(endurance);
        }
    }

    private static void assertSinks(RoutePath path) {
        for (int leg = 0; leg < path.modes().size(); leg++) {
            Position from = path.points().get(leg);
            Position to = path.points().get(leg + 1);
            double along = Math.hypot(to.x() - from.x(), to.y() - from.y());
            assertThat(path.modes().get(leg) == 0 || from.z() - to.z() >= along / 8.0 - 1e-6)
                    .isTrue();
        }
    }

    /** Within 1 %, since smoothing may get further in one of two fields. */
    @Test
    void anotherSensorNeverLowersTheExposure() throws IOException {
        double before = 0.0;
        for (String sensors : List.of(FieldSite.ROUND, FieldSite.ROUND + EAR, FieldSite.ROUND + EAR + NOTCHED)) {
            double exposure = powered(sensors, cells(10, 45))
                    .from(SOUTH_EAST)
                    .orElseThrow()
                    .exposure();
            assertThat(exposure).as(sensors).isGreaterThanOrEqualTo(0.99 * before);
            before = exposure;
        }
        assertThat(before).isPositive();
    }

    /** Straight flight over the plain: the time from a node is its distance, over directions of the grid. */
    @Test
    void theTimeToGoIsThatOfTheFastestFlight() throws IOException {
        TimeToGo time = powered(NEAR, cells(30)).timeToGo();

        double east = time.at(19, 10).orElseThrow();
        assertThat(east).isBetween((237.5 - 25.0 - 25.0) / 12.0, 237.5 / 12.0);
        assertThat(time.at(10, 10)).hasValue(0.0);
        assertThat(time.at(time.grid().node(19, 10, 0))).hasValue(east);
    }
}
