package org.dronewatch.route.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.BitSet;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.DoubleFunction;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.exposure.ExposureField;
import org.dronewatch.route.exposure.LegMotion;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * A strip of 40 m, in which a drone is seen at 10 m/s, but not at 1 m/s. At every price of time, either speed is the
 * better one all the way, so that only hastened routes use the whole endurance.
 */
class EnduranceLimitTest {
    private static final double FAST = 10.0;
    private static final double SLOW = 1.0;
    private static final double LENGTH = 40.0;
    private static final double RATE = 2.0;

    /** Seen from the beginning of the strip on, m. */
    private record Seen(double from) implements ExposureField {
        @Override
        public double rate(double x, double y, double z, LegMotion motion, int mode) {
            return mode == 0 && x > from ? RATE : 0.0;
        }

        @Override
        public double mean(Position begin, Position end, LegMotion motion, int mode, double longest) {
            double length = end.x() - begin.x();
            double seen = Math.max(0.0, end.x() - from) - Math.max(0.0, begin.x() - from);
            return length == 0.0 ? rate(begin.x(), 0.0, 0.0, motion, mode) : mode == 0 ? RATE * seen / length : 0.0;
        }

        @Override
        public double least(Position low, Position high, int mode) {
            return mode == 0 && low.x() > from ? RATE : 0.0;
        }
    }

    private final RouteGrid grid = RouteGrid.level(0.0, -1.0, 1.0, 41, 3, 10.0);
    private final AtomicInteger searches = new AtomicInteger();

    private RouteProblem problem(double from) {
        return new RouteProblem(
                grid,
                new Seen(from),
                List.of(RouteMode.free("powered", FAST), RouteMode.free("slow", SLOW)),
                0.0,
                PlanDirections.of(16),
                node(0),
                node(40));
    }

    private BitSet node(int column) {
        BitSet node = new BitSet();
        node.set(grid.node(column, 1, 0));
        return node;
    }

    private EnduranceLimit limit(RouteProblem problem, double seconds) {
        DoubleFunction<WeakestRoutes> search = price -> {
            searches.incrementAndGet();
            return WeakestRoutes.of(problem, problem.goals(), price);
        };
        return new EnduranceLimit(problem, seconds, search);
    }

    /**
     * The time at full speed where the drone is seen, {@code t = (L - u T) / (v - u)}, for the length L that is left of
     * the strip and the time T that is left of the endurance after what is not seen at full speed.
     */
    @ParameterizedTest
    @CsvSource({"0, 20", "0, 4.5", "0, 39", "20.5, 20", "20.5, 6"})
    void theEnduranceIsUsedForSlowFlight(double from, double endurance) {
        RouteProblem problem = problem(from);
        WeakestRoute free =
                WeakestRoutes.of(problem, problem.goals()).from(node(0)).orElseThrow();
        EnduranceLimit limit = limit(problem, endurance);

        WeakestRoute limited = limit.from(node(0), free).orElseThrow();

        double expected = RATE * (LENGTH - from - SLOW * (endurance - from / FAST)) / (FAST - SLOW);
        assertThat(free.exposure()).isZero();
        assertThat(limit.allows(free)).isFalse();
        assertThat(limited.seconds()).isLessThanOrEqualTo(endurance).isCloseTo(endurance, within(1e-5));
        assertThat(limited.exposure()).isCloseTo(expected, within(1e-3 * expected + 1e-5));
        assertThat(limited.lower()).isLessThanOrEqualTo(expected);
    }

    @Test
    void searchesServeAllStarts() {
        RouteProblem problem = problem(0.0);
        WeakestRoute free =
                WeakestRoutes.of(problem, problem.goals()).from(node(0)).orElseThrow();
        EnduranceLimit limit = limit(problem, 20.0);
        WeakestRoute first = limit.from(node(0), free).orElseThrow();
        int once = searches.get();

        assertThat(limit.from(node(0), free)).contains(first);
        assertThat(searches).hasValue(once);
    }
}
