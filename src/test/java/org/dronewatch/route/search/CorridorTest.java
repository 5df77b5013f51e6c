package org.dronewatch.route.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.dronewatch.geometry.Position;
import org.dronewatch.placement.Candidate;
import org.dronewatch.placement.PlacementConditions;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.solver.CutResult;
import org.dronewatch.placement.solver.CuttingPlanes;
import org.dronewatch.placement.solver.ExactSolver;
import org.dronewatch.placement.solver.Relaxation;
import org.dronewatch.route.exposure.ExposureField;
import org.dronewatch.route.exposure.LegMotion;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Sensors along a corridor, each of which adds an exposure to whoever flies through one cell: with B sensors in a
 * corridor of W cells, the weakest route has an exposure of at most e floor(B/W), that of a column with so few; and so
 * many whole rows give it. E. Israeli and R. K. Wood, Networks 40 (2002). The routes are found by the search.
 */
class CorridorTest {
    private static final double SPACING = 0.5;

    /** The exposure per metre in the cells of some sensors, for a drone that flies at 1 m/s. */
    private record Cells(int width, int depth, double rate, BitSet watched) implements ExposureField {
        @Override
        public double rate(double x, double y, double z, LegMotion motion, int mode) {
            return rate(x, y);
        }

        private double rate(double x, double y) {
            boolean isInside = x >= 0.0 && x < width && y >= 0.0 && y < depth;
            return isInside && watched.get((int) x + width * (int) y) ? rate : 0.0;
        }

        @Override
        public double least(Position low, Position high, int mode) {
            double least = rate;
            for (double x = low.x(); x <= high.x(); x += SPACING) {
                for (double y = low.y(); y <= high.y(); y += SPACING) {
                    least = Math.min(least, rate(x, y));
                }
            }
            return least;
        }
    }

    @ParameterizedTest
    @CsvSource({"5, 12, 0.7, 1.4, 1.68", "3, 7, 1, 2, 2.33333333333", "4, 8, 0.3, 0.6, 0.6", "4, 3, 1, 0, 0.75"})
    void asManyWholeRowsAsThereAreSensorsFor(int width, int number, double exposure, double most, double relaxed) {
        int depth = number / width + 1;
        RouteGrid grid = RouteGrid.level(
                0.5 * SPACING,
                -1.0 + 0.5 * SPACING,
                SPACING,
                (int) (width / SPACING),
                (int) ((depth + 2) / SPACING),
                0.0);
        RouteProblem problem = new RouteProblem(
                grid,
                new Cells(width, depth, exposure, new BitSet()),
                List.of(RouteMode.free("flight", 1.0)),
                0.0,
                PlanDirections.of(32),
                row(grid, 0),
                row(grid, grid.rows() - 1));
        List<Candidate> cells = IntStream.range(0, width * depth)
                .mapToObj(cell -> new Candidate("cell " + cell, 1.0))
                .toList();
        // In any order, so that the first layouts are not whole rows by chance.
        List<Integer> order =
                new ArrayList<>(IntStream.range(0, width * depth).boxed().toList());
        Collections.shuffle(order, new Random(width));
        CutResult found = new CuttingPlanes(
                        cells,
                        PlacementConditions.NONE.withBudget(number),
                        chosen -> routes(problem, order, chosen, width, depth, exposure),
                        new ExactSolver(),
                        1e3)
                .solve(SolverLimits.NONE.withGap(0.001), round -> {})
                .orElseThrow();

        assertThat(found.result().complete()).isTrue();
        assertThat(found.result().value()).isCloseTo(most, within(1e-9));
        assertThat(found.result().bound()).isBetween(most - 1e-9, 1.001 * most + 1e-9);
        assertThat(found.result().cost()).isLessThanOrEqualTo(number);
        assertThat(found.rounds()).isBetween(1, 60);
        // In parts, the sensors give e B / W on every route that was found; the relaxation approaches it from above.
        assertThat(Relaxation.of(found.problem())).isBetween(relaxed - 1e-9, 1.02 * relaxed);
        // The bound of the search itself holds, too: no route is less exposed than that.
        double lower = past(problem, cells(order, found.result().chosen()), width, depth, exposure)
                .from(problem.starts())
                .orElseThrow()
                .lower();
        assertThat(lower).isBetween(0.45 * most, most + 1e-9);
    }

    private static BitSet row(RouteGrid grid, int row) {
        BitSet nodes = new BitSet();
        nodes.set(row * grid.columns(), (row + 1) * grid.columns());
        return nodes;
    }

    private static WeakestRoutes past(
            RouteProblem problem, List<Integer> chosen, int width, int depth, double exposure) {
        BitSet watched = new BitSet();
        chosen.forEach(watched::set);
        RouteProblem watchedBy = problem.withField(new Cells(width, depth, exposure, watched));
        return WeakestRoutes.of(watchedBy, problem.goals(), 1e-4);
    }

    private static List<Integer> cells(List<Integer> order, List<Integer> chosen) {
        return chosen.stream().map(order::get).toList();
    }

    /** The weakest route from each start, by the exposure to each sensor alone. */
    private static List<double[]> routes(
            RouteProblem problem, List<Integer> order, List<Integer> chosen, int width, int depth, double exposure) {
        WeakestRoutes routes = past(problem, cells(order, chosen), width, depth, exposure);
        List<double[]> rows = new ArrayList<>();
        problem.starts().stream().forEach(start -> {
            BitSet one = new BitSet();
            one.set(start);
            RoutePath path = routes.from(one).orElseThrow().path();
            rows.add(order.stream()
                    .mapToDouble(cell -> exposure * inside(path, cell % width, cell / width))
                    .toArray());
        });
        return rows;
    }

    /** The length of a path inside a cell of 1 m: the part of each leg between its four sides. */
    private static double inside(RoutePath path, int west, int south) {
        double length = 0.0;
        for (int leg = 0; leg < path.modes().size(); leg++) {
            Position from = path.points().get(leg);
            Position along = path.points().get(leg + 1).minus(from);
            double[] first = part(from.x(), along.x(), west);
            double[] second = part(from.y(), along.y(), south);
            double enters = Math.max(first[0], second[0]);
            double leaves = Math.min(first[1], second[1]);
            length += Math.hypot(along.x(), along.y()) * Math.max(0.0, leaves - enters);
        }
        return length;
    }

    /** Between which fractions of a leg a coordinate is in the interval of 1 m from a limit. */
    private static double[] part(double from, double along, double limit) {
        if (along == 0.0) {
            boolean isInside = from >= limit && from < limit + 1.0;
            return isInside ? new double[] {0.0, 1.0} : new double[] {1.0, 0.0};
        }
        double one = (limit - from) / along;
        double other = (limit + 1.0 - from) / along;
        return new double[] {Math.max(0.0, Math.min(one, other)), Math.min(1.0, Math.max(one, other))};
    }
}
