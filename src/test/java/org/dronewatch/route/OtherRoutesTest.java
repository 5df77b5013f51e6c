package org.dronewatch.route;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.search.RouteExposure;
import org.dronewatch.route.search.RouteMode;
import org.dronewatch.route.search.RoutePath;
import org.dronewatch.route.search.WeakestRoute;
import org.dronewatch.world.Visibility;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Among four boxes, past radars that leave detections to chance: no other route, random or beside the weakest, is less
 * exposed than the weakest one by more than 1 %, nor less than the lower bound at all.
 */
class OtherRoutesTest {
    private static final double CELL = 20.0;
    private static final double HALF = 250.0;
    private static final FieldGrid GRID = new FieldGrid(0, 0, 2 * HALF, CELL, List.of(10.0, 26.0, 60.0));
    private static final double ZONE = 30.0;
    private static final int ROUTES = LongForm.count(200, 5000);

    private static final String SENSORS =
            """
              one: {kind: radar, position: [30, 0, 4], minRange: 1, maxRange: 900, elevationWidth: 90 deg, minSpeed: 0 m/s,
                budget: {range: 90, crossSection: 0.01}, detection: {kind: chance, pulses: 8}}
              other: {kind: radar, position: [-60, 90, 25], minRange: 1, maxRange: 900, elevationWidth: 90 deg, minSpeed: 0 m/s,
                budget: {range: 80, crossSection: 0.01}, detection: {kind: chance, pulses: 8}}
            alert: {protect: {centre: [0, 0, 10], radius: 30}}
            """;

    @TempDir
    private Path directory;

    private DetectionField field;
    private RouteExposure exposure;
    private SiteRoutes routes;
    private Visibility visibility;

    @BeforeEach
    void search() throws IOException {
        FieldSite site = FieldSite.in(directory, SENSORS);
        DroneSettings drone = site.settings().drones().get(FieldSite.DRONE);
        field = site.field(GRID, 2);
        FieldExposure rates = FieldExposure.of(ModeField.powered(field, drone), site.settings());
        RouteMode powered = RouteMode.powered(drone.flightLimits(), drone.speed());
        exposure = new RouteExposure(rates, List.of(powered), 0.5 * CELL);
        routes = SiteRoutes.of(field, site.settings(), site.stage(), FieldSite.DRONE);
        visibility = new Visibility(site.stage().world());
    }

    /** In the middle of a cell on the edge, in one of the sectors. */
    private static Position start(int sector, SplittableRandom random) {
        while (true) {
            double along = HALF - CELL * (0.5 + random.nextInt((int) (2 * HALF / CELL)));
            double edge = (random.nextBoolean() ? 1.0 : -1.0) * (HALF - 0.5 * CELL);
            boolean isEast = random.nextBoolean();
            Position at = new Position(
                    isEast ? edge : along, isEast ? along : edge, GRID.heights().get(random.nextInt(3)));
            double off = Math.IEEEremainder(Math.atan2(at.x(), at.y()) - sector * Math.PI / 4, 2.0 * Math.PI);
            if (Math.abs(off) < Math.PI / 8) {
                return at;
            }
        }
    }

    /** From the start over up to three places to the zone. */
    private static List<Position> anywhere(int sector, SplittableRandom random) {
        List<Position> points = new ArrayList<>(List.of(start(sector, random)));
        for (int i = random.nextInt(4); i > 0; i--) {
            points.add(new Position(
                    2 * HALF * (random.nextDouble() - 0.5),
                    2 * HALF * (random.nextDouble() - 0.5),
                    10.0 + 50.0 * random.nextDouble()));
        }
        double bearing = 2.0 * Math.PI * random.nextDouble();
        points.add(new Position(0.9 * ZONE * Math.sin(bearing), 0.9 * ZONE * Math.cos(bearing), 10.0));
        return points;
    }

    /** The same corners, moved by up to two cells, but for the first and the last. */
    private static List<Position> beside(RoutePath path, SplittableRandom random) {
        double most = 2.0 * CELL * random.nextDouble();
        List<Position> points = new ArrayList<>(path.points());
        for (int i = 1; i < points.size() - 1; i++) {
            Position at = points.get(i);
            points.set(
                    i,
                    new Position(
                            at.x() + most * (2.0 * random.nextDouble() - 1.0),
                            at.y() + most * (2.0 * random.nextDouble() - 1.0),
                            Math.max(10.0, Math.min(60.0, at.z() + most * (random.nextDouble() - 0.5)))));
        }
        return points;
    }

    /** Whether nothing solid is in the way, nor a cell whose middle is solid, of which the field knows nothing. */
    private boolean isFree(List<Position> points) {
        FieldCells cells = new FieldCells(field);
        for (int i = 1; i < points.size(); i++) {
            Position from = points.get(i - 1);
            Position leg = points.get(i).minus(from);
            int pieces = (int) Math.ceil(leg.length() / 2.0);
            for (int piece = 0; piece <= pieces; piece++) {
                Position at = from.plus(leg.times((double) piece / Math.max(1, pieces)));
                int column = (int) Math.rint(cells.column(at.x()));
                int row = (int) Math.rint(cells.row(at.y()));
                int level = (int) Math.rint(cells.level(column, row, at.z()));
                if (!field.isOpen(level, column, row)) {
                    return false;
                }
            }
            if (!visibility.isFree(from, points.get(i))) {
                return false;
            }
        }
        return true;
    }

    private double along(List<Position> points) {
        return exposure.along(new RoutePath(points, Collections.nCopies(points.size() - 1, 0)));
    }

    @Thorough
    @Test
    void noOtherRouteIsLessExposed() {
        long seed = LongForm.seed(41);
        SplittableRandom random = new SplittableRandom(seed);
        for (int sector = 0; sector < SiteRoutes.SECTORS; sector++) {
            WeakestRoute weakest = routes.from(sector).orElseThrow();
            double nearest = Double.POSITIVE_INFINITY;
            assertThat(weakest.exposure()).isGreaterThan(0.01);
            assertThat(along(weakest.path().points())).isLessThan(1.001 * weakest.exposure());
            for (int tried = 0; tried < ROUTES; ) {
                List<Position> points = tried % 2 == 0 ? anywhere(sector, random) : beside(weakest.path(), random);
                if (isFree(points)) {
                    tried++;
                    double other = along(points);
                    nearest = Math.min(nearest, other / weakest.exposure());
                    assertThat(other)
                            .as("seed %d, sector %d, %s", seed, sector, points)
                            .isGreaterThan(weakest.lower())
                            .isGreaterThan(0.99 * weakest.exposure());
                }
            }
            System.out.printf("OtherRoutesTest: sector %d, least of %d others %.4f%n", sector, ROUTES, nearest);
        }
    }
}
