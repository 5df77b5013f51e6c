package org.dronewatch.route;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.fusion.AreaZone;
import org.dronewatch.fusion.ProtectedArea;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.exposure.LegMotion;
import org.dronewatch.route.search.WeakestRoute;
import org.dronewatch.world.GroundPoint;
import org.dronewatch.world.Visibility;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Before a radar that looks once a second, detects within 150 m what moves radially, and sees nothing behind boxes. */
class SiteRoutesTest {
    private static final FieldGrid GRID = new FieldGrid(0, 0, 500, 20, List.of(10.0, 26.0, 60.0));
    private static final Position RADAR = new Position(0, 0, 4);

    @TempDir
    private Path directory;

    private FieldSite site;
    private DetectionField field;

    @BeforeEach
    void assess() throws IOException {
        site = FieldSite.in(
                directory, FieldSite.ROUND + "alert: {protect: {centre: [0, 0, 10], radius: 30}, response: 5 s}\n");
        field = site.field(GRID, 2);
    }

    private static WeakestRoute weakest(SiteRoutes routes) {
        return IntStream.range(0, SiteRoutes.SECTORS)
                .mapToObj(sector -> routes.from(sector).orElseThrow())
                .min(Comparator.comparingDouble(WeakestRoute::exposure))
                .orElseThrow();
    }

    @Test
    void eachRouteStartsInItsSector() {
        SiteRoutes routes = SiteRoutes.of(field, site.settings(), site.stage(), FieldSite.DRONE);
        for (int sector = 0; sector < SiteRoutes.SECTORS; sector++) {
            WeakestRoute route = routes.from(sector).orElseThrow();
            Position start = route.path().points().get(0);
            assertThat(Math.IEEEremainder(Math.atan2(start.x(), start.y()) - sector * Math.PI / 4, 2.0 * Math.PI))
                    .isBetween(-Math.PI / 8, Math.PI / 8);
            assertThat(route.lower()).isBetween(0.0, route.exposure());
            assertFlyable(route);
        }
    }

    /** The radar has one look at each route but that from the south-east, whatever the search says. */
    @Test
    void theWeakestIsThatOnWhichTheLooksDetectLeast() {
        RouteSurvey flown = flown(route -> new FlownExposure(
                List.of(route.sector() == 3 ? List.of() : List.of(new FlownExposure.Step(0.0, 1.0, 3.0))),
                Map.of("round", route.sector() == 3 ? 0.0 : 3.0)));

        assertThat(flown.weakest().orElseThrow().sector()).isEqualTo(3);
        assertThat(flown.routes()).hasSize(8);
        for (SectorRoute route : flown.routes()) {
            double detected = route.sector() == 3 ? 0.0 : 1.0 - Math.exp(-3.0);
            assertThat(route.detection()).isCloseTo(detected, within(1e-12));
            assertThat(route.inTime(5.0)).isEqualTo(route.detection());
            assertThat(route.inTime(route.route().seconds() - 0.5)).isEqualTo(0.0);
            assertThat(route.profile().exposure())
                    .isCloseTo(route.sector() == 3 ? 0.0 : -Math.expm1(-3.0), within(1e-12));
            assertThat(route.mostExposedTo().isPresent()).isEqualTo(route.sector() != 3);
            assertThat(route.isUnderestimated(5.0))
                    .isEqualTo(detected - route.route().detection() > 0.2);
            assertThat(route.isUnderestimated(0.0)).isEqualTo(route.isUnderestimated(5.0));
            double leastLikely = 1.0 - Math.exp(-route.route().lower());
            assertThat(route.isUnproven(5.0)).isEqualTo(detected > leastLikely + 0.2);
        }
    }

    /**
     * On all other routes, the radar is certain to detect the drone, but too late; on that from the south-west, it
     * hardly ever detects it, but if so, in time.
     */
    @Test
    void aRouteOnWhichTheDroneIsSurelyDetectedTooLateIsNotTheWeakest() {
        RouteSurvey flown = flown(route ->
                route.sector() == 5 ? seen(0.5, 4e-4) : seen(route.route().seconds() - 1.0, 10.0));

        assertThat(flown.weakest().orElseThrow().sector()).isEqualTo(5);
        for (SectorRoute route : flown.routes()) {
            assertThat(route.inTime(5.0) > 0.0).isEqualTo(route.sector() == 5);
        }
    }

    /**
     * From the south-west, one drone in a hundred is detected in time; from elsewhere, all are detected slightly too
     * late, but times vary, so that half of the alerts are in time.
     */
    @Thorough
    @Test
    void anAlertThatMayComeInTimeCounts() {
        RouteSurvey flown = flown(route -> route.sector() == 5
                ? seen(0.5, 0.01).withAlertInTime(OptionalDouble.of(0.01))
                : seen(route.route().seconds() - 4.9, 10.0).withAlertInTime(OptionalDouble.of(0.5)));

        assertThat(flown.isAlertKnown()).isTrue();
        assertThat(flown.weakest().orElseThrow().sector()).isEqualTo(5);
        assertThat(flown(route -> seen(0.5, 0.01)).isAlertKnown()).isFalse();
    }

    /** The routes of the site for a response of 5 s, as they are flown. */
    private RouteSurvey flown(Function<SectorRoute, FlownExposure> looks) {
        SiteRoutes routes = SiteRoutes.of(field, site.settings(), site.stage(), FieldSite.DRONE);
        RouteSurvey searched = RouteSurvey.of(routes, 5.0, sector -> {}, () -> {});
        return searched.with(
                searched.routes().stream()
                        .map(route -> route.with(looks.apply(route)))
                        .toList(),
                true);
    }

    /** By one look. */
    private static FlownExposure seen(double time, double exposure) {
        return new FlownExposure(
                List.of(List.of(new FlownExposure.Step(0.0, time, exposure))), Map.of("round", exposure));
    }

    /** They begin in the same sector, are no more exposed, and can still be flown. */
    @Test
    void routesThatJoinOthersAreNoMoreExposed() {
        SiteRoutes routes = SiteRoutes.of(field, site.settings(), site.stage(), FieldSite.DRONE);
        List<WeakestRoute> alone = IntStream.range(0, SiteRoutes.SECTORS)
                .mapToObj(sector -> routes.from(sector).orElseThrow())
                .toList();
        List<WeakestRoute> joined = routes.joined(alone);

        assertThat(joined).hasSameSizeAs(alone);
        for (int i = 0; i < joined.size(); i++) {
            WeakestRoute one = joined.get(i);
            assertThat(one.exposure()).isBetween(one.lower(), alone.get(i).exposure());
            Position start = one.path().points().get(0);
            assertThat(Math.IEEEremainder(Math.atan2(start.x(), start.y()) - i * Math.PI / 4, 2.0 * Math.PI))
                    .isBetween(-Math.PI / 8, Math.PI / 8);
            assertThat(one.lower()).isEqualTo(alone.get(i).lower());
            assertFlyable(one);
        }
    }

    /**
     * Past radars that are blind to crossing flight, smoothing ends in local minima from some directions, with
     * exposures of up to 97, while routes of hardly any exposure are near. Left out in the build: it takes 25 s.
     */
    @Test
    void someRoutesGainByJoiningOthers() throws IOException {
        assumeTrue(LongForm.IS_ON);
        String radar =
                """
                  NAME: {kind: radar, position: [AT, 4], minRange: 1, maxRange: 400, elevationWidth: 90 deg, rate: 2,
                    minSpeed: 2 m/s, budget: {range: 200, crossSection: 0.01}, detection: {kind: chance}}
                """;
        site = FieldSite.in(
                directory,
                radar.replace("NAME", "one").replace("AT", "0, 0")
                        + radar.replace("NAME", "other").replace("AT", "60, 40")
                        + "alert: {zones: {z: {centre: [0, 60], radius: 30 m, height: 40 m}}, response: 2 s}\n");
        field = site.field(new FieldGrid(0, 60, 500, 20, List.of(5.0, 15.0, 30.0, 50.0)), 2);
        SiteRoutes routes = SiteRoutes.of(field, site.settings(), site.stage(), FieldSite.DRONE);
        List<WeakestRoute> alone = IntStream.range(0, SiteRoutes.SECTORS)
                .mapToObj(sector -> routes.from(sector).orElseThrow())
                .toList();
        List<WeakestRoute> joined = routes.joined(alone);

        assertThat(IntStream.range(0, alone.size()))
                .as("directions that gain")
                .anyMatch(i -> alone.get(i).exposure() > 1.0
                        && joined.get(i).exposure() < 0.5 * alone.get(i).exposure());
    }

    /** It ends at the zone, stays between the heights of the field, and takes no less time than a drone needs. */
    private void assertFlyable(WeakestRoute route) {
        List<Position> points = route.path().points();
        assertThat(points.get(points.size() - 1).distance(new Position(0, 0, 10)))
                .isLessThanOrEqualTo(30.0 + GRID.cell() + 1e-9);
        assertThat(route.seconds()).isGreaterThan((250.0 - 50.0) / 12.0);
        for (int i = 1; i < points.size(); i++) {
            double rise = points.get(i).z() - points.get(i - 1).z();
            assertThat(Math.abs(rise) / 3.0).isLessThanOrEqualTo(route.seconds());
            assertThat(points.get(i).z()).isBetween(10.0 - 1e-6, 75.0 + 1e-6);
        }
    }

    /** The zone is a ball of 30 m around the radar, and the lowest nodes are in it. */
    @Test
    void aRouteEndsInTheZone() {
        SiteRoutes routes = SiteRoutes.of(field, site.settings(), site.stage(), FieldSite.DRONE);
        List<Position> points = weakest(routes).path().points();
        assertThat(points.get(points.size() - 1).distance(new Position(0, 0, 10)))
                .isLessThanOrEqualTo(30.0);
    }

    @Test
    void routesBeginInTheirLaunchArea() {
        AreaZone launch =
                new AreaZone("field", ProtectedArea.circle(new GroundPoint(150.0, 120.0), 25.0, 10.0), 0.0, 0.0);
        SiteRoutes routes = SiteRoutes.of(field, site.settings(), site.stage(), FieldSite.DRONE, Optional.of(launch));
        Position start = routes.from(1).orElseThrow().path().points().get(0);
        assertThat(Math.hypot(start.x() - 150.0, start.y() - 120.0)).isLessThanOrEqualTo(25.0);
        assertThat(routes.from(5)).isEmpty();
    }

    /** The ground is 1000 m wide: beyond, there are cells, but no route begins there. */
    @Thorough
    @Test
    void routesBeginWhereTheGroundEnds() {
        DetectionField wide = site.field(new FieldGrid(0, 0, 1400, 40, List.of(26.0)), 2);
        SiteRoutes routes = SiteRoutes.of(wide, site.settings(), site.stage(), FieldSite.DRONE);
        for (int sector = 0; sector < SiteRoutes.SECTORS; sector++) {
            Position start = routes.from(sector).orElseThrow().path().points().get(0);
            assertThat(Math.max(Math.abs(start.x()), Math.abs(start.y()))).isBetween(460.0, 500.0);
        }
    }

    /** Cells of 50 m do not show that the boxes reach into cells whose middle is open. */
    @Test
    void aRouteMeetsNothingSolid() {
        DetectionField coarse = site.field(new FieldGrid(0, 0, 500, 50, List.of(6.0, 12.0)), 2);
        SiteRoutes routes = SiteRoutes.of(coarse, site.settings(), site.stage(), FieldSite.DRONE);
        Visibility visibility = new Visibility(site.stage().world());
        for (int sector = 0; sector < SiteRoutes.SECTORS; sector++) {
            List<Position> points = routes.from(sector).orElseThrow().path().points();
            for (int i = 1; i < points.size(); i++) {
                assertThat(visibility.isFree(points.get(i - 1), points.get(i))).isTrue();
            }
        }
    }

    /** What counts is over when the response would come too late; the profile goes on to the zone. */
    @Test
    void theProfileIsThatOfTheWholeRoute() {
        SiteRoutes routes = SiteRoutes.of(field, site.settings(), site.stage(), FieldSite.DRONE);
        WeakestRoute route = weakest(routes);
        RouteProfile profile = routes.profile(route);
        assertThat(profile.end().time()).isCloseTo(route.seconds(), within(1e-9));
        assertThat(profile.exposure()).isCloseTo(routes.bySensor(route).get("round"), within(1e-9));
        assertThat(profile.exposureUntil(route.seconds() - 5.0)).isGreaterThanOrEqualTo(route.exposure() - 1e-9);
    }

    /** Beyond its range, nothing is exposed; within it, the route hides behind boxes or crosses the line of sight. */
    @Test
    void theSensorSeesNoMoreThanTheWholeRoute() {
        SiteRoutes routes = SiteRoutes.of(field, site.settings(), site.stage(), FieldSite.DRONE);
        WeakestRoute route = weakest(routes);
        DroneSettings drone = site.settings().drones().get(FieldSite.DRONE);
        FieldExposure exposure = FieldExposure.of(ModeField.powered(field, drone), site.settings());

        assertThat(routes.bySensor(route)).containsOnlyKeys("round");
        assertThat(routes.bySensor(route).get("round")).isGreaterThanOrEqualTo(route.exposure() - 1e-9);
        Position start = route.path().points().get(0);
        assertThat(start.distance(RADAR)).isGreaterThan(150.0);
        assertThat(exposure.rate(start.x(), start.y(), start.z(), LegMotion.along(0.0, 12.0, 0.0, 1.0), 0))
                .isEqualTo(0.0);
    }
}
