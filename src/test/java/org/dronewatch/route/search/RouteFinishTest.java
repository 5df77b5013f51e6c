package org.dronewatch.route.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.BitSet;
import java.util.List;
import org.dronewatch.fusion.ProtectedZone;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.exposure.ExposureField;
import org.dronewatch.route.exposure.LegMotion;
import org.dronewatch.route.exposure.SummedExposure;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** After the critical detection point, a drone that sinks slowly reaches a ball as soon as it can. */
class RouteFinishTest {
    private static final double RADIUS = 60.0;
    private static final double RESPONSE = 10.0;
    private static final double LOWEST = 10.0;
    private static final RouteMode SLOW_TO_SINK = new RouteMode("flight", 15.0, 3.0, 1.5, Double.POSITIVE_INFINITY);
    private static final ProtectedZone ZONE = new ProtectedZone(new Position(0, 0, 0), RADIUS);
    private static final RouteGrid GRID =
            RouteGrid.level(-400.0, -400.0, 20.0, 41, 41, LOWEST, 30.0, 60.0, 90.0, 120.0);

    private static final Position ZERO = new Position(0.0, 0.0, 0.0);

    private static RouteProblem problem(double turnRadius, int directions) {
        BitSet starts = new BitSet();
        starts.set(0, GRID.size());
        BitSet goals = new BitSet();
        for (int node = 0; node < GRID.size(); node++) {
            goals.set(node, ZONE.distance(GRID.position(node)) == 0.0);
        }
        ExposureField sensor = new PointExposure(new Position(0, 0, 0), 1000.0, 2);
        return new RouteProblem(
                GRID, sensor, List.of(SLOW_TO_SINK), turnRadius, PlanDirections.of(directions), starts, goals);
    }

    private static WeakestRoutes routes(RouteProblem problem) {
        BitSet reached = CubeSlopes.around(GRID, problem.goals());
        return WeakestRoutes.inTime(problem, reached, RESPONSE, 1e-6, ZONE::entry);
    }

    private static WeakestRoute from(RouteProblem problem, double x, double y, double z) {
        BitSet start = new BitSet();
        start.set(GRID.nearest(new Position(x, y, z)));
        return routes(problem).from(start).orElseThrow();
    }

    /** The least time to the ball, straight to the best of all heights at which it can be entered, every centimetre. */
    private static double least(Position from) {
        double horizontal = Math.hypot(from.x(), from.y());
        double least = Double.POSITIVE_INFINITY;
        for (double height = LOWEST; height < RADIUS; height += 0.01) {
            double along = Math.max(0.0, horizontal - Math.sqrt(RADIUS * RADIUS - height * height));
            least = Math.min(least, SLOW_TO_SINK.time(along, height - from.z()));
        }
        return least;
    }

    @ParameterizedTest
    @CsvSource({"30, 400, 60", "400, 150, 120", "-300, -400, 10", "-400, 20, 90"})
    void theDroneCannotArriveSoonerAfterTheLatestDetectionInTime(double x, double y, double z) {
        RouteProblem problem = problem(0.0, 48);
        WeakestRoute route = from(problem, x, y, z);
        RouteFinish finish =
                new RouteFinish(problem.withField(new SummedExposure(List.of(), 1.0)), ZONE::entry, RESPONSE);
        RoutePath counted = finish.counted(route.path());
        Position latest = counted.points().get(counted.points().size() - 1);
        Position end = route.path().points().get(route.path().points().size() - 1);

        assertThat(least(latest)).isBetween(RESPONSE - 0.1, RESPONSE + 1e-3);
        assertThat(ZONE.distance(end)).isZero();
        assertThat(end.length()).isCloseTo(RADIUS, within(0.1));
        assertThat(route.lower()).isLessThanOrEqualTo(route.exposure());
    }

    /** Where it decides whether a detection is in time; farther away, the flight is to a node in the zone. */
    @Test
    void theTimeToGoIsThatOfAStraightFlight() {
        TimeToGo times = routes(problem(0.0, 48)).timeToGo();
        for (int node = 0; node < GRID.size(); node++) {
            Position at = GRID.position(node);
            double least = least(at);
            if (ZONE.distance(at) > 0.0) {
                double excess = least < 1.1 * RESPONSE ? 0.05 : Double.POSITIVE_INFINITY;
                assertThat(times.at(node).orElseThrow()).as("%s", at).isBetween(least - 1e-3, least + excess);
            }
        }
    }

    /** Blind to flight at right angles to the line of sight, so that routes have many turns. */
    private record Blind() implements ExposureField {
        @Override
        public double rate(double x, double y, double z, LegMotion motion, int mode) {
            double distance = Math.hypot(x, y) + 1.0;
            double radial = x * Math.sin(motion.heading()) + y * Math.cos(motion.heading());
            return Math.abs(radial) < 0.2 * distance ? 0.0 : 1e4 / (distance * distance);
        }

        @Override
        public double least(Position low, Position high, int mode) {
            return 0.0;
        }
    }

    /** From many places; only the last leg may be cut short where it arrives. */
    @ParameterizedTest
    @CsvSource({"40, 16", "30, 48"})
    void turnsKeepTheirRoom(double turnRadius, int directions) {
        RouteProblem problem = problem(turnRadius, directions).withField(new Blind());
        WeakestRoutes routes = routes(problem);
        LegLimits limits = new LegLimits(problem);
        int turns = 0;
        for (int node = 5; node < GRID.size(); node += GRID.size() / 13) {
            BitSet start = new BitSet();
            start.set(node);
            RoutePath path = routes.from(start).map(WeakestRoute::path).orElse(new RoutePath(List.of(ZERO), List.of()));
            for (int i = 1; i < path.modes().size() - 1; i++) {
                Position in = path.points().get(i).minus(path.points().get(i - 1));
                Position out = path.points().get(i + 1).minus(path.points().get(i));
                assertThat(limits.isTurnable(in.x(), in.y(), out.x(), out.y()))
                        .as(
                                "from %s, at %s",
                                path.points().get(0), path.points().get(i))
                        .isTrue();
                turns++;
            }
        }
        assertThat(turns).isGreaterThan(30);
    }
}
