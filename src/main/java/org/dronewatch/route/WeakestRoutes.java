package org.dronewatch.route;

import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CancellationException;
import org.dronewatch.geometry.Position;

/**
 * The least exposed routes from anywhere to the goals. Searched over the posts of a grid, then smoothed: posts no
 * longer matter to the route that is found, whose exposure is integrated anew. Immutable and thread-safe.
 */
public final class WeakestRoutes {
    private final RouteProblem problem;
    private final RouteTree tree;
    private final Optional<RouteTree> onwards;
    private final ExposureBound bound;

    private WeakestRoutes(RouteProblem problem, RouteTree tree, Optional<RouteTree> onwards, ExposureBound bound) {
        this.problem = problem;
        this.tree = tree;
        this.onwards = onwards;
        this.bound = bound;
    }

    /**
     * Searches for routes to the goals.
     *
     * @param reached the posts of all cubes of the grid in which a route may end, for the lower bound: the goals
     *     themselves if routes end at a post
     * @throws CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public static WeakestRoutes of(RouteProblem problem, BitSet reached) {
        return new WeakestRoutes(
                problem, RouteSearch.toGoals(problem), Optional.empty(), ExposureBound.of(problem, reached));
    }

    /**
     * Searches for routes that are least exposed for as long as a detection is in time: until less than the time of a
     * response is left to the goals, even at full speed. From there on, the drone takes the fastest route, since a
     * detection comes too late, whatever the exposure.
     *
     * @param reached as above
     * @param response above 0, s
     * @throws CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public static WeakestRoutes inTime(RouteProblem problem, BitSet reached, double response) {
        RouteProblem fastest = problem.withField(new Clock());
        RouteTree times = RouteSearch.toGoals(fastest);
        BitSet tooLate = ExposureBound.of(fastest, reached).within(response);
        return new WeakestRoutes(
                problem,
                RouteSearch.toStates(problem, times, response),
                Optional.of(times),
                ExposureBound.of(problem, tooLate));
    }

    /** A field whose exposure is the time, s. */
    private record Clock() implements ExposureField {
        @Override
        public double rate(double x, double y, double z, double heading, int mode) {
            return 1.0;
        }

        @Override
        public double least(Position low, Position high, int mode) {
            return 1.0;
        }
    }

    /** The weakest of the routes from some posts; empty if none of them has a route. */
    public Optional<WeakestRoute> from(BitSet starts) {
        OptionalInt post = tree.weakest(starts);
        if (post.isEmpty()) {
            return Optional.empty();
        }
        List<Integer> states = tree.states(post.getAsInt());
        RouteExposure exposure = new RouteExposure(problem);
        RoutePath counted = RouteSmoothing.of(problem, tree.path(states));
        RoutePath whole = onwards.map(times -> counted.then(times.path(times.from(states.get(states.size() - 1)))))
                .orElse(counted);
        return Optional.of(new WeakestRoute(whole, exposure.along(counted), bound.from(starts), exposure.time(whole)));
    }

    /** The least exposure of a route over the posts alone, before it is smoothed; infinite without a route. */
    double overPosts(int post) {
        return tree.cost(post);
    }
}
