package org.dronewatch.route;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.SplittableRandom;
import org.dronewatch.analysis.field.Course;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldGrid;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightState;
import org.dronewatch.fusion.AreaZone;
import org.dronewatch.fusion.ProtectedArea;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.search.LegMotion;
import org.dronewatch.route.search.RouteExposure;
import org.dronewatch.route.search.RouteMode;
import org.dronewatch.route.search.RoutePath;
import org.dronewatch.route.search.WeakestRoute;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.Cause;
import org.dronewatch.world.GroundPoint;
import org.dronewatch.world.Visibility;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Before a radar that looks once a second, detects within 150 m what moves radially, and sees nothing behind boxes. */
class SiteRoutesTest {
    private static final FieldGrid GRID = new FieldGrid(0, 0, 500, 20, List.of(10.0, 26.0, 60.0));
    private static final Position RADAR = new Position(0, 0, 4);
    private static final double CERTAIN = -Math.log(1e-6);

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

    private FieldExposure exposure() {
        DroneSettings drone = site.settings().drones().get(FieldSite.DRONE);
        return FieldExposure.of(ModeField.powered(field, drone), site.settings());
    }

    private double rate() {
        return site.settings().enabledSensors().get("round").rate();
    }

    @Test
    void ratesAreThoseOfTheLooksInEveryCell() {
        FieldExposure exposure = exposure();
        long seed = 31;
        SplittableRandom random = new SplittableRandom(seed);
        int detecting = 0;
        for (int i = 0; i < 2000; i++) {
            int level = random.nextInt(3);
            int column = random.nextInt(25);
            int row = random.nextInt(25);
            int course = random.nextInt(8);
            Position at = field.middle(level, column, row);
            double found = exposure.rate(at.x(), at.y(), at.z(), 2.0 * Math.PI * course / 8, 0);
            int crossing = crossing(at, course);
            int steps = field.steps(0, level, column, row, crossing >= 0 ? crossing : course);
            double expected = steps == 250 ? rate() * CERTAIN : -rate() * Math.log(1.0 - steps / 250.0);
            assertThat(found).as("seed %d, cell %d", seed, i).isCloseTo(expected, within(1e-6 * (1.0 + expected)));
            Position edge = new Position(at.x() + 9.9, at.y() - 9.9, at.z());
            assertThat(exposure.least(at, edge, 0)).isLessThanOrEqualTo(found);
            detecting += found > 0.0 ? 1 : 0;
        }
        assertThat(detecting).isBetween(200, 1800);
    }

    /** On both courses across its line of sight, the radar is blind; elsewhere it is not. */
    @Test
    void aCourseAcrossTheLineOfSightHasItsOwnRate() {
        FieldExposure exposure = exposure();
        double bearing = Math.atan2(90.0, -50.0);
        for (double side = -1.0; side <= 1.0; side += 2.0) {
            double across = bearing + side * Math.PI / 2;
            assertThat(exposure.rate(90.0, -50.0, 60.0, across, 0)).isEqualTo(0.0);
            assertThat(exposure.rate(90.0, -50.0, 60.0, across + Math.toRadians(4.9), 0))
                    .isEqualTo(0.0);
        }
        assertThat(exposure.rate(90.0, -50.0, 60.0, bearing, 0)).isCloseTo(rate() * CERTAIN, within(1e-6));
    }

    /** At any position, heading, speed and climb, in cells that are in sight: as if the drone were assessed there. */
    @Test
    void aRadarIsBlindExactlyWhereTheRadialSpeedIsTooLow() {
        FieldExposure exposure = exposure();
        Assessor assessor = new Assessor(
                "round",
                site.settings().enabledSensors().get("round"),
                site.stage().world());
        Drone drone = DetectionField.droneOf(site.stage(), FieldSite.DRONE);
        SplittableRandom random = new SplittableRandom(5);
        int blind = 0;
        int compared = 0;
        while (compared < 1500) {
            int level = random.nextInt(3);
            Position at = field.middle(level, random.nextInt(25), random.nextInt(25))
                    .plus(new Position(random.nextDouble(), random.nextDouble(), random.nextDouble()).times(9.0));
            Position away = at.minus(RADAR).unit().times(12.0);
            LegMotion receding = LegMotion.along(away.x(), away.y(), away.z(), 1.0);
            double heading = 2.0 * Math.PI * random.nextDouble();
            double speed = 4.0 + 8.0 * random.nextDouble();
            LegMotion motion = LegMotion.along(
                    speed * Math.sin(heading), speed * Math.cos(heading), 6.0 * (random.nextDouble() - 0.5), 1.0);
            boolean isSeen = exposure.rate(at.x(), at.y(), at.z(), receding, 0) > 0.0
                    && isDetected(assessor, drone, at, receding);
            if (isSeen) {
                boolean isExpected = isDetected(assessor, drone, at, motion);
                assertThat(exposure.rate(at.x(), at.y(), at.z(), motion, 0))
                        .as("%s, %s", at, motion)
                        .isCloseTo(isExpected ? rate() * CERTAIN : 0.0, within(1e-6));
                blind += isExpected ? 0 : 1;
                compared++;
            }
        }
        assertThat(blind).isBetween(300, 1000);
    }

    /** Coming closer by less than 3 m/s, a drone at 12 m/s is never detected: the lower bound of 0 is reached. */
    @Test
    void aSpiralRoundARadarIsNotExposed() {
        RouteMode mode = RouteMode.free("powered", 12.0);
        RouteExposure exposure = new RouteExposure(exposure(), List.of(mode), 1.0);
        List<Position> spiral = new ArrayList<>();
        double bearing = 0.0;
        for (double radius = 145.0; radius > 40.0; radius -= 0.5) {
            spiral.add(new Position(radius * Math.sin(bearing), radius * Math.cos(bearing), 26.0));
            bearing += 4.0 / radius;
        }
        double straight = exposure.leg(spiral.get(0), spiral.get(spiral.size() - 1), 0);
        assertThat(straight).isGreaterThan(20.0);
        assertThat(exposure.along(new RoutePath(spiral, Collections.nCopies(spiral.size() - 1, 0))))
                .isZero();
    }

    private static boolean isDetected(Assessor assessor, Drone drone, Position at, LegMotion motion) {
        Position velocity = new Position(motion.east(), motion.north(), motion.up());
        return assessor.assess(
                        drone.at(new FlightState(at, velocity, motion.heading())), Optional.empty(), new Random(0))
                .cause()
                .equals(Cause.DETECTED);
    }

    /** Only a course that is exactly that of the compass is nearer than one across the line of sight. */
    private int crossing(Position at, int course) {
        double heading = 2.0 * Math.PI * course / 8;
        for (int i = 8; i < field.courses().size(); i++) {
            Course other = field.courses().get(i);
            double angle = Math.abs(Math.IEEEremainder(other.heading(at) - heading, 2.0 * Math.PI));
            if (other.kind() == Course.Kind.CROSSING && angle == 0.0) {
                return i;
            }
        }
        return -1;
    }

    @Test
    void theWeakestOfAllSectorsIsTheWeakestOfAll() {
        SiteRoutes routes = SiteRoutes.of(field, site.settings(), site.stage(), FieldSite.DRONE);
        WeakestRoute all = routes.fromAnywhere().orElseThrow();
        double weakest = Double.POSITIVE_INFINITY;
        for (int sector = 0; sector < SiteRoutes.SECTORS; sector++) {
            WeakestRoute route = routes.from(sector).orElseThrow();
            Position start = route.path().points().get(0);
            assertThat(Math.IEEEremainder(Math.atan2(start.x(), start.y()) - sector * Math.PI / 4, 2.0 * Math.PI))
                    .isBetween(-Math.PI / 8, Math.PI / 8);
            assertThat(route.lower()).isBetween(0.0, route.exposure());
            assertFlyable(route);
            weakest = Math.min(weakest, route.exposure());
        }
        assertThat(all.exposure()).isLessThanOrEqualTo(weakest * 1.01 + 1e-9);
    }

    /** The radar has one look at each route but that from the south-east, whatever the search says. */
    @Test
    void theWeakestIsThatOnWhichTheLooksDetectLeast() {
        SiteRoutes routes = SiteRoutes.of(field, site.settings(), site.stage(), FieldSite.DRONE);
        RouteSurvey searched = RouteSurvey.of(routes, 5.0, sector -> {}, () -> {});
        RouteSurvey flown = searched.with(
                searched.routes().stream()
                        .map(route -> route.with(new FlownExposure(
                                List.of(
                                        route.sector() == 3
                                                ? List.of()
                                                : List.of(new FlownExposure.Step(0.0, 1.0, 3.0))),
                                Map.of("round", route.sector() == 3 ? 0.0 : 3.0))))
                        .toList(),
                true);

        assertThat(flown.weakest().orElseThrow().sector()).isEqualTo(3);
        assertThat(flown.routes()).hasSize(8);
        for (SectorRoute route : flown.routes()) {
            double detected = route.sector() == 3 ? 0.0 : 1.0 - Math.exp(-3.0);
            assertThat(route.detection()).isCloseTo(detected, within(1e-12));
            assertThat(route.inTime(5.0)).isEqualTo(route.detection());
            assertThat(route.inTime(route.route().seconds() - 0.5)).isEqualTo(0.0);
            assertThat(route.profile().exposure()).isCloseTo(route.sector() == 3 ? 0.0 : 3.0, within(1e-12));
            assertThat(route.mostExposedTo().isPresent()).isEqualTo(route.sector() != 3);
            assertThat(route.isMisjudged(5.0))
                    .isEqualTo(Math.abs(detected - route.searched().detection()) > 0.2
                            || Math.abs(detected - route.route().detection()) > 0.2);
        }
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

    /** The zone is a ball of 30 m around the radar, and the lowest posts are in it. */
    @Test
    void aRouteEndsInTheZone() {
        SiteRoutes routes = SiteRoutes.of(field, site.settings(), site.stage(), FieldSite.DRONE);
        List<Position> points = routes.fromAnywhere().orElseThrow().path().points();
        assertThat(points.get(points.size() - 1).distance(new Position(0, 0, 10)))
                .isLessThanOrEqualTo(30.0);
    }

    @Test
    void routesBeginInTheirLaunchArea() {
        AreaZone launch =
                new AreaZone("field", ProtectedArea.circle(new GroundPoint(150.0, 120.0), 25.0, 10.0), 0.0, 0.0);
        SiteRoutes routes = SiteRoutes.of(field, site.settings(), site.stage(), FieldSite.DRONE, Optional.of(launch));
        Position start = routes.fromAnywhere().orElseThrow().path().points().get(0);
        assertThat(Math.hypot(start.x() - 150.0, start.y() - 120.0)).isLessThanOrEqualTo(25.0);
        assertThat(routes.from(1)).isPresent();
        assertThat(routes.from(5)).isEmpty();
    }

    /** The ground is 1000 m wide: beyond, there are cells, but no route begins there. */
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
        WeakestRoute route = routes.fromAnywhere().orElseThrow();
        RouteProfile profile = routes.profile(route);
        assertThat(profile.end().time()).isCloseTo(route.seconds(), within(1e-9));
        assertThat(profile.exposure()).isCloseTo(routes.bySensor(route).get("round"), within(1e-9));
        assertThat(profile.exposureUntil(route.seconds() - 5.0)).isGreaterThanOrEqualTo(route.exposure() - 1e-9);
    }

    /** Beyond its range, nothing is exposed; within it, the route hides behind boxes or crosses the line of sight. */
    @Test
    void theSensorSeesNoMoreThanTheWholeRoute() {
        SiteRoutes routes = SiteRoutes.of(field, site.settings(), site.stage(), FieldSite.DRONE);
        WeakestRoute route = routes.fromAnywhere().orElseThrow();
        FieldExposure exposure = exposure();

        assertThat(routes.bySensor(route)).containsOnlyKeys("round");
        assertThat(routes.bySensor(route).get("round")).isGreaterThanOrEqualTo(route.exposure() - 1e-9);
        Position start = route.path().points().get(0);
        assertThat(start.distance(RADAR)).isGreaterThan(150.0);
        assertThat(exposure.rate(start.x(), start.y(), start.z(), 0.0, 0)).isEqualTo(0.0);
    }
}
