package org.dronewatch.route.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.BitSet;
import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.exposure.ExposureField;
import org.dronewatch.route.exposure.LegMotion;
import org.junit.jupiter.api.Test;

/** Where routes are equally exposed, the fastest of them is found, even if the caller gives time no price. */
class EqualExposureTest {
    private static final double SPEED = 10.0;
    private static final RouteGrid GRID = RouteGrid.level(0.0, 0.0, 5.0, 61, 41, 30.0);
    private static final Position GOAL = new Position(300.0, 150.0, 30.0);

    /** A strip from south to north: whoever crosses it at right angles is equally exposed, wherever that is. */
    private record Strip(double rate) implements ExposureField {
        @Override
        public double rate(double x, double y, double z, LegMotion motion, int mode) {
            return x >= 100.0 && x <= 120.0 ? rate : 0.0;
        }

        @Override
        public double mean(Position from, Position to, LegMotion motion, int mode, double longest) {
            double west = Math.min(from.x(), to.x());
            double east = Math.max(from.x(), to.x());
            double inside = Math.max(0.0, Math.min(east, 120.0) - Math.max(west, 100.0));
            return east > west ? rate * inside / (east - west) : rate(west, from.y(), from.z(), motion, mode);
        }

        @Override
        public double least(Position low, Position high, int mode) {
            return 0.0;
        }
    }

    private static RouteProblem problem(double rate) {
        BitSet starts = new BitSet();
        for (int row = 0; row < GRID.rows(); row++) {
            starts.set(GRID.node(0, row, 0));
        }
        BitSet goals = new BitSet();
        goals.set(GRID.nearest(GOAL));
        return new RouteProblem(
                GRID,
                new Strip(rate),
                List.of(RouteMode.free("flight", SPEED)),
                0.0,
                PlanDirections.of(32),
                starts,
                goals);
    }

    private static void assertStraight(WeakestRoute route) {
        assertThat(route.path().points().get(0).y()).isCloseTo(GOAL.y(), within(1e-9));
        assertThat(route.seconds()).isCloseTo(300.0 / SPEED, within(1e-6));
    }

    @Test
    void whereNothingDetectsTheDroneTheShortestRouteIsFound() {
        RouteProblem problem = problem(0.0);
        WeakestRoute route = WeakestRoutes.of(problem, problem.goals())
                .from(problem.starts())
                .orElseThrow();

        assertStraight(route);
        assertThat(route.exposure()).isZero();
    }

    @Test
    void amongEquallyExposedRoutesTheShortestIsFound() {
        RouteProblem problem = problem(2.0);
        WeakestRoute route = WeakestRoutes.of(problem, problem.goals())
                .from(problem.starts())
                .orElseThrow();

        assertStraight(route);
    }

    @Test
    void soItIsWhileADetectionIsInTime() {
        RouteProblem problem = problem(0.0);
        WeakestRoute route = WeakestRoutes.inTime(problem, problem.goals(), 10.0)
                .from(problem.starts())
                .orElseThrow();

        assertStraight(route);
    }
}
