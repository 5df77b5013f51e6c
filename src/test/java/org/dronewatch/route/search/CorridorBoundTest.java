package org.dronewatch.route.search;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.exposure.ExposureField;
import org.dronewatch.route.exposure.LegMotion;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Routes that are hardly longer than the straight line, between sets of nodes, past random sensors. */
class CorridorBoundTest {
    private static final long SEED = 20_261_128L;
    private static final int PROBLEMS = 300;
    private static final int ROUTES = 30;
    private static final List<RouteMode> MODES = List.of(RouteMode.free("slow", 1.0), RouteMode.free("fast", 2.0));

    private final Random random = new Random(SEED);
    private final RouteGrid grid = RouteGrid.level(-1.0, -1.0, 0.02, 101, 101, 0.0, 0.1, 0.2, 0.3);

    private RouteProblem problem(ExposureField field, BitSet starts, BitSet ends) {
        return new RouteProblem(grid, field, MODES, 0.0, PlanDirections.of(32), starts, ends);
    }

    private ExposureField sensors() {
        Map<String, ExposureField> sensors = new TreeMap<>();
        for (int i = 0; i <= random.nextInt(3); i++) {
            Position at = new Position(2.0 * random.nextDouble() - 1.0, 2.0 * random.nextDouble() - 1.0, -0.1);
            sensors.put("sensor " + i, new PointExposure(at, 1.0, 1 + random.nextInt(2)));
        }
        return ExposureField.ofSensors(sensors);
    }

    /** The nodes of a random block of up to two by two by two. */
    private BitSet block(int west, int east) {
        int column = west + random.nextInt(east - west);
        int row = random.nextInt(95);
        int level = random.nextInt(3);
        BitSet nodes = new BitSet();
        for (int k = level; k <= level + random.nextInt(2); k++) {
            for (int j = row; j <= row + random.nextInt(2); j++) {
                nodes.set(grid.node(column, j, k), grid.node(column + random.nextInt(2), j, k) + 1);
            }
        }
        return nodes;
    }

    private Position anyOf(BitSet nodes) {
        int[] all = nodes.stream().toArray();
        return grid.position(all[random.nextInt(all.length)]);
    }

    /** A point between two nodes at which a route may begin or end. */
    private Position between(BitSet nodes) {
        return mixed(anyOf(nodes), anyOf(nodes), random.nextDouble());
    }

    private static Position mixed(Position one, Position other, double part) {
        return new Position(
                one.x() + part * (other.x() - one.x()),
                one.y() + part * (other.y() - one.y()),
                one.z() + part * (other.z() - one.z()));
    }

    /** A route whose points lie off the straight line by at most a distance. */
    private List<Position> route(Position from, Position to, double off) {
        List<Position> points = new ArrayList<>(List.of(from));
        int bends = 1 + random.nextInt(4);
        for (int bend = 1; bend <= bends; bend++) {
            Position on = mixed(from, to, bend / (bends + 1.0));
            points.add(new Position(
                    on.x() + off * random.nextGaussian(),
                    on.y() + off * random.nextGaussian(),
                    on.z() + off * random.nextGaussian()));
        }
        points.add(to);
        return points;
    }

    private static double length(List<Position> points) {
        return IntStream.range(1, points.size())
                .mapToDouble(i -> points.get(i - 1).distance(points.get(i)))
                .sum();
    }

    private double exposure(ExposureField field, List<Position> points) {
        List<Integer> modes = IntStream.range(1, points.size())
                .mapToObj(i -> random.nextInt(MODES.size()))
                .toList();
        return new RouteExposure(field, MODES, 0.01).along(new RoutePath(points, modes));
    }

    @Test
    void noRouteThatIsShortEnoughIsLessExposed() {
        System.out.println("CorridorBoundTest: seed " + SEED);
        int compared = 0;
        int close = 0;
        for (int i = 0; i < PROBLEMS; i++) {
            ExposureField field = sensors();
            BitSet starts = block(0, 20);
            BitSet ends = block(75, 95);
            for (int k = 0; k < ROUTES; k++) {
                List<Position> route = route(between(starts), between(ends), 0.02 * random.nextDouble());
                double bound = new CorridorBound(problem(field, starts, ends), starts, ends, length(route)).exposure();
                double exposure = exposure(field, route);
                assertThat(exposure).isGreaterThanOrEqualTo(bound * (1.0 - 1e-9));
                compared += bound > 0.0 ? 1 : 0;
                close += exposure < 2.5 * bound ? 1 : 0;
            }
        }
        // A fifth of the corridors are narrow enough, and the faster mode has half the exposure of the slower one.
        assertThat(compared).isGreaterThan(PROBLEMS * ROUTES / 6);
        assertThat(close).isGreaterThan(PROBLEMS * ROUTES / 20);
    }

    @Test
    void ofAStraightLineTheBoundIsItsExposure() {
        for (int i = 0; i < PROBLEMS; i++) {
            ExposureField field = new PointExposure(new Position(0.0, -1.4, 0.0), 1.0, 2);
            BitSet start = new BitSet();
            start.set(grid.node(random.nextInt(20), 10 + random.nextInt(90), random.nextInt(4)));
            BitSet end = new BitSet();
            end.set(grid.node(75 + random.nextInt(20), 10 + random.nextInt(90), random.nextInt(4)));
            List<Position> line = List.of(anyOf(start), anyOf(end));
            double bound = new CorridorBound(problem(field, start, end), start, end, length(line)).exposure();

            double exposure = new RouteExposure(field, MODES, 0.01).along(new RoutePath(line, List.of(1)));
            assertThat(bound).isBetween(0.97 * exposure, exposure);
        }
    }

    /** A route that is as far off the straight line as its length allows leaves a tube that is a little thinner. */
    @ParameterizedTest
    @CsvSource({"0.03, 0, 0", "0, 0.05, 0", "0.05, 0.07, 0", "0.03, 0.03, 1", "0, 0.05, 1"})
    void theCorridorHoldsTheFarthestDetour(double north, double up, int more) {
        BitSet start = new BitSet();
        start.set(grid.node(10, 50, 2), grid.node(10 + more, 50, 2) + 1);
        BitSet end = new BitSet();
        end.set(grid.node(90, 50, 2));
        Position from = grid.position(start.nextSetBit(0));
        Position to = anyOf(end);
        Position middle = mixed(from, to, 0.5);
        List<Position> route = List.of(from, new Position(middle.x(), middle.y() + north, middle.z() + up), to);
        ExposureField tube = new Tube(from, 0.9 * Math.hypot(north, up));

        double bound = new CorridorBound(problem(tube, start, end), start, end, length(route)).exposure();
        double within = new CorridorBound(problem(tube, start, end), start, end, from.distance(to)).exposure();
        assertThat(exposure(tube, route)).isGreaterThanOrEqualTo(bound);
        assertThat(bound).isZero();
        assertThat(within > 0.0).isEqualTo(more == 0);
    }

    /**
     * A rate of 1/s inside a tube, and 0 outside.
     *
     * @param on a point on its axis, which runs from west to east
     * @param radius its radius, m
     */
    private record Tube(Position on, double radius) implements ExposureField {
        @Override
        public double rate(double x, double y, double z, LegMotion motion, int mode) {
            return Math.hypot(y - on.y(), z - on.z()) <= radius ? 1.0 : 0.0;
        }

        @Override
        public double least(Position low, Position high, int mode) {
            double north = Math.max(high.y() - on.y(), on.y() - low.y());
            double up = Math.max(high.z() - on.z(), on.z() - low.z());
            return Math.hypot(north, up) <= radius ? 1.0 : 0.0;
        }
    }

    /** The longest routes could go round everything. */
    @Test
    void aLongDetourIsNotBounded() {
        BitSet start = block(0, 20);
        BitSet end = block(75, 95);
        ExposureField field = sensors();

        assertThat(new CorridorBound(problem(field, start, end), start, end, 100.0).exposure())
                .isZero();
        assertThat(new CorridorBound(problem(field, start, start), start, start, 0.0).exposure())
                .isZero();
    }
}
