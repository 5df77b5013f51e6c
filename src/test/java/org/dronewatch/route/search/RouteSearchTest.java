package org.dronewatch.route.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.IntPredicate;
import org.dronewatch.Thorough;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.exposure.ExposureField;
import org.dronewatch.route.exposure.GaussRule;
import org.dronewatch.route.exposure.LegMotion;
import org.junit.jupiter.api.Test;

class RouteSearchTest {
    private static final RouteMode POWERED = new RouteMode("powered", 2.0, 0.5, 1.0, Double.POSITIVE_INFINITY);
    private static final RouteMode WINGED = new RouteMode("powered", 2.0, 0.5, 1.0, Double.POSITIVE_INFINITY, 1.25);
    private static final RouteMode SLOW = new RouteMode("slow", 0.75, 0.5, 1.0, Double.POSITIVE_INFINITY);
    private static final RouteMode GLIDE =
            new RouteMode("glide", 1.5, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, -0.25);

    /** The greatest number of modes of a problem. */
    private static final int MODES = 3;

    /** A rate for each node, direction and mode, a multiple of 1/64. */
    private record Table(RouteGrid grid, PlanDirections directions, int[] rates) implements ExposureField {
        static Table random(RouteGrid grid, PlanDirections directions, SplittableRandom random) {
            int[] rates = new int[MODES * directions.count() * grid.size()];
            Arrays.setAll(rates, i -> random.nextInt(4) == 0 ? 0 : random.nextInt(256));
            return new Table(grid, directions, rates);
        }

        /** A rate of 1/s everywhere: exposure is time. */
        static Table even(RouteGrid grid, PlanDirections directions) {
            int[] rates = new int[MODES * directions.count() * grid.size()];
            Arrays.fill(rates, 64);
            return new Table(grid, directions, rates);
        }

        double at(int node, int direction, int mode) {
            return rates[(mode * directions.count() + direction) * grid.size() + node] / 64.0;
        }

        @Override
        public double rate(double x, double y, double z, LegMotion motion, int mode) {
            int nearest = 0;
            double least = distance(0, motion.heading());
            for (int i = 1; i < directions.count(); i++) {
                double distance = distance(i, motion.heading());
                nearest = distance < least ? i : nearest;
                least = Math.min(distance, least);
            }
            return at(grid.nearest(new Position(x, y, z)), nearest, mode);
        }

        private double distance(int direction, double heading) {
            return Math.abs(Math.IEEEremainder(directions.heading(direction) - heading, 2.0 * Math.PI));
        }

        @Override
        public double least(Position low, Position high, int mode) {
            double least = Double.POSITIVE_INFINITY;
            for (int node = 0; node < grid.size(); node++) {
                Position at = grid.position(node);
                boolean isNear = Math.abs(at.x() - 0.5 * (low.x() + high.x())) < 2.0
                        && Math.abs(at.y() - 0.5 * (low.y() + high.y())) < 2.0;
                for (int direction = 0; isNear && direction < directions.count(); direction++) {
                    least = Math.min(least, at(node, direction, mode));
                }
            }
            return least;
        }
    }

    private static RouteGrid smallGrid(SplittableRandom random) {
        int columns = 2 + random.nextInt(3);
        int rows = 2 + random.nextInt(3);
        double[] heights = random.nextBoolean() ? new double[] {1.0} : new double[] {1.0, 1.5, 2.5};
        double[] ground = new double[columns * rows];
        Arrays.setAll(ground, i -> 0.25 * random.nextInt(3));
        BitSet closed = new BitSet();
        for (int node = 0; node < columns * rows * heights.length; node++) {
            closed.set(node, random.nextInt(6) == 0);
        }
        return new RouteGrid(0.0, 0.0, 1.0, columns, rows, heights, ground, closed);
    }

    private static RouteProblem smallProblem(SplittableRandom random) {
        RouteGrid grid = smallGrid(random);
        PlanDirections directions = PlanDirections.of(List.of(8, 16, 32, 48).get(random.nextInt(4)));
        double room = random.nextInt(3) == 0 ? 0.25 * (1 + random.nextInt(4)) : 0.0;
        RouteMode powered = room > 0.0 && random.nextBoolean() ? WINGED : POWERED;
        BitSet starts = new BitSet();
        BitSet goals = new BitSet();
        starts.set(random.nextInt(grid.size()));
        goals.set(random.nextInt(grid.size()));
        return new RouteProblem(
                grid,
                Table.random(grid, directions, random),
                modes(powered, room == 0.0 && random.nextBoolean(), random.nextBoolean()),
                room,
                directions,
                starts,
                goals);
    }

    private static List<RouteMode> modes(RouteMode powered, boolean isSlow, boolean isGliding) {
        List<RouteMode> modes = new ArrayList<>(List.of(powered));
        if (isSlow) {
            modes.add(SLOW);
        }
        if (isGliding) {
            modes.add(GLIDE);
        }
        return modes;
    }

    private static boolean isPowered(RouteProblem problem, int mode) {
        return problem.modes().get(mode) != GLIDE;
    }

    /** A leg between two states. */
    private record Leg(int from, int to, double cost) {}

    /** All legs that can be flown, from their definition: forwards, from every state in every direction. */
    private static List<Leg> legs(RouteProblem problem) {
        List<Leg> legs = new ArrayList<>();
        RouteGrid grid = problem.grid();
        int headings = problem.turnRadius() > 0.0 ? problem.directions().count() : 1;
        boolean[][] turns = turns(problem, headings);
        for (int mode = 0; mode < problem.modes().size(); mode++) {
            for (int heading = 0; heading < headings; heading++) {
                for (int node = 0; node < grid.size(); node++) {
                    int state = (mode * headings + heading) * grid.size() + node;
                    for (int other = 0;
                            isPowered(problem, mode) && other < problem.modes().size();
                            other++) {
                        legs.add(new Leg(state, state + (other - mode) * headings * grid.size(), 0.0));
                    }
                    if (headings == 1 && isPowered(problem, mode)) {
                        addVerticalLegs(legs, problem, mode, node);
                    }
                    for (int direction = 0; direction < problem.directions().count(); direction++) {
                        if (headings == 1 || direction == heading) {
                            addLegs(legs, problem, mode, node, direction, state, turns[direction]);
                        }
                    }
                }
            }
        }
        return legs;
    }

    /** Straight up and down, under power, with the mean of the rates at both nodes; the heading is north. */
    private static void addVerticalLegs(List<Leg> legs, RouteProblem problem, int mode, int node) {
        RouteGrid grid = problem.grid();
        int plane = grid.columns() * grid.rows();
        for (int to : new int[] {node - plane, node + plane}) {
            if (to >= 0 && to < grid.size() && grid.isOpen(node) && grid.isOpen(to)) {
                double rise = grid.z(to) - grid.z(node);
                Table field = (Table) problem.field();
                double rate = 0.5 * (field.at(node, 0, mode) + field.at(to, 0, mode));
                double fastest = problem.modes().get(mode).speed();
                double time = Math.abs(rise) / Math.min(fastest, rise > 0.0 ? 0.5 : 1.0);
                legs.add(new Leg(mode * grid.size() + node, mode * grid.size() + to, rate * time));
            }
        }
    }

    /** Whether each direction may be followed by each heading. */
    private static boolean[][] turns(RouteProblem problem, int headings) {
        boolean[][] turns = new boolean[problem.directions().count()][headings];
        for (int direction = 0; direction < turns.length; direction++) {
            for (int heading = 0; heading < headings; heading++) {
                turns[direction][heading] = headings == 1 || isTurnable(problem, direction, heading);
            }
        }
        return turns;
    }

    private static void addLegs(
            List<Leg> legs, RouteProblem problem, int mode, int node, int direction, int state, boolean... turns) {
        RouteGrid grid = problem.grid();
        PlanDirections directions = problem.directions();
        int column = node % grid.columns();
        int row = node / grid.columns() % grid.rows();
        int level = node / grid.columns() / grid.rows();
        double unit = Math.hypot(directions.east(direction), directions.north(direction));
        for (int climb = -1; climb <= 1; climb++) {
            if (level + climb < 0 || level + climb >= grid.levels()) {
                continue;
            }
            int repeats = repeats(problem, direction);
            if (isPowered(problem, mode) && climb != 0) {
                // At the least speed, the climb of 0.5 m/s and the descent of 1 m/s take this long a leg.
                double rise = Math.abs(grid.height(level + climb) - grid.height(level));
                double length = problem.modes().get(mode).slowest() * rise / (climb > 0 ? 0.5 : 1.0);
                double least = Math.sqrt(Math.max(0.0, length * length - rise * rise));
                repeats = Math.max(repeats, (int) Math.ceil(least / unit - 1e-9));
            }
            if (!isPowered(problem, mode) && climb == -1) {
                double drop = grid.height(level) - grid.height(level - 1);
                repeats = Math.max(repeats, (int) (drop * 4.0 / unit));
            }
            int toColumn = column + repeats * directions.east(direction);
            int toRow = row + repeats * directions.north(direction);
            if (toColumn < 0 || toRow < 0 || toColumn >= grid.columns() || toRow >= grid.rows()) {
                continue;
            }
            double cost = cost(problem, mode, node, grid.node(toColumn, toRow, level + climb), direction);
            if (!(cost < Double.POSITIVE_INFINITY)) {
                continue;
            }
            for (int heading = 0; heading < turns.length; heading++) {
                int to = (mode * turns.length + heading) * grid.size() + grid.node(toColumn, toRow, level + climb);
                if (turns[heading]) {
                    legs.add(new Leg(state, to, cost));
                }
            }
        }
    }

    /** A leg has room for a turn by half a right angle's knight's move, or into the next direction. */
    private static int repeats(RouteProblem problem, int direction) {
        double most = Math.max(Math.atan2(1.0, 2.0), problem.directions().widest());
        return (int) Math.max(1.0, Math.ceil(room(problem, most) / unit(problem, direction)));
    }

    private static double unit(RouteProblem problem, int direction) {
        return Math.hypot(
                problem.directions().east(direction), problem.directions().north(direction));
    }

    /** What a turn takes up of both legs together, m: nodes are 1 m apart. */
    private static double room(RouteProblem problem, double angle) {
        return 2.0 * problem.turnRadius() * Math.tan(0.5 * angle);
    }

    private static boolean isTurnable(RouteProblem problem, int from, int to) {
        double between = Math.abs(
                problem.directions().heading(from) - problem.directions().heading(to));
        double angle = Math.min(between, 2.0 * Math.PI - between);
        double shorter =
                Math.min(repeats(problem, from) * unit(problem, from), repeats(problem, to) * unit(problem, to));
        return room(problem, angle) <= shorter + 1e-9;
    }

    private static double cost(RouteProblem problem, int mode, int from, int to, int direction) {
        RouteGrid grid = problem.grid();
        int columns = grid.columns();
        int east = to % columns - from % columns;
        int north = to / columns % grid.rows() - from / columns % grid.rows();
        int pieces = Math.max(Math.abs(east), Math.abs(north));
        double rise = grid.z(to) - grid.z(from);
        double horizontal = Math.hypot(east, north);
        if (!isPowered(problem, mode) && rise > -0.25 * horizontal + 1e-9 * (horizontal + Math.abs(rise))) {
            return Double.POSITIVE_INFINITY;
        }
        double time = Math.hypot(horizontal, rise) / problem.modes().get(mode).speed();
        if (isPowered(problem, mode)) {
            time = Math.max(time, rise > 0.0 ? rise / 0.5 : -rise);
            if (Math.hypot(horizontal, rise) / time < problem.modes().get(mode).slowest() * (1.0 - 1e-9)) {
                return Double.POSITIVE_INFINITY;
            }
        }
        for (int i = 0; i <= pieces; i++) {
            int column = from % columns + (int) Math.floor((double) east * i / pieces + 0.5);
            int row = from / columns % grid.rows() + (int) Math.floor((double) north * i / pieces + 0.5);
            int level = (2 * i < pieces ? from : to) / columns / grid.rows();
            if (!grid.isOpen(grid.node(column, row, level))) {
                return Double.POSITIVE_INFINITY;
            }
        }
        int units = pieces
                / Math.max(
                        Math.abs(problem.directions().east(direction)),
                        Math.abs(problem.directions().north(direction)));
        double sum = 0.0;
        for (int unit = 0; unit < units; unit++) {
            double low = mean(problem, mode, direction, from, unit, from / columns / grid.rows());
            double high = mean(problem, mode, direction, from, unit, to / columns / grid.rows());
            sum += low + (high - low) * (unit + 0.5) / units;
        }
        return time * sum / units;
    }

    /** Along one of several shortest legs: the mean of rates between nodes, each a hat over the squares beside it. */
    private static double mean(RouteProblem problem, int mode, int direction, int from, int unit, int level) {
        RouteGrid grid = problem.grid();
        int east = problem.directions().east(direction);
        int north = problem.directions().north(direction);
        double x = from % grid.columns() + unit * east;
        double y = from / grid.columns() % grid.rows() + unit * north;
        // No piece of these passes from one square into another one.
        int pieces = 2 * Math.max(1, Math.abs(east)) * Math.max(1, Math.abs(north));
        double sum = 0.0;
        double weights = 0.0;
        for (int i = 0; i < pieces * GaussRule.POINTS; i++) {
            double share = (i / GaussRule.POINTS + GaussRule.at(i % GaussRule.POINTS)) / pieces;
            for (int column = 0; column < grid.columns(); column++) {
                double across = 1.0 - Math.abs(x + share * east - column);
                for (int row = 0; across > 0.0 && row < grid.rows(); row++) {
                    double hat = across * Math.max(0.0, 1.0 - Math.abs(y + share * north - row));
                    int node = grid.node(column, row, level);
                    double weight = grid.isOpen(node) ? GaussRule.weight(i % GaussRule.POINTS) * hat : 0.0;
                    sum += weight * ((Table) problem.field()).at(node, direction, mode);
                    weights += weight;
                }
            }
        }
        return sum / weights;
    }

    /** Bellman and Ford's algorithm: legs are tried until nothing changes. */
    private static double[] brute(RouteProblem problem) {
        return brute(
                problem, state -> problem.goals().get(state % problem.grid().size()));
    }

    /** The same to states that need not be goals. */
    private static double[] brute(RouteProblem problem, IntPredicate isEnd) {
        double[] cost = new double[problem.states()];
        Arrays.setAll(cost, state -> isEnd.test(state) ? 0.0 : Double.POSITIVE_INFINITY);
        List<Leg> legs = legs(problem);
        boolean isChanged = true;
        while (isChanged) {
            isChanged = false;
            for (Leg leg : legs) {
                double through = leg.cost() + cost[leg.to()];
                if (through < cost[leg.from()]) {
                    cost[leg.from()] = through;
                    isChanged = true;
                }
            }
        }
        return cost;
    }

    @Test
    void thousandRandomProblemsAgreeWithBruteForce() {
        long seed = 4711;
        SplittableRandom random = new SplittableRandom(seed);
        int reachable = 0;
        for (int i = 0; i < 1000; i++) {
            RouteProblem problem = smallProblem(random);
            double[] expected = brute(problem);
            reachable += compare(RouteSearch.toGoals(problem), expected, "seed " + seed + ", problem " + i);
        }
        assertThat(reachable).isGreaterThan(20_000);
    }

    /** Only exposure that leaves enough time for a response counts: up to states from which a goal is that near. */
    @Thorough
    @Test
    void soDoThousandInTime() {
        long seed = 4713;
        SplittableRandom random = new SplittableRandom(seed);
        int reachable = 0;
        for (int i = 0; i < 1000; i++) {
            RouteProblem problem = smallProblem(random);
            RouteProblem fastest = problem.withField(Table.even(problem.grid(), problem.directions()));
            // No time of a route is this one.
            double response = 0.25 * (1 + random.nextInt(8)) + 1e-3;
            double[] times = brute(fastest);
            double[] expected = brute(problem, state -> times[state] <= response);
            RouteTree found = RouteSearch.toStates(problem, RouteSearch.toGoals(fastest), response);
            reachable += compare(found, expected, "seed " + seed + ", problem " + i);
        }
        assertThat(reachable).isGreaterThan(20_000);
    }

    /** The number of states from which there is a route. */
    private static int compare(RouteTree found, double[] expected, String problem) {
        int reachable = 0;
        for (int state = 0; state < expected.length; state++) {
            double cost = found.costOfState(state);
            boolean isReachable = expected[state] < Double.POSITIVE_INFINITY;
            double tolerance = isReachable ? 1e-6 * (1.0 + expected[state]) : 0.0;
            // There are millions of states: only one that differs is worth the time of an assertion.
            if (cost != expected[state] && !(isReachable && Math.abs(cost - expected[state]) <= tolerance)) {
                assertThat(cost).as("%s, state %d", problem, state).isCloseTo(expected[state], within(tolerance));
            }
            reachable += isReachable ? 1 : 0;
        }
        return reachable;
    }

    @Thorough
    @Test
    void theBoundIsAboveNeitherTheRouteOverNodesNorTheSmoothedOne() {
        long seed = 4712;
        SplittableRandom random = new SplittableRandom(seed);
        int found = 0;
        for (int i = 0; i < 300; i++) {
            RouteProblem problem = smallProblem(random);
            WeakestRoutes routes = WeakestRoutes.of(problem, problem.goals());
            int start = problem.starts().nextSetBit(0);
            if (routes.from(problem.starts()).isEmpty()) {
                continue;
            }
            found++;
            WeakestRoute route = routes.from(problem.starts()).get();
            assertThat(route.lower())
                    .as("seed %d, problem %d", seed, i)
                    .isLessThanOrEqualTo(routes.overNodes(start))
                    .isLessThanOrEqualTo(route.exposure());
        }
        assertThat(found).isGreaterThan(100);
    }
}
