package org.dronewatch.route.search;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.route.exposure.ExposureField;
import org.dronewatch.route.exposure.LegMotion;

/**
 * The least exposed routes from anywhere to the goals. They are searched for over the nodes of a grid and then
 * smoothed: a smoothed route need not pass through nodes, and its exposure is integrated again. Immutable and
 * thread-safe.
 */
public final class WeakestRoutes {
    /**
     * The number of starts, those with the least exposure over the nodes, for which the exposures of the paths are
     * compared.
     */
    private static final int CANDIDATES = 64;

    /**
     * The number of these paths, the least exposed ones, that are smoothed, until one of them reaches the lower bound.
     */
    private static final int SMOOTHED = 8;

    /**
     * The least price of time, 1/s, so that of several equally exposed routes the fastest is found. Any route that is
     * missed because of it is less exposed by at most this price times the additional time that it takes: 3.6e-7 for an
     * hour, less than the 1e-6 by which the probability of a single look is capped. It is still a million times the
     * rounding error of an exposure of 1 per second of flight.
     */
    private static final double LEAST_PRICE = 1e-10;

    private final RouteProblem problem;

    /** The problem with the price of time. */
    private final RouteProblem priced;

    private final RouteTree tree;
    private final RouteFinish finish;
    private final Optional<RouteTree> onwards;
    private final ExposureBound bound;

    /** The nodes of all cubes in which what counts may end. */
    private final BitSet ends;

    /** Searches and computes the bound, in parallel if a thread is available. */
    private WeakestRoutes(
            RouteProblem problem,
            RouteProblem priced,
            Supplier<RouteTree> search,
            Optional<RouteTree> onwards,
            RouteFinish finish,
            BitSet ends) {
        this.problem = problem;
        this.priced = priced;
        this.onwards = onwards;
        this.finish = finish;
        this.ends = (BitSet) ends.clone();
        AtomicReference<RouteTree> found = new AtomicReference<>();
        AtomicReference<ExposureBound> certified = new AtomicReference<>();
        Workers.both(() -> found.set(search.get()), () -> certified.set(ExposureBound.of(problem, ends)));
        this.tree = found.get();
        this.bound = certified.get();
    }

    /**
     * Searches for routes to the goals; of several equally exposed routes, for the fastest.
     *
     * @param reached used for the lower bound: the corner nodes of every cube of the grid in which a route may end; if
     *     routes end at nodes, the goals themselves
     * @throws CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public static WeakestRoutes of(RouteProblem problem, BitSet reached) {
        return of(problem, reached, 0.0);
    }

    /**
     * Searches for routes to the goals as {@link #of(RouteProblem, BitSet)}, but time has a price, so that a route that
     * is hardly more exposed, but faster, is preferred.
     *
     * @param price what each second adds to the exposure in the search, but not to the exposure of the result, 0 or
     *     more, 1/s; less than 1e-10 counts as 1e-10
     */
    public static WeakestRoutes of(RouteProblem problem, BitSet reached, double price) {
        return of(problem, reached, price, RouteEnd.AT_NODE);
    }

    /**
     * Searches for routes to the goals as {@link #of(RouteProblem, BitSet, double)}, but a route may arrive between
     * nodes.
     *
     * @param arrival where on a leg a route arrives
     */
    public static WeakestRoutes of(RouteProblem problem, BitSet reached, double price, RouteEnd arrival) {
        RouteProblem priced = priced(problem, price);
        return new WeakestRoutes(
                problem,
                priced,
                () -> RouteSearch.toGoals(priced),
                Optional.empty(),
                new RouteFinish(problem.withField(new Clock()), arrival, 0.0),
                reached);
    }

    /**
     * Searches for routes that are least exposed for as long as a detection is in time, that is, until the goals are
     * less than the response time away even at full speed. From there on, the drone takes the fastest route, whatever
     * the exposure, since a detection would come too late.
     *
     * @param reached used for the lower bound: the corner nodes of every cube of the grid in which a route may end; if
     *     routes end at nodes, the goals themselves
     * @param response the response time, above 0, s
     * @throws CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public static WeakestRoutes inTime(RouteProblem problem, BitSet reached, double response) {
        return inTime(problem, reached, response, 0.0);
    }

    /**
     * Searches for routes as {@link #inTime(RouteProblem, BitSet, double)}, but time has a price.
     *
     * @param price what each second adds to the exposure in the search, but not to the exposure of the result, 0 or
     *     more, 1/s; less than 1e-10 counts as 1e-10
     */
    public static WeakestRoutes inTime(RouteProblem problem, BitSet reached, double response, double price) {
        return inTime(problem, reached, response, price, RouteEnd.AT_NODE);
    }

    /**
     * Searches for routes as {@link #inTime(RouteProblem, BitSet, double, double)}, but a route may arrive between
     * nodes.
     *
     * @param arrival where on a leg a route arrives
     */
    public static WeakestRoutes inTime(
            RouteProblem problem, BitSet reached, double response, double price, RouteEnd arrival) {
        RouteProblem fastest = problem.withField(new Clock());
        AtomicReference<RouteTree> times = new AtomicReference<>();
        AtomicReference<BitSet> tooLate = new AtomicReference<>();
        Workers.both(
                () -> times.set(RouteSearch.toGoals(fastest)),
                () -> tooLate.set(ExposureBound.of(fastest, reached).within(response)));
        RouteProblem priced = priced(problem, price);
        return new WeakestRoutes(
                problem,
                priced,
                () -> RouteSearch.toStates(priced, times.get(), response),
                Optional.of(times.get()),
                new RouteFinish(fastest, arrival, response),
                tooLate.get());
    }

    private static RouteProblem priced(RouteProblem problem, double price) {
        return problem.withField(problem.field().plus(Math.max(LEAST_PRICE, price)));
    }

    /** A field whose exposure is the time, s. */
    private record Clock() implements ExposureField {
        @Override
        public double rate(double x, double y, double z, LegMotion motion, int mode) {
            return 1.0;
        }

        @Override
        public double mean(Position from, Position to, LegMotion motion, int mode, double longest) {
            return 1.0;
        }

        @Override
        public double least(Position low, Position high, int mode) {
            return 1.0;
        }
    }

    /**
     * The weakest of the routes from some nodes, on the {@link Workers} of the calling thread; empty if no route leads
     * from any of these nodes.
     *
     * @throws CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public Optional<WeakestRoute> from(BitSet starts) {
        RouteExposure search = new RouteExposure(priced);
        // What the search adds up from node to node is not quite the exposure of a path, and smoothing gets further on
        // some paths than on others: the best of several is taken.
        List<List<Integer>> candidates = tree.weakest(starts, CANDIDATES).stream()
                .map(tree::states)
                .sorted(Comparator.comparingDouble(one -> search.along(tree.path(one))))
                .limit(SMOOTHED)
                .toList();
        double lower = bound.from(starts);
        Smoothed[] smoothed = new Smoothed[candidates.size()];
        int done = 0;
        boolean isLeast = false;
        while (done < smoothed.length && !isLeast) {
            int first = done;
            // Those that are smoothed together beyond the first that reaches the bound do not count.
            done = Math.min(smoothed.length, first + Workers.available());
            Workers.forEach(done - first, i -> smoothed[first + i] = smoothed(candidates.get(first + i), lower));
            for (int i = first; i < done; i++) {
                smoothed[i] = isLeast ? null : smoothed[i];
                isLeast |= smoothed[i] != null && smoothed[i].route().exposure() <= lower;
            }
        }
        return Arrays.stream(smoothed)
                .filter(Objects::nonNull)
                .min(Comparator.comparingDouble(Smoothed::priced))
                .map(Smoothed::route);
    }

    /**
     * A route that has been smoothed.
     *
     * @param route the route with its exposure
     * @param priced its exposure with the price of its time
     */
    private record Smoothed(WeakestRoute route, double priced) {}

    /** The route through some states, smoothed, and then to its end. */
    private Smoothed smoothed(List<Integer> states, double lower) {
        RoutePath path = tree.path(states);
        RoutePath rest = onwards.map(times -> times.path(times.from(states.get(states.size() - 1))))
                .orElseGet(() -> path.after(path));
        RoutePath whole = finish.of(RouteSmoothing.before(rest, priced, path).then(rest));
        return new Smoothed(described(whole, lower), new RouteExposure(priced).along(finish.counted(whole)));
    }

    /** The problem with the price of time. */
    RouteProblem priced() {
        return priced;
    }

    /** A path whose exposure counts, smoothed if it may turn anywhere, and the rest of the route to its end. */
    RoutePath whole(RoutePath path, RoutePath rest) {
        RoutePath head = problem.turnRadius() > 0.0 ? path : RouteSmoothing.of(priced, path);
        return finish.of(head.then(rest));
    }

    /**
     * A route to the same goals that another search has found, with its exposure in this search.
     *
     * @param lower a lower bound on the exposure along all routes from the same starts
     */
    public WeakestRoute described(RoutePath whole, double lower) {
        RouteExposure exposure = new RouteExposure(problem);
        return new WeakestRoute(whole, exposure.along(finish.counted(whole)), lower, exposure.time(whole));
    }

    /** The part of a route on which a detection counts. */
    public RoutePath counted(RoutePath route) {
        return finish.counted(route);
    }

    /** A certified lower bound on the sum of exposure and priced time along all routes. */
    ExposureBound pricedBound() {
        return ExposureBound.of(priced, ends);
    }

    /**
     * A certified lower bound on the exposure along all routes from some nodes that take no longer than a time; tight
     * only if that time is hardly longer than that along the straight line.
     *
     * @param seconds the longest time, s
     */
    double within(BitSet starts, double seconds) {
        double fastest =
                problem.modes().stream().mapToDouble(RouteMode::speed).max().orElseThrow();
        return new CorridorBound(problem, starts, ends, fastest * seconds).exposure();
    }

    /**
     * The least times to the goals: over the nodes or, if that is faster and the drone can turn on the spot, in a
     * straight line.
     */
    public TimeToGo timeToGo() {
        RouteTree fastest = onwards.orElseGet(() -> RouteSearch.toGoals(problem.withField(new Clock())));
        double[] least = new double[problem.grid().size()];
        Arrays.setAll(least, node -> finish.least(fastest, node));
        return new TimeToGo(problem.grid(), least);
    }

    /**
     * The least exposure, with the price of time, along a route from a node over the nodes of the grid, before the
     * route is smoothed; infinite if there is no route.
     */
    public double overNodes(int node) {
        return tree.cost(node);
    }
}
