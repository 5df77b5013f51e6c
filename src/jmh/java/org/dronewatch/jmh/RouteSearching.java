package org.dronewatch.jmh;

import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.route.exposure.ExposureField;
import org.dronewatch.route.exposure.LegMotion;
import org.dronewatch.route.search.PlanDirections;
import org.dronewatch.route.search.RouteGrid;
import org.dronewatch.route.search.RouteMode;
import org.dronewatch.route.search.RouteProblem;
import org.dronewatch.route.search.WeakestRoute;
import org.dronewatch.route.search.WeakestRoutes;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Time to find the weakest route with its bracket: 13 sensors that see radial flight better, 12 heights, 16 headings,
 * and turns of a radius of 34 m; 200 cells of 10 m along a side make 2 x 2 km.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.SECONDS)
@Fork(value = 1, jvmArgsAppend = "-Xmx2g")
@Warmup(iterations = 1)
@Measurement(iterations = 3)
public class RouteSearching {
    private static final int SENSORS = 13;
    private static final double CELL = 10.0;
    private static final double ZONE = 60.0;
    private static final double RESPONSE = 20.0;
    private static final double[] HEIGHTS = {10, 20, 30, 40, 50, 60, 75, 90, 105, 120, 135, 150};

    /** Cells along a side. */
    @Param({"50", "100", "200"})
    public int cells;

    /** On which search and bound run. */
    @Param({"1", "2"})
    public int threads;

    private RouteProblem problem;
    private Workers workers;

    /** A sensor on the ground whose rate falls with the square of the distance. */
    private record Directed(double x, double y) implements ExposureField {
        private static final double STRENGTH = 2000.0;
        private static final double ACROSS = 0.2;

        @Override
        public double rate(double east, double north, double up, LegMotion motion, int mode) {
            double dx = east - x;
            double dy = north - y;
            double square = dx * dx + dy * dy + up * up + 1.0;
            double radial = dx * Math.sin(motion.heading()) + dy * Math.cos(motion.heading());
            return STRENGTH / square * (ACROSS + (1.0 - ACROSS) * radial * radial / square);
        }

        @Override
        public double least(Position low, Position high, int mode) {
            double dx = Math.max(x - low.x(), high.x() - x);
            double dy = Math.max(y - low.y(), high.y() - y);
            return ACROSS * STRENGTH / (dx * dx + dy * dy + high.z() * high.z() + 1.0);
        }
    }

    /** Sets the sensors up. */
    @Setup
    public void place() {
        double half = 0.5 * CELL * (cells - 1);
        RouteGrid grid = RouteGrid.level(-half, -half, CELL, cells, cells, HEIGHTS);
        SplittableRandom random = new SplittableRandom(1);
        Map<String, ExposureField> sensors = new HashMap<>();
        for (int i = 0; i < SENSORS; i++) {
            sensors.put(
                    "sensor " + i,
                    new Directed(half * (random.nextDouble() - 0.5), half * (random.nextDouble() - 0.5)));
        }
        BitSet starts = new BitSet();
        BitSet goals = new BitSet();
        for (int node = 0; node < grid.size(); node++) {
            double east = Math.abs(grid.x(node));
            double north = Math.abs(grid.y(node));
            starts.set(node, Math.max(east, north) > half - 0.5 * CELL);
            goals.set(node, Math.hypot(east, north) < ZONE);
        }
        workers = new Workers(threads);
        RouteMode powered = new RouteMode("powered", 20.0, 5.0, 5.0, Double.POSITIVE_INFINITY);
        problem = new RouteProblem(
                grid, ExposureField.ofSensors(sensors), List.of(powered), 34.0, PlanDirections.of(16), starts, goals);
    }

    /** Search, lower bound and smoothing of one route. */
    @Benchmark
    public WeakestRoute weakestRoute() {
        return workers.call(() -> WeakestRoutes.of(problem, problem.goals())
                .from(problem.starts())
                .orElseThrow());
    }

    /** The same, but only detections at least 20 s before the drone arrives count. */
    @Benchmark
    public WeakestRoute weakestRouteInTime() {
        return workers.call(() -> WeakestRoutes.inTime(problem, problem.goals(), RESPONSE)
                .from(problem.starts())
                .orElseThrow());
    }

    /** Ends the threads. */
    @TearDown
    public void close() {
        workers.close();
    }
}
