package org.dronewatch.route.search;

import java.util.BitSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleFunction;
import org.dronewatch.geometry.Position;

/**
 * The weakest route of a drone that can fly under power only for a limited time. It is found by means of a price of
 * time, a Lagrange multiplier, which is raised until the route is short enough and then refined by bisection. If no
 * mode is a glide, the least sum of exposure and priced time at any price, less the price of the longest time allowed,
 * is a lower bound on the exposure along all routes that are short enough (the dual bound). Of several routes with the
 * same sum, those between the shortest and the least exposed are not found, so a gap may remain. Therefore routes that
 * take too long are also flown faster until they are short enough. Where the limit hardly allows a detour, the price
 * would have to be very high, and a bound on all routes within a narrow spheroid about the straight line is better. For
 * use by one thread at a time.
 */
public final class EnduranceLimit {
    /** At the first price, the whole of the time allowed counts as this exposure. */
    private static final double FIRST = 0.1;

    private static final double FACTOR = 4.0;
    private static final int MOST_RAISES = 14;
    private static final int BISECTIONS = 8;

    /** Of the searches that are kept, all but the latest have no more states than this: some 100 MB. */
    private static final long MOST_STATES = 8_000_000;

    private final RouteProblem problem;
    private final double seconds;
    private final DoubleFunction<WeakestRoutes> search;

    private final Map<Double, Priced> latest;

    /** The greatest of the dual bounds so far. */
    private double lower;

    /** The least exposed of the routes so far that are short enough. */
    private Optional<WeakestRoute> best = Optional.empty();

    /**
     * A limit.
     *
     * @param problem the problem without the limit
     * @param seconds longest flight under power, above 0, s
     * @param search gives the weakest routes for a price of time, 1/s
     */
    public EnduranceLimit(RouteProblem problem, double seconds, DoubleFunction<WeakestRoutes> search) {
        this.problem = problem;
        this.seconds = seconds;
        this.search = search;
        this.latest = new LinkedHashMap<>(16, 0.75F, true) {
            @Override
            protected boolean removeEldestEntry(Map.Entry<Double, Priced> eldest) {
                return size() > 1 && (long) size() * problem.states() > MOST_STATES;
            }
        };
    }

    /** Whether the time for which a route is flown under power is within the limit. */
    public boolean allows(WeakestRoute route) {
        return powered(route.path()) <= seconds;
    }

    private double powered(RoutePath path) {
        double sum = 0.0;
        for (int leg = 0; leg < path.modes().size(); leg++) {
            RouteMode mode = problem.modes().get(path.modes().get(leg));
            if (!mode.isGlide()) {
                Position from = path.points().get(leg);
                Position to = path.points().get(leg + 1);
                sum += mode.time(Math.hypot(to.x() - from.x(), to.y() - from.y()), to.z() - from.z());
            }
        }
        return sum;
    }

    /**
     * The weakest route within the limit; empty if none is found.
     *
     * @param starts nodes at which the route may begin
     * @param unlimited the weakest route without the limit
     */
    public Optional<WeakestRoute> from(BitSet starts, WeakestRoute unlimited) {
        lower = unlimited.lower();
        best = Optional.empty();
        double low = FIRST / (FACTOR * seconds);
        double high = FIRST / seconds;
        Priced first = at(high);
        if (isBounded()) {
            lower = Math.max(lower, first.routes().within(starts, seconds));
        }
        tryRoute(first.routes(), unlimited);
        boolean isShort = tryRoutes(first, starts);
        for (int raise = 0; !isShort && raise < MOST_RAISES; raise++) {
            low = high;
            high *= FACTOR;
            isShort = tryRoutes(at(high), starts);
        }
        for (int i = 0; isShort && i < BISECTIONS; i++) {
            double middle = Math.sqrt(low * high);
            if (tryRoutes(at(middle), starts)) {
                high = middle;
            } else {
                low = middle;
            }
        }
        return best.map(route ->
                new WeakestRoute(route.path(), route.exposure(), Math.min(lower, route.exposure()), route.seconds()));
    }

    /** The search at a price; those of the most recent prices are kept, since all starts begin with the same ones. */
    private Priced at(double price) {
        Priced known = latest.get(price);
        if (known != null) {
            return known;
        }
        WeakestRoutes routes = search.apply(price);
        Priced found = new Priced(price, routes, isBounded() ? Optional.of(routes.pricedBound()) : Optional.empty());
        latest.put(price, found);
        return found;
    }

    /** Tries the weakest route at a price; returns whether it is short enough without being hastened. */
    private boolean tryRoutes(Priced priced, BitSet starts) {
        priced.bound().ifPresent(bound -> lower = Math.max(lower, bound.from(starts) - priced.price() * seconds));
        Optional<WeakestRoute> found = priced.routes().from(starts);
        found.ifPresent(route -> tryRoute(priced.routes(), route));
        return found.filter(this::allows).isPresent();
    }

    /** Keeps a route, or the hastened one if it is too long, if it is less exposed than the best so far. */
    private void tryRoute(WeakestRoutes routes, WeakestRoute found) {
        WeakestRoute route =
                allows(found) ? found : routes.described(hastenedAtTheEnd(routes, found.path()), found.lower());
        if (allows(route) && (best.isEmpty() || route.exposure() < best.get().exposure())) {
            best = Optional.of(route);
        }
    }

    /**
     * A path sped up to take no longer than allowed, if the modes make that possible. The drone flies faster where this
     * costs the least exposure, whether a detection counts there or not.
     */
    public RoutePath hastened(RoutePath path) {
        double excess = powered(path) - seconds;
        return excess > 0.0 ? Hastening.of(problem, path, excess) : path;
    }

    /**
     * A path sped up to take no longer than allowed, as {@link #hastened}, but flown faster first where a detection
     * does not count, and only then elsewhere.
     *
     * @param routes the search, which determines where a detection counts
     */
    public RoutePath hastenedAtTheEnd(WeakestRoutes routes, RoutePath path) {
        double excess = powered(path) - seconds;
        if (!(excess > 0.0)) {
            return path;
        }
        RoutePath counted = routes.counted(path);
        RoutePath late = path.after(counted);
        RoutePath sooner = Hastening.of(problem, late, excess);
        double left = excess - (powered(late) - powered(sooner));
        return (left > 0.0 ? Hastening.of(problem, counted, left) : counted).then(sooner);
    }

    /**
     * A search at a price.
     *
     * @param price price of time, 1/s
     * @param routes the weakest routes at this price
     * @param bound the lower bound on the sum of exposure and priced time along all routes; empty where it does not
     *     help
     */
    private record Priced(double price, WeakestRoutes routes, Optional<ExposureBound> bound) {}

    /**
     * Whether the limit bounds the time of the whole flight: what is flown without power takes time as well, which a
     * limit on powered flight does not bound.
     */
    private boolean isBounded() {
        return problem.modes().stream().noneMatch(RouteMode::isGlide);
    }
}
