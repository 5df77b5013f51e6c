package org.dronewatch.route.search;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.dronewatch.LongForm;
import org.dronewatch.geometry.Position;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Random routes past a point sensor are joined at the best of all pairs of corners. */
class RouteJunctionTest {
    private static final double SPACING = 10.0;
    private static final double LONGEST = 10.0 * SPACING;

    @ParameterizedTest
    @ValueSource(doubles = {0.0, 8.0})
    void noOtherPairOfCornersIsBetter(double turnRadius) {
        long seed = LongForm.seed(41);
        SplittableRandom random = new SplittableRandom(seed);
        RouteProblem problem = problem(turnRadius);
        RouteExposure exposure = new RouteExposure(problem);
        int joined = 0;
        for (int i = 0; i < 300; i++) {
            RoutePath own = path(random, 2 + random.nextInt(5));
            RoutePath other = path(random, 2 + random.nextInt(9));
            double least = Math.min(exposure.along(own), leastJoined(own, other, exposure, turnRadius));

            Optional<RoutePath> found = new RouteJunction(problem).best(own, other);

            String which = "seed " + seed + ", case " + i;
            double result = found.map(exposure::along).orElse(exposure.along(own));
            assertThat(result).as(which).isCloseTo(least, within(1e-9 * least));
            if (found.isPresent()) {
                RoutePath path = found.get();
                assertThat(path.points().get(0))
                        .as(which)
                        .isEqualTo(own.points().get(0));
                assertThat(last(path)).as(which).isEqualTo(last(other));
                joined++;
            }
        }
        assertThat(joined).isBetween(100, 290);
    }

    private static Position last(RoutePath path) {
        return path.points().get(path.points().size() - 1);
    }

    private static double leastJoined(RoutePath own, RoutePath other, RouteExposure exposure, double turnRadius) {
        double least = Double.POSITIVE_INFINITY;
        for (int from = 0; from < own.points().size(); from++) {
            for (int to = 0; to < other.points().size() - 1; to++) {
                double length = own.points().get(from).distance(other.points().get(to));
                List<Position> points = new ArrayList<>(own.points().subList(0, from + 1));
                points.addAll(other.points().subList(to, other.points().size()));
                boolean canTurn =
                        (from == 0 || canTurn(points, from, turnRadius)) && canTurn(points, from + 1, turnRadius);
                if (length <= LONGEST && canTurn) {
                    RoutePath joined = new RoutePath(points, Collections.nCopies(points.size() - 1, 0));
                    least = Math.min(least, exposure.along(joined));
                }
            }
        }
        return least;
    }

    /** Whether an arc with the radius fits between the middles of the legs at a corner. */
    private static boolean canTurn(List<Position> points, int corner, double radius) {
        Position in = points.get(corner).minus(points.get(corner - 1));
        Position out = points.get(corner + 1).minus(points.get(corner));
        double first = Math.hypot(in.x(), in.y());
        double second = Math.hypot(out.x(), out.y());
        double cosine = (in.x() * out.x() + in.y() * out.y()) / (first * second);
        double angle = Math.acos(Math.max(-1.0, Math.min(1.0, cosine)));
        return radius * Math.tan(angle / 2.0) <= Math.min(first, second) / 2.0 + 1e-6;
    }

    private static RouteProblem problem(double turnRadius) {
        RouteGrid grid = RouteGrid.level(0.0, 0.0, SPACING, 21, 21, 0.0);
        BitSet all = new BitSet();
        all.set(0, grid.size());
        return new RouteProblem(
                grid,
                PointExposure.of(101.0, 99.0, 2),
                List.of(RouteMode.free("flight", 1.0)),
                turnRadius,
                PlanDirections.of(16),
                all,
                all);
    }

    private static RoutePath path(SplittableRandom random, int points) {
        List<Position> path = new ArrayList<>();
        for (int i = 0; i < points; i++) {
            path.add(new Position(random.nextDouble(0.0, 200.0), random.nextDouble(0.0, 200.0), 0.0));
        }
        return new RoutePath(path, Collections.nCopies(points - 1, 0));
    }
}
