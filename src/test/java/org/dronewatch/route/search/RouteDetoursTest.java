package org.dronewatch.route.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.BitSet;
import java.util.List;
import java.util.stream.IntStream;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.exposure.ExposureField;
import org.dronewatch.route.exposure.LegMotion;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * A square of 400 m with nodes 10 m apart, where a drone at 10 m/s is exposed to 1/s everywhere but in a lane, 1 m
 * wide, on its way from the west straight to the east: it lies between the nodes, so that the search over them does
 * not see it, and smoothing does not come upon it.
 */
class RouteDetoursTest {
    private static final double SPEED = 10.0;
    private static final double LANE = 3.5;

    /** The lane begins and ends 10 m from the edge. */
    private static final double END = 190.0;

    private static final RouteGrid GRID = RouteGrid.level(-200, -200, 10, 41, 41, 30);

    /** The way to the lane, along it, and on to the goal: exposed to 10.6 m at either end. */
    private static final RoutePath ALONG =
            new RoutePath(List.of(at(-200, 0), at(-END, LANE), at(END, LANE), at(200, 0)), List.of(0, 0, 0));

    private static final double EITHER_END = Math.hypot(10.0, LANE) / SPEED;

    private record Lane() implements ExposureField {
        @Override
        public double rate(double x, double y, double z, LegMotion motion, int mode) {
            boolean isInside = Math.abs(y - LANE) <= 0.5 && Math.abs(x) <= END;
            return isInside && Math.abs(motion.heading() - 0.5 * Math.PI) < 1e-3 ? 0.0 : 1.0;
        }

        @Override
        public double least(Position low, Position high, int mode) {
            return 0.0;
        }
    }

    private static Position at(double x, double y) {
        return new Position(x, y, 30);
    }

    private static BitSet node(double x, double y) {
        BitSet nodes = new BitSet();
        nodes.set(GRID.nearest(at(x, y)));
        return nodes;
    }

    private static RouteProblem problem(double turnRadius, BitSet starts) {
        RouteMode powered = new RouteMode("powered", SPEED, 3.0, 3.0, Double.POSITIVE_INFINITY);
        return new RouteProblem(
                GRID, new Lane(), List.of(powered), turnRadius, PlanDirections.of(16), starts, node(200, 0));
    }

    /** From far in the north-west, 176 m to the beginning of the lane, instead of 438 m straight to the goal. */
    @ParameterizedTest
    @ValueSource(doubles = {0.0, 12.0})
    void aRouteGoesFarRoundToALessExposedOne(double turnRadius) {
        RouteProblem problem = problem(turnRadius, node(-200, 180));
        WeakestRoutes search = WeakestRoutes.of(problem, problem.goals());
        WeakestRoute own = search.from(problem.starts()).orElseThrow();
        WeakestRoute along = search.described(ALONG, 0.0);

        List<WeakestRoute> better =
                JoinedRoutes.of(search, List.of(own, along), List.of(problem.starts(), node(-200, 0)), route -> true);
        List<WeakestRoute> nearby =
                JoinedRoutes.of(search, List.of(own, along), List.of(new BitSet(), new BitSet()), route -> true);

        double least = Math.hypot(END - 200.0, 180.0 - LANE - 0.5) / SPEED + EITHER_END;
        assertThat(own.exposure()).isBetween(Math.hypot(400.0, 180.0) / SPEED - EITHER_END, 48.0);
        assertThat(better.get(0).exposure()).isBetween(0.95 * least, 1.1 * least);
        assertThat(better.get(0).path().points().get(0)).isEqualTo(at(-200, 180));
        assertThat(better.get(0).lower()).isEqualTo(own.lower());
        assertFlyable(better.get(0).path(), problem);
        assertThat(better.get(1).exposure()).isLessThanOrEqualTo(along.exposure());
        assertThat(nearby.get(0)).as("by short legs alone").isEqualTo(own);
    }

    private static void assertFlyable(RoutePath path, RouteProblem problem) {
        LegLimits limits = new LegLimits(problem);
        List<Position> points = path.points();
        assertThat(IntStream.range(1, points.size() - 1)).allMatch(i -> {
            Position in = points.get(i).minus(points.get(i - 1));
            Position out = points.get(i + 1).minus(points.get(i));
            return limits.isTurnable(in.x(), in.y(), out.x(), out.y());
        });
    }

    /** A route that begins where the known one does has no way to go. */
    @Test
    void aRouteNeedsNoDetourToItself() {
        RouteProblem problem = problem(0.0, node(-200, 0));
        RoutePath straight = new RoutePath(List.of(at(-200, 0), at(200, 0)), List.of(0));
        RouteDetours detours = new RouteDetours(problem, List.of(straight));

        assertThat(detours.from(problem.starts())).isEmpty();
        assertThat(detours.from(node(-200, 100)).orElseThrow().way().length()).isCloseTo(100.0, within(1e-9));
    }

    @Test
    void theLaneIsOnlyExposedAtItsEnds() {
        assertThat(new RouteExposure(problem(0.0, node(-200, 0))).along(ALONG))
                .isCloseTo(2.0 * EITHER_END, within(1e-9));
    }
}
