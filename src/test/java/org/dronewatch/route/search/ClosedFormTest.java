package org.dronewatch.route.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.exposure.ExposureField;
import org.dronewatch.route.exposure.LegMotion;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Least exposures that are known in closed form, at a speed of 1 m/s. K/d: S. Megerian, F. Koushanfar, G. Qu, G.
 * Veltri, M. Potkonjak, Wireless Networks 8 (2002), lemma 1 and theorem 3, and the logarithmic spiral
 * {@code K sqrt(ln^2(r2/r1) + angle^2)}. K/d^2: inversion at the sensor, which makes exposure a length, gives
 * {@code K AB / (OA OB)}.
 */
class ClosedFormTest {
    private static final double PLANE = 0.02;
    private static final double SPACE = 0.05;
    private static final Position UP = new Position(0.0, 0.8, 0.6);

    private static RouteProblem problem(RouteGrid grid, ExposureField field, Position from, Position to) {
        BitSet start = new BitSet();
        start.set(grid.nearest(from));
        BitSet goal = new BitSet();
        goal.set(grid.nearest(to));
        assertThat(grid.position(grid.nearest(from)).distance(from)).isLessThan(1e-9);
        assertThat(grid.position(grid.nearest(to)).distance(to)).isLessThan(1e-9);
        return new RouteProblem(
                grid, field, List.of(RouteMode.free("flight", 1.0)), 0.0, PlanDirections.of(32), start, goal);
    }

    private static WeakestRoute solve(RouteProblem problem) {
        return WeakestRoutes.of(problem, problem.goals()).from(problem.starts()).orElseThrow();
    }

    private static void assertBracket(RouteProblem problem, double expected, double width) {
        WeakestRoute route = solve(problem);
        assertBracket(route.lower(), route.exposure(), expected, width);
    }

    private static void assertBracket(double lower, double upper, double expected, double width) {
        System.out.printf(
                Locale.ROOT,
                "ClosedFormTest: %.6f in %.6f to %.6f, %.2f %% wide%n",
                expected,
                lower,
                upper,
                100.0 * (upper / lower - 1.0));
        assertThat(expected).isBetween(lower, upper * (1.0 + 1e-9));
        assertThat(upper).isLessThan((1.0 + width) * lower);
    }

    private static Position at(double x, double y) {
        return new Position(x, y, 0.0);
    }

    /** The nodes of a rectangle. */
    private static RouteGrid rectangle(double west, double east, double south, double north, double spacing) {
        int columns = (int) Math.rint((east - west) / spacing) + 1;
        int rows = (int) Math.rint((north - south) / spacing) + 1;
        return RouteGrid.level(west, south, spacing, columns, rows, 0.0);
    }

    @Test
    void aQuarterCircle() {
        RouteGrid grid = rectangle(-0.2, 1.2, -0.2, 1.2, 0.00625);
        assertBracket(problem(grid, PointExposure.of(0, 0, 1), at(1, 0), at(0, 1)), Math.PI / 2, PLANE);
    }

    @Test
    void insideTheSquare() {
        RouteGrid grid = rectangle(-1.0, 1.0, -1.0, 1.0, 0.0125);
        double expected = 2.0 * Math.log(1.0 + Math.sqrt(2.0)) + Math.PI / 2;
        assertBracket(problem(grid, PointExposure.of(0, 0, 1), at(1, -1), at(-1, 1)), expected, PLANE);
    }

    @Test
    void aLogarithmicSpiral() {
        RouteGrid grid = rectangle(-0.2, 1.4, -0.2, 2.2, 0.0125);
        double expected = Math.hypot(Math.log(2.0), Math.PI / 2);
        assertBracket(problem(grid, PointExposure.of(0, 0, 1), at(1, 0), at(0, 2)), expected, PLANE);
    }

    @ParameterizedTest
    @CsvSource({"1, 1.3, 1.4142135623730951", "2, 2.2, 1.118033988749895"})
    void anArcThroughTheSensor(double far, double north, double expected) {
        RouteGrid grid = rectangle(-0.2, north, -0.2, north, 0.005 * Math.rint(north));
        assertBracket(problem(grid, PointExposure.of(0, 0, 2), at(1, 0), at(0, far)), expected, PLANE);
    }

    /**
     * K/d^2 on the unit circle over 90 degrees, with limited length L: the front is symmetric, (L, E) = (sqrt 2, pi /
     * sqrt 2), (pi/2, pi/2), (pi / sqrt 2, sqrt 2), since inversion at the circle exchanges the two. The first length
     * is that of the straight line: only an infinite price of time would enforce it, and the corridor is the bound.
     */
    @Thorough
    @ParameterizedTest
    @CsvSource({
        "1.4142135623730951, 2.221441469079183, 0.02, 0.02",
        "1.5707963267948966, 1.5707963267948966, 0.08, 0.02",
        "2.221441469079183, 1.4142135623730951, 0.08, 0.02"
    })
    void withLimitedLength(double length, double expected, double width, double fine) {
        RouteGrid grid = rectangle(-0.05, 1.25, -0.05, 1.25, LongForm.IS_ON ? 0.0025 : 0.0125);
        RouteProblem problem = problem(grid, PointExposure.of(0, 0, 2), at(1, 0), at(0, 1));
        WeakestRoute free = solve(problem);
        EnduranceLimit limit =
                new EnduranceLimit(problem, length, price -> WeakestRoutes.of(problem, problem.goals(), price));
        boolean isLong = length > 2.0;
        WeakestRoute limited =
                isLong ? free : limit.from(problem.starts(), free).orElseThrow();

        assertBracket(limited.lower(), limited.exposure(), expected, LongForm.IS_ON ? fine : width);
        assertThat(limit.allows(free)).isEqualTo(isLong);
        assertThat(limited.seconds()).isLessThanOrEqualTo(length);
        assertThat(limited.exposure()).isLessThan(1.002 * expected);
        assertThat(limited.lower()).isGreaterThan(isLong ? 0.0 : 1.02 * free.lower());
    }

    @Test
    void betweenTwoSensors() {
        RouteGrid grid = rectangle(-0.3, 0.3, -1.1, 1.1, 0.00625);
        ExposureField both =
                ExposureField.ofSensors(Map.of("east", PointExposure.of(1, 0, 2), "west", PointExposure.of(-1, 0, 2)));
        assertBracket(problem(grid, both, at(0, -1), at(0, 1)), Math.PI, PLANE);
    }

    /** The sensor that sees better decides alone: on the line between them, the integral of 1 / (1 + y^2). */
    @Test
    void pastTheNearerOfTwoSensors() {
        RouteGrid grid = rectangle(-0.3, 0.3, -1.1, 1.1, 0.00625);
        ExposureField nearer = new Nearer(PointExposure.of(1, 0, 2), PointExposure.of(-1, 0, 2));
        assertBracket(problem(grid, nearer, at(0, -1), at(0, 1)), Math.PI / 2, PLANE);
    }

    private record Nearer(ExposureField one, ExposureField other) implements ExposureField {
        @Override
        public double rate(double x, double y, double z, LegMotion motion, int mode) {
            return Math.max(one.rate(x, y, z, motion, mode), other.rate(x, y, z, motion, mode));
        }

        @Override
        public double least(Position low, Position high, int mode) {
            return Math.max(one.least(low, high, mode), other.least(low, high, mode));
        }
    }

    /**
     * K/d^2, from one side of the sensor to the other inside a disc of radius R: inversion at the unit circle turns the
     * rim into a circle of radius 1/R round which a string is drawn, {@code 2 sqrt(1 - 1/R^2) + (pi - 2 acos(1/R)) /
     * R}. Outside the disc, the rate is that of the place at which inversion at the rim puts a drone, times the scale
     * of this inversion, {@code K/R^2} everywhere: a way outside is as exposed as its mirror image inside. The northern
     * half is as good as the southern one. The long form has grids that are fine enough for the width of the bracket.
     */
    @ParameterizedTest
    @CsvSource({"2, 2.255650", "10, 2.010008"})
    void insideADisc(double radius, double stated) {
        assumeTrue(LongForm.IS_ON || radius < 10.0);
        double expected =
                2.0 * Math.sqrt(1.0 - 1.0 / (radius * radius)) + (Math.PI - 2.0 * Math.acos(1.0 / radius)) / radius;
        assertThat(expected).isCloseTo(stated, within(5e-7));
        double half = Math.min(6.0, radius + 0.1);
        RouteGrid grid = rectangle(-half, half, 0.0, radius + 0.1, LongForm.IS_ON ? 0.00625 : 0.025);
        ExposureField mirrored = new Mirrored(PointExposure.of(0, 0, 2), radius);
        double width = LongForm.IS_ON ? PLANE : 4.0 * PLANE;
        assertBracket(problem(grid, mirrored, at(1, 0), at(-1, 0)), expected, width);
    }

    private record Mirrored(PointExposure inside, double radius) implements ExposureField {
        @Override
        public double rate(double x, double y, double z, LegMotion motion, int mode) {
            return Math.max(inside.rate(x, y, z, motion, mode), 1.0 / (radius * radius));
        }

        @Override
        public double least(Position low, Position high, int mode) {
            return Math.max(inside.least(low, high, mode), 1.0 / (radius * radius));
        }
    }

    /** The nodes of a box about the origin's octant, with steps of one length. */
    private static RouteGrid box(double far, double top, double spacing) {
        int before = (int) Math.ceil(0.1 / spacing);
        int columns = (int) Math.rint(far / spacing) + before + 1;
        double[] heights = new double[(int) Math.rint(top / spacing) + before + 1];
        Arrays.setAll(heights, level -> (level - before) * spacing);
        return RouteGrid.level(-before * spacing, -before * spacing, spacing, columns, columns, heights);
    }

    /**
     * The plane of the circle and of the arc leans: 96 directions, which are those in plan, level or up or down by one
     * level. The long form has a grid that is fine enough for the width of the bracket.
     */
    @ParameterizedTest
    @CsvSource({"1, 1.5707963267948966, 0.015384615384615385", "2, 1.4142135623730951, 0.011764705882352941"})
    void aCurveInSpace(int power, double expected, double fine) {
        RouteGrid grid = box(1.25, 0.75, LongForm.IS_ON ? fine : 0.05);
        double width = LongForm.IS_ON ? SPACE : 4.0 * SPACE;
        assertBracket(problem(grid, PointExposure.of(0, 0, power), at(1, 0), UP), expected, width);
    }

    /** {@code d* = r_zone + v R = 660 m}: from 2000 m, E = K (1/660 - 1/2000) / v = 2.0303, and P = .8687. */
    @Test
    void onlyWhatIsInTimeCounts() {
        RouteGrid grid = rectangle(0.0, 2000.0, -200.0, 200.0, 10.0);
        BitSet start = new BitSet();
        start.set(grid.nearest(at(2000, 0)));
        BitSet goals = new BitSet();
        for (int node = 0; node < grid.size(); node++) {
            goals.set(node, grid.position(node).distance(at(0, 0)) <= 60.0);
        }
        ExposureField sensor = new PointExposure(at(0, 0), 40_000.0, 2);
        RouteProblem problem = new RouteProblem(
                grid, sensor, List.of(RouteMode.free("flight", 20.0)), 0.0, PlanDirections.of(32), start, goals);
        WeakestRoute route =
                WeakestRoutes.inTime(problem, goals, 30.0).from(start).orElseThrow();

        assertThat(route.exposure()).isCloseTo(2.0303, within(2e-2));
        assertThat(route.detection()).isCloseTo(0.8687, within(3e-3));
        assertThat(2.0303).isGreaterThan(route.lower());
        assertThat(route.seconds()).isCloseTo((2000.0 - 60.0) / 20.0, within(0.5));
    }

    /** Along straight lines: 2 asinh 1 for K/d, and sqrt 2 pi/2 for K/d^2. */
    @Test
    void straightLinesAreIntegrated() {
        RoutePath line = new RoutePath(List.of(at(1, 0), at(0, 1)), List.of(0));
        List<RouteMode> modes = List.of(RouteMode.free("flight", 1.0));

        assertThat(new RouteExposure(PointExposure.of(0, 0, 1), modes, 0.02).along(line))
                .isCloseTo(2.0 * Math.log(1.0 + Math.sqrt(2.0)), within(1e-9));
        assertThat(new RouteExposure(PointExposure.of(0, 0, 2), modes, 0.02).along(line))
                .isCloseTo(Math.sqrt(0.5) * Math.PI, within(1e-9));
    }

    /**
     * K/d^2 on the unit circle, by 90 degrees, with a limited length: E = pi/2 at L = pi/2. A price of time gives a
     * lower bound on it for any price, the best for the right one (weak duality).
     */
    @Test
    void aPriceOfTimeBoundsTheExposureOfShortRoutes() {
        RouteGrid grid = rectangle(-0.2, 1.2, -0.2, 1.2, 0.0125);
        double best = 0.0;
        for (double price = 0.0; price <= 2.0; price += 0.25) {
            ExposureField priced = PointExposure.of(0, 0, 2).plus(price);
            double lower = solve(problem(grid, priced, at(1, 0), at(0, 1))).lower();
            best = Math.max(best, lower - price * Math.PI / 2);
        }

        assertThat(best).isBetween(0.93 * Math.PI / 2, Math.PI / 2);
    }
}
